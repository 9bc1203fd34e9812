#include "../sphere_light_high.h"
#include "sphere_light_entry.h"

lobe_sphere_lit_f32 lobe_sphere_light_high_lit_f32(float roughness, lobe_sphere_f32 light)
{
    const lobe_sphere_lit lit = lobe_sphere_light_high_lit(roughness, lobe_sphere_in(light));
    lobe_sphere_lit_f32 y;
    y.radiance = lit.radiance;
    y.schlick = lit.schlick;
    return y;
}
