/* Generated, not edited: lobefit emit split_sum --tier low --to q30
 * Digest of the formula with its coefficients: 2fdba013ac9371b0 (FNV-1a 64 of `lobefit emit --to c`).
 *
 * split_sum, low, in 32-bit integers: inputs Q30, held at [0, 1]; results Q30 in [0, 1]. Each local's scale
 * stands beside it. Every product and shift rounds to nearest, ties up.
 * Difference to the same formula in double over [.02, 1], 1024 x 1024 points:
 *   1.99e-08 (2^-25.6) in bias at 0x0147ae14 0x01576015: got 0x38db92a4, want 0.888401680991.
 * Difference to the same formula in double over [0, 1], 511 x 511 points, uniform in the logarithm:
 *   3.38e-08 (2^-24.8) in bias at 0x0023c3c4 0x010f0f0f: got 0x3ade3d30, want 0.919814359114.
 * Proved by interval analysis: no value leaves 32 bits; the difference is at most 9.39e-08 over
 * [.02, 1] and 1.18e-07 over [0, 1]. */
#include "../lobe.h"
#include "../../core/q30.h"

lobe_dfg_q30 lobe_split_sum_low_q30(int32_t roughness, int32_t n_dot_v)
{
    const int32_t r = lobe_q_saturate(roughness);
    const int32_t v = lobe_q_saturate(n_dot_v);
    /* v / (v + k r^2) keeps its value when r grows by 8 and v by 64: that keeps its precision near 0. */
    int32_t r_up = r, v_up = v;
    int up = 0;
    while (up < 18 && r_up < 1 << 27 && v_up < 1 << 24) {
        r_up <<= 3;
        v_up <<= 6;
        up += 6;
    }
    const int32_t t3 = lobe_q_mul(r_up, r_up, 30);       /* Q30 */
    const int32_t t5 = lobe_q_mul(t3, 2063731786, 31);   /* Q30 */
    const int32_t t6 = v_up + t5;                        /* Q30 */
    const int32_t t7 = 281474977 >> (18 - up);           /* Q30 */
    const int32_t t8 = lobe_q_max(t6, t7);               /* Q30 */
    const lobe_q_inverse t9 = lobe_q_reciprocal(t8);     /* mantissa and shift */
    const int32_t t10 = lobe_q_ratio(v_up, t9);          /* Q30 */
    const int32_t t11 = 1073741824 - t10;                /* Q30 */
    const int32_t t12 = lobe_q_mul(t10, t11, 30);        /* Q30 */
    const int32_t t13 = lobe_q_shift_right(t3, up);      /* Q30 */
    const int32_t t15 = lobe_q_mul(t13, 2040109466, 31); /* Q29 */
    const int32_t t17 = t15 + 322122547;                 /* Q29 */
    const int32_t t18 = lobe_q_mul(t12, t17, 29);        /* Q30 */
    const int32_t t19 = 1073741824 - t18;                /* Q30 */
    const int32_t t20 = lobe_q_min(t19, 1073741824);     /* Q30 */
    const int32_t t21 = lobe_q_shift_right(t8, up);      /* Q30 */
    const int32_t t24 = lobe_q_mul(r, -214748365, 31);   /* Q30 */
    const int32_t t25 = 1073741824 + t24;                /* Q30 */
    const int32_t t26 = lobe_q_mul(t21, t25, 30);        /* Q30 */
    const int32_t t27 = 1073741824 - t26;                /* Q30 */
    const int32_t t28 = lobe_q_max(t27, 0);              /* Q30 */
    const int32_t t29 = lobe_q_mul(t28, t28, 30);        /* Q30 */
    const int32_t t30 = lobe_q_mul(t29, t29, 29);        /* Q31 */
    const int32_t t31 = lobe_q_mul(t28, t30, 30);        /* Q31 */
    const int32_t t32 = lobe_q_mul(t20, t31, 31);        /* Q30 */
    const int32_t t33 = t20 - t32;                       /* Q30 */
    lobe_dfg_q30 d;
    d.scale = t33;
    d.bias = t32;
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
