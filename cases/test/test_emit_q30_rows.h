/* The q30 tiers that have a formula, and how near to it in double they must be: 2^-20 low, 2^-18 medium and high. */
#ifndef LOBE_TEST_EMIT_Q30_ROWS_H
#define LOBE_TEST_EMIT_Q30_ROWS_H
#include "../../models/lobe.h"

typedef struct row {
    const char *model, *tier;
    lobe_dfg_q30 (*pair)(int32_t, int32_t);
    int32_t (*one)(int32_t, int32_t);
    double bound;
} row;

#define LOW 9.5367431640625e-07
#define MEDIUM 3.814697265625e-06

/* LOBE_TEST_TRY: the formulas of emit_kernels.h instead of those that ship. */
#if defined(LOBE_TEST_TRY)
lobe_dfg_q30 lobe_try_medium_q30(int32_t roughness, int32_t n_dot_v);
lobe_dfg_q30 lobe_try_high_q30(int32_t roughness, int32_t n_dot_v);
int32_t lobe_try_inverse_q30(int32_t roughness, int32_t n_dot_v);
static const row rows[] = {
    {"try", "medium", lobe_try_medium_q30, 0, MEDIUM},
    {"try", "high", lobe_try_high_q30, 0, MEDIUM},
    {"try", "inverse", 0, lobe_try_inverse_q30, LOW},
};
#else
#define split_sum(tier, bound) {"split_sum", #tier, lobe_split_sum_##tier##_q30, 0, bound},
#define split_sum_sep(tier, bound) {"split_sum_sep", #tier, lobe_split_sum_sep_##tier##_q30, 0, bound},
#define energy(tier, bound) {"energy", #tier, 0, lobe_energy_##tier##_q30, bound},
static const row rows[] = {
#include "emitted_rows.h" /* from the files in models/q30 */
};
#endif

#endif
