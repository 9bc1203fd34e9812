/* The public f32 functions of a kernel that gives nine coefficients: at one point, and over arrays. */
#ifndef LOBE_SH9_ENTRY_H
#define LOBE_SH9_ENTRY_H
#include "../lobe.h"
#include "../sh9.h"

LOBE_FN lobe_sh9 lobe_sh9_in(const lobe_sh9_f32 *a)
{
    return lobe_sh9_of(a->c[0], a->c[1], a->c[2], a->c[3], a->c[4], a->c[5], a->c[6], a->c[7], a->c[8]);
}

LOBE_FN lobe_sh9_f32 lobe_sh9_out(lobe_sh9 a)
{
    lobe_sh9_f32 out;
    out.c[0] = a.c0;
    out.c[1] = a.c1;
    out.c[2] = a.c2;
    out.c[3] = a.c3;
    out.c[4] = a.c4;
    out.c[5] = a.c5;
    out.c[6] = a.c6;
    out.c[7] = a.c7;
    out.c[8] = a.c8;
    return out;
}

#define LOBE_SH9_F32(name)                                                                                             \
    lobe_sh9_f32 name##_f32(float roughness, float n_dot_v) { return lobe_sh9_out(name(roughness, n_dot_v)); }         \
    void name##_n_f32(const float *roughness, const float *n_dot_v, float *const c[9], size_t n)                       \
    {                                                                                                                  \
        float *const c0 = c[0], *const c1 = c[1], *const c2 = c[2], *const c3 = c[3], *const c4 = c[4];                \
        float *const c5 = c[5], *const c6 = c[6], *const c7 = c[7], *const c8 = c[8];                                  \
        size_t i;                                                                                                      \
        for (i = 0; i < n; i++) {                                                                                      \
            const lobe_sh9 a = name(roughness[i], n_dot_v[i]);                                                         \
            c0[i] = a.c0;                                                                                              \
            c1[i] = a.c1;                                                                                              \
            c2[i] = a.c2;                                                                                              \
            c3[i] = a.c3;                                                                                              \
            c4[i] = a.c4;                                                                                              \
            c5[i] = a.c5;                                                                                              \
            c6[i] = a.c6;                                                                                              \
            c7[i] = a.c7;                                                                                              \
            c8[i] = a.c8;                                                                                              \
        }                                                                                                              \
    }

#endif
