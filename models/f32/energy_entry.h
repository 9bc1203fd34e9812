/* The public f32 functions of one energy kernel, E or 1/E: at one point; and over arrays, in a loop that compilers
 * vectorise, in an object of its own, compiled with LOBE_ARRAYS. */
#ifndef LOBE_ENERGY_ENTRY_H
#define LOBE_ENERGY_ENTRY_H
#include "../lobe.h"

#define LOBE_ENERGY_F32(name)                                                                                          \
    float name##_f32(float roughness, float n_dot_v) { return name(roughness, n_dot_v); }

#define LOBE_ENERGY_N_F32(name)                                                                                        \
    void name##_n_f32(const float *roughness, const float *n_dot_v, float *out, size_t n)                              \
    {                                                                                                                  \
        size_t i;                                                                                                      \
        for (i = 0; i < n; i++)                                                                                        \
            out[i] = name(roughness[i], n_dot_v[i]);                                                                   \
    }

#endif
