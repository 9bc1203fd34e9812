#include "../diffuse_zonal.h"
#include "../lobe.h"

lobe_zonal_f32 lobe_diffuse_zonal_low_f32(float roughness, float n_dot_v)
{
    const lobe_zonal_lobe z = lobe_diffuse_zonal_low(roughness, n_dot_v);
    lobe_zonal_f32 out;
    out.z0 = z.z0;
    out.z1 = z.z1;
    out.z2 = z.z2;
    out.along_normal = z.along_n;
    out.along_view = z.along_view;
    return out;
}
