/* Generated, not edited: lobefit emit split_sum_sep --tier low --to q30
 * Digest of the formula with its coefficients: b92ea30ad3280bd0 (FNV-1a 64 of `lobefit emit --to c`).
 *
 * split_sum_sep, low, in 32-bit integers: inputs Q30, held at [0, 1]; results Q30 in [0, 1]. Each local's scale
 * stands beside it. Every product and shift rounds to nearest, ties up.
 * Difference to the same formula in double over [.02, 1], 1024 x 1024 points:
 *   9.03e-09 (2^-26.7) in scale at 0x05f0865f 0x01576015: got 0x071a7071, want 0.110988731209.
 * Difference to the same formula in double over [0, 1], 511 x 511 points, uniform in the logarithm:
 *   1.14e-08 (2^-26.4) in scale at 0x043c3c3c 0x0003a5a6: got 0x00495ae8, want 0.004477251560.
 * Proved by interval analysis: no value leaves 32 bits; the difference is at most 1.75e-08 over
 * [.02, 1] and 1.89e-08 over [0, 1]. */
#include "../lobe.h"
#include "../../core/q30.h"

lobe_dfg_q30 lobe_split_sum_sep_low_q30(int32_t roughness, int32_t n_dot_v)
{
    const int32_t r = lobe_q_saturate(roughness);
    const int32_t v = lobe_q_saturate(n_dot_v);
    const int32_t t4 = lobe_q_mul(v, 1953540094, 31);     /* Q28 */
    const int32_t t5 = -609751552 + t4;                   /* Q28 */
    const int32_t t8 = lobe_q_mul(r, 1483710722, 31);     /* Q28 */
    const int32_t t9 = t5 + t8;                           /* Q28 */
    const int32_t t12 = lobe_q_mul(r, -1231855105, 31);   /* Q30 */
    const int32_t t13 = 877713536 + t12;                  /* Q30 */
    const int32_t t15 = lobe_q_mul(v, -503672000, 31);    /* Q30 */
    const int32_t t16 = t13 + t15;                        /* Q30 */
    const int32_t t18 = 839413632 - v;                    /* Q30 */
    const int32_t t19 = lobe_q_min(t18, t16);             /* Q30 */
    const int32_t t20 = lobe_q_mul(t19, t19, 30);         /* Q30 */
    const int32_t t21 = lobe_q_mul(t16, t20, 30);         /* Q30 */
    const int32_t t22 = lobe_q_shift_right(t19, 1);       /* Q29 */
    const int32_t t25 = lobe_q_mul(t20, -1111523712, 30); /* Q29 */
    const int32_t t26 = 1998608002 + t25;                 /* Q29 */
    const int32_t t27 = lobe_q_mul(t21, t26, 30);         /* Q29 */
    const int32_t t28 = t22 + t27;                        /* Q29 */
    const int32_t t29 = lobe_q_mul(t21, t28, 29);         /* Q30 */
    const int32_t t31 = lobe_q_mul(t29, 1673108351, 30);  /* Q28 */
    const int32_t t32 = t9 + t31;                         /* Q28 */
    const int32_t t34 = lobe_q_mul(r, 452629567, 31);     /* Q30 */
    const int32_t t35 = t34 * 8;                          /* Q33 */
    const int32_t t38 = lobe_q_mul(v, 1229888257, 31);    /* Q30 */
    const int32_t t39 = -44174116 + t38;                  /* Q30 */
    const int32_t t42 = lobe_q_mul(v, 1357979264, 31);    /* Q32 */
    const int32_t t43 = -1564669054 + t42;                /* Q32 */
    const int32_t t44 = lobe_q_mul(t39, t43, 29);         /* Q33 */
    const int32_t t45 = t35 + t44;                        /* Q33 */
    const int32_t t46 = lobe_q_mul(t32, t45, 31);         /* Q30 */
    const int32_t t48 = lobe_q_mul(t34, 1722647548, 30);  /* Q30 */
    const int32_t t49 = t46 + t48;                        /* Q30 */
    const int32_t t50 = 1131928065 - t49;                 /* Q30 */
    const int32_t t51 = lobe_q_min(t50, 1073741824);      /* Q30 */
    const int32_t t52 = lobe_q_clamp(t29, 0, 1073741824); /* Q30 */
    const int32_t t53 = t51 - t52;                        /* Q30 */
    const int32_t t54 = lobe_q_max(t53, 0);               /* Q30 */
    lobe_dfg_q30 d;
    d.scale = t54;
    d.bias = t52;
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
