#define LOBE_ARRAYS 1
#include "../lobe.h"
#include "../sg_diffuse.h"

void lobe_sg_diffuse_high_n_f32(const float *n_dot_l, const float *versine, float *irradiance, size_t n)
{
    size_t i;
    for (i = 0; i < n; i++)
        irradiance[i] = lobe_sg_diffuse_high(n_dot_l[i], versine[i]);
}
