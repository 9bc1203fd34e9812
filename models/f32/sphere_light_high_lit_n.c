#define LOBE_ARRAYS 1
#include "../sphere_light_high.h"
#include "sphere_light_entry.h"

void lobe_sphere_light_high_lit_n_f32(const float *roughness, const float *n_dot_v, const float *n_dot_l,
                                      const float *tangent2, const float *sine, float *radiance, float *schlick,
                                      size_t n)
{
    size_t i;
    for (i = 0; i < n; i++) {
        const lobe_sphere_lit lit =
            lobe_sphere_light_high_lit(roughness[i], lobe_sphere_of(n_dot_v[i], n_dot_l[i], tangent2[i], sine[i]));
        radiance[i] = lit.radiance;
        schlick[i] = lit.schlick;
    }
}
