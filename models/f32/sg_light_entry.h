/* The public f32 functions of the kernel of a spherical Gaussian light: at one point; and over arrays, in a loop that
 * compilers vectorise, in an object of its own, compiled with LOBE_ARRAYS. */
#ifndef LOBE_SG_LIGHT_ENTRY_H
#define LOBE_SG_LIGHT_ENTRY_H
#include "../lobe.h"

LOBE_FN lobe_sg lobe_sg_in(lobe_sg_f32 a) { return lobe_sg_of(a.n_dot_v, a.n_dot_l, a.tangent2, a.versine); }

#define LOBE_SG_LIGHT_F32(name)                                                                                        \
    float name##_f32(float roughness, lobe_sg_f32 light) { return name(roughness, lobe_sg_in(light)); }

#define LOBE_SG_LIGHT_N_F32(name)                                                                                      \
    void name##_n_f32(const float *roughness, const float *n_dot_v, const float *n_dot_l, const float *tangent2,       \
                      const float *versine, float *radiance, size_t n)                                                 \
    {                                                                                                                  \
        size_t i;                                                                                                      \
        for (i = 0; i < n; i++)                                                                                        \
            radiance[i] = name(roughness[i], lobe_sg_of(n_dot_v[i], n_dot_l[i], tangent2[i], versine[i]));             \
    }

#endif
