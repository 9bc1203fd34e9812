/* The public f32 functions of a kernel of sphere_diffuse: at one point; and over arrays, in a loop that compilers
 * vectorise, in an object of its own, compiled with LOBE_ARRAYS. */
#ifndef LOBE_SPHERE_DIFFUSE_ENTRY_H
#define LOBE_SPHERE_DIFFUSE_ENTRY_H
#include "../lobe.h"
#include "../sphere_diffuse.h"

#define LOBE_SPHERE_DIFFUSE_F32(name)                                                                                  \
    float name##_f32(float n_dot_l, float sine) { return name(n_dot_l, sine); }

#define LOBE_SPHERE_DIFFUSE_N_F32(name)                                                                                \
    void name##_n_f32(const float *n_dot_l, const float *sine, float *irradiance, size_t n)                            \
    {                                                                                                                  \
        size_t i;                                                                                                      \
        for (i = 0; i < n; i++)                                                                                        \
            irradiance[i] = name(n_dot_l[i], sine[i]);                                                                 \
    }

#endif
