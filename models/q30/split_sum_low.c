/* Generated, not edited: lobefit emit split_sum --tier low --to q30
 * Digest of the formula with its coefficients: 03495a9a358f6f77 (FNV-1a 64 of `lobefit emit --to c`).
 *
 * split_sum, low, in 32-bit integers: inputs Q30, held at [0, 1]; results Q30 in [0, 1]. Each local's scale
 * stands beside it. Every product and shift rounds to nearest, ties up.
 * Difference to the same formula in double over [.02, 1], 1024 x 1024 points:
 *   6.15e-09 (2^-27.3) in bias at 0x05539255 0x02d0102d: got 0x317a32a3, want 0.773083355646.
 * Difference to the same formula in double over [0, 1], 511 x 511 points, uniform in the logarithm:
 *   6.74e-09 (2^-27.1) in scale at 0x0a5a5a5a 0x0000003a: got 0x0d486b95, want 0.207545187542.
 * Proved by interval analysis: no value leaves 32 bits; the difference is at most 2.07e-08 over
 * [.02, 1] and 2.31e-08 over [0, 1]. */
#include "../lobe.h"
#include "../../core/q30.h"

lobe_dfg_q30 lobe_split_sum_low_q30(int32_t roughness, int32_t n_dot_v)
{
    const int32_t r = lobe_q_saturate(roughness);
    const int32_t v = lobe_q_saturate(n_dot_v);
    const int32_t t4 = lobe_q_mul(r, -1884443904, 31);   /* Q30 */
    const int32_t t5 = 338473728 + t4;                   /* Q30 */
    const int32_t t6 = lobe_q_mul(r, t5, 30);            /* Q30 */
    const int32_t t7 = 965216832 + t6;                   /* Q30 */
    const int32_t t11 = lobe_q_mul(v, 1867060736, 31);   /* Q30 */
    const int32_t t12 = -1455651068 + t11;               /* Q30 */
    const int32_t t14 = 1067988992 - v;                  /* Q30 */
    const int32_t t17 = lobe_q_mul(r, -1226443137, 31);  /* Q30 */
    const int32_t t18 = 1096463361 + t17;                /* Q30 */
    const int32_t t20 = lobe_q_mul(v, -1163014272, 31);  /* Q30 */
    const int32_t t21 = t18 + t20;                       /* Q30 */
    const int32_t t22 = lobe_q_min(t14, t21);            /* Q30 */
    const int32_t t24 = lobe_q_mul(t22, 1854466430, 30); /* Q30 */
    const int32_t t25 = v + t24;                         /* Q30 */
    const int32_t t27 = lobe_q_mul(t25, 1695286912, 31); /* Q30 */
    const int32_t t28 = t12 + t27;                       /* Q30 */
    const int32_t t29 = lobe_q_mul(t22, t22, 30);        /* Q30 */
    const int32_t t30 = lobe_q_mul(t29, t29, 30);        /* Q30 */
    const int32_t t31 = lobe_q_mul(t22, t30, 30);        /* Q30 */
    const int32_t t32 = lobe_q_shift_right(t18, 3);      /* Q27 */
    const int32_t t34 = lobe_q_mul(t30, 1405495043, 30); /* Q27 */
    const int32_t t35 = t32 + t34;                       /* Q27 */
    const int32_t t36 = lobe_q_mul(t28, t35, 27);        /* Q30 */
    const int32_t t37 = t5 + t36;                        /* Q30 */
    const int32_t t38 = lobe_q_mul(t31, t37, 30);        /* Q30 */
    const int32_t t39 = t28 + t38;                       /* Q30 */
    const int32_t t40 = lobe_q_mul(v, t12, 30);          /* Q30 */
    const int32_t t41 = r + t40;                         /* Q30 */
    const int32_t t42 = lobe_q_mul(t39, t41, 30);        /* Q30 */
    const int32_t t44 = lobe_q_mul(t39, -466931712, 31); /* Q30 */
    const int32_t t45 = t42 + t44;                       /* Q30 */
    const int32_t t46 = t7 - t45;                        /* Q30 */
    const int32_t t47 = lobe_q_min(t46, 1073741824);     /* Q30 */
    const int32_t t48 = lobe_q_max(t31, 0);              /* Q30 */
    const int32_t t49 = t47 - t48;                       /* Q30 */
    const int32_t t50 = lobe_q_max(t49, 0);              /* Q30 */
    lobe_dfg_q30 d;
    d.scale = t50;
    d.bias = t48;
    return d;
}

void lobe_split_sum_low_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *scale, int32_t *bias, size_t n)
{
    size_t i;
    for (i = 0; i < n; i++) {
        const lobe_dfg_q30 d = lobe_split_sum_low_q30(roughness[i], n_dot_v[i]);
        scale[i] = d.scale;
        bias[i] = d.bias;
    }
}
