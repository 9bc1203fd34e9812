/* The public f32 functions of a split-sum tier: the kernel at one point; and over arrays, in a loop that compilers
 * vectorise, in an object of its own, compiled with LOBE_ARRAYS. */
#ifndef LOBE_F32_ENTRY_H
#define LOBE_F32_ENTRY_H
#include "../lobe.h"

#define LOBE_DFG_F32(model)                                                                                            \
    lobe_dfg_f32 model##_f32(float roughness, float n_dot_v)                                                           \
    {                                                                                                                  \
        const lobe_dfg d = model(roughness, n_dot_v);                                                                  \
        lobe_dfg_f32 out;                                                                                              \
        out.scale = d.scale;                                                                                           \
        out.bias = d.bias;                                                                                             \
        return out;                                                                                                    \
    }

#define LOBE_DFG_N_F32(model)                                                                                          \
    void model##_n_f32(const float *roughness, const float *n_dot_v, float *scale, float *bias, size_t n)              \
    {                                                                                                                  \
        size_t i;                                                                                                      \
        for (i = 0; i < n; i++) {                                                                                      \
            const lobe_dfg d = model(roughness[i], n_dot_v[i]);                                                        \
            scale[i] = d.scale;                                                                                        \
            bias[i] = d.bias;                                                                                          \
        }                                                                                                              \
    }

#endif
