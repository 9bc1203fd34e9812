/* The q30 tiers that have a formula, and how near to it in double they must be: 2^-20 low, 2^-18 medium and high. */
#ifndef LOBE_TEST_EMIT_Q30_ROWS_H
#define LOBE_TEST_EMIT_Q30_ROWS_H
#include "../../models/lobe.h"
#include "../../models/q30/diffuse_sh.h"

typedef struct row {
    const char *model, *tier;
    void (*call)(int32_t roughness, int32_t n_dot_v, int32_t *out);
    double bound;
} row;

#define CALL_DFG(f)                                                                                                    \
    static void at_##f(int32_t r, int32_t v, int32_t *out)                                                             \
    {                                                                                                                  \
        const lobe_dfg_q30 d = f(r, v);                                                                                \
        out[0] = d.scale;                                                                                              \
        out[1] = d.bias;                                                                                               \
    }
#define CALL_ONE(f)                                                                                                    \
    static void at_##f(int32_t r, int32_t v, int32_t *out) { out[0] = f(r, v); }
#define CALL_SHAPE(f)                                                                                                  \
    static void at_##f(int32_t r, int32_t v, int32_t *out)                                                             \
    {                                                                                                                  \
        const lobe_diffuse_shape_q30 s = f(r, v);                                                                      \
        out[0] = s.c00;                                                                                                \
        out[1] = s.c1n;                                                                                                \
        out[2] = s.c1t;                                                                                                \
        out[3] = s.c2n;                                                                                                \
        out[4] = s.c2t;                                                                                                \
        out[5] = s.c2tt;                                                                                               \
    }
#define CALL_ZONAL(f)                                                                                                  \
    static void at_##f(int32_t r, int32_t v, int32_t *out)                                                             \
    {                                                                                                                  \
        const lobe_zonal_shape_q30 s = f(r, v);                                                                        \
        out[0] = s.z0;                                                                                                 \
        out[1] = s.z1;                                                                                                 \
        out[2] = s.z2;                                                                                                 \
        out[3] = s.beta;                                                                                               \
    }

#define LOW 9.5367431640625e-07
#define MEDIUM 3.814697265625e-06

/* LOBE_TEST_TRY: the formulas of emit_kernels.h instead of those that ship. */
#if defined(LOBE_TEST_TRY)
lobe_dfg_q30 lobe_try_medium_q30(int32_t roughness, int32_t n_dot_v);
lobe_dfg_q30 lobe_try_high_q30(int32_t roughness, int32_t n_dot_v);
int32_t lobe_try_inverse_q30(int32_t roughness, int32_t n_dot_v);
CALL_DFG(lobe_try_medium_q30)
CALL_DFG(lobe_try_high_q30)
CALL_ONE(lobe_try_inverse_q30)
static const row rows[] = {
    {"try", "medium", at_lobe_try_medium_q30, MEDIUM},
    {"try", "high", at_lobe_try_high_q30, MEDIUM},
    {"try", "inverse", at_lobe_try_inverse_q30, LOW},
};
#else
/* Two readings of the files in models/q30; what is emitted of diffuse_sh is its shape. */
#define split_sum(tier, bound) CALL_DFG(lobe_split_sum_##tier##_q30)
#define split_sum_sep(tier, bound) CALL_DFG(lobe_split_sum_sep_##tier##_q30)
#define energy(tier, bound) CALL_ONE(lobe_energy_##tier##_q30)
#define diffuse_sh(tier, bound) CALL_##tier(lobe_diffuse_shape_##tier##_q30)
#define CALL_exact CALL_SHAPE
#define CALL_medium CALL_SHAPE
#define CALL_low CALL_SHAPE
#define CALL_zonal CALL_ZONAL
#define CALL_zonal_low CALL_ZONAL
#include "emitted_rows.h"
#undef split_sum
#undef split_sum_sep
#undef energy
#undef diffuse_sh
#define split_sum(tier, bound) {"split_sum", #tier, at_lobe_split_sum_##tier##_q30, bound},
#define split_sum_sep(tier, bound) {"split_sum_sep", #tier, at_lobe_split_sum_sep_##tier##_q30, bound},
#define energy(tier, bound) {"energy", #tier, at_lobe_energy_##tier##_q30, bound},
#define diffuse_sh(tier, bound) {"diffuse_shape", #tier, at_lobe_diffuse_shape_##tier##_q30, bound},
static const row rows[] = {
#include "emitted_rows.h"
};
#endif

#endif
