/* Generated, not edited: lobefit emit split_sum_sep --tier low --to q30
 * Digest of the formula with its coefficients: 3073a7005cf77a4a (FNV-1a 64 of `lobefit emit --to c`).
 *
 * split_sum_sep, low, in 32-bit integers: inputs Q30, held at [0, 1]; results Q30 in [0, 1]. Each local's scale
 * stands beside it. Every product and shift rounds to nearest, ties up.
 * Difference to the same formula in double over [.02, 1], 1024 x 1024 points:
 *   7.95e-09 (2^-26.9) in scale at 0x3e38d5e4 0x3fe09bfe: got 0x1556ba07, want 0.333418367865.
 * Difference to the same formula in double over [0, 1], 511 x 511 points, uniform in the logarithm:
 *   8.50e-09 (2^-26.8) in scale at 0x05e1e1e2 0x000f8788: got 0x03e70c0d, want 0.060977002728.
 * Proved by interval analysis: no value leaves 32 bits; the difference is at most 1.30e-08 over
 * [.02, 1] and 1.39e-08 over [0, 1]. */
#include "../lobe.h"
#include "../../core/q30.h"

lobe_dfg_q30 lobe_split_sum_sep_low_q30(int32_t roughness, int32_t n_dot_v)
{
    const int32_t r = lobe_q_saturate(roughness);
    const int32_t v = lobe_q_saturate(n_dot_v);
    const int32_t t5 = lobe_q_mul(r, -1474232065, 31);    /* Q30 */
    const int32_t t6 = 1094114175 + t5;                   /* Q30 */
    const int32_t t9 = lobe_q_mul(v, -928228929, 31);     /* Q30 */
    const int32_t t10 = t6 + t9;                          /* Q30 */
    const int32_t t13 = lobe_q_mul(v, -1214912642, 30);   /* Q30 */
    const int32_t t14 = 1053629376 + t13;                 /* Q30 */
    const int32_t t15 = lobe_q_min(t14, t10);             /* Q30 */
    const int32_t t16 = lobe_q_mul(t15, t15, 30);         /* Q30 */
    const int32_t t17 = lobe_q_mul(t16, t16, 30);         /* Q30 */
    const int32_t t18 = lobe_q_mul(t10, t17, 30);         /* Q30 */
    const int32_t t20 = lobe_q_mul(t18, -1260087806, 30); /* Q30 */
    const int32_t t21 = -86757792 + t20;                  /* Q30 */
    const int32_t t22 = lobe_q_mul(r, t21, 30);           /* Q30 */
    const int32_t t23 = 1155528578 + t22;                 /* Q30 */
    const int32_t t27 = lobe_q_mul(t16, 860658431, 31);   /* Q30 */
    const int32_t t28 = v + t27;                          /* Q30 */
    const int32_t t30 = lobe_q_mul(t28, -1224437504, 30); /* Q27 */
    const int32_t t31 = 375964991 + t30;                  /* Q27 */
    const int32_t t32 = lobe_q_mul(t21, t31, 27);         /* Q30 */
    const int32_t t33 = 901491072 + t32;                  /* Q30 */
    const int32_t t35 = lobe_q_mul(t6, -1675426816, 31);  /* Q30 */
    const int32_t t36 = t33 + t35;                        /* Q30 */
    const int32_t t39 = lobe_q_mul(t17, -1130610815, 30); /* Q29 */
    const int32_t t40 = -195092672 + t39;                 /* Q29 */
    const int32_t t41 = lobe_q_mul(v, t40, 29);           /* Q30 */
    const int32_t t42 = r + t41;                          /* Q30 */
    const int32_t t43 = lobe_q_mul(t36, t42, 30);         /* Q30 */
    const int32_t t44 = t23 - t43;                        /* Q30 */
    const int32_t t45 = lobe_q_min(t44, 1073741824);      /* Q30 */
    const int32_t t47 = lobe_q_mul(t45, 2114108033, 31);  /* Q30 */
    const int32_t t49 = lobe_q_mul(t16, 124661016, 31);   /* Q30 */
    const int32_t t50 = t18 + t49;                        /* Q30 */
    const int32_t t51 = lobe_q_clamp(t50, 0, 1073741824); /* Q30 */
    const int32_t t52 = t47 - t51;                        /* Q30 */
    const int32_t t53 = lobe_q_max(t52, 0);               /* Q30 */
    lobe_dfg_q30 d;
    d.scale = t53;
    d.bias = t51;
    return d;
}

void lobe_split_sum_sep_low_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *scale, int32_t *bias,
                                  size_t n)
{
    size_t i;
    for (i = 0; i < n; i++) {
        const lobe_dfg_q30 d = lobe_split_sum_sep_low_q30(roughness[i], n_dot_v[i]);
        scale[i] = d.scale;
        bias[i] = d.bias;
    }
}
