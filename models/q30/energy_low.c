/* Generated, not edited: lobefit emit energy --tier low --to q30
 * Digest of the formula with its coefficients: bf64f638a6138d8f (FNV-1a 64 of `lobefit emit --to c`).
 *
 * energy, low, in 32-bit integers: inputs Q30, held at [0, 1]; results Q30 in [0, 1]. Each local's scale
 * stands beside it. Every product and shift rounds to nearest, ties up.
 * Difference to the same formula in double over [.02, 1], 1024 x 1024 points:
 *   1.68e-08 (2^-25.8) in energy at 0x03abcc3b 0x01576015: got 0x3e9f184e, want 0.978460367696.
 * Difference to the same formula in double over [0, 1], 511 x 511 points, uniform in the logarithm:
 *   1.62e-08 (2^-25.9) in energy at 0x000030f1 0x00000001: got 0x3ec91766, want 0.981023661219.
 * Proved by interval analysis: no value leaves 32 bits; the difference is at most 1.29e-07 over
 * [.02, 1] and 3.89e-07 over [0, 1]. */
#include "../lobe.h"
#include "../../core/q30.h"

int32_t lobe_energy_low_q30(int32_t roughness, int32_t n_dot_v)
{
    const int32_t r = lobe_q_saturate(roughness);
    const int32_t v = lobe_q_saturate(n_dot_v);
    /* v / (v + k r^2) keeps its value when r grows by 8 and v by 64: that keeps its precision near 0. */
    int32_t r_up = r, v_up = v;
    int up = 0;
    while (up < 30 && r_up < 1 << 27 && v_up < 1 << 24) {
        r_up <<= 3;
        v_up <<= 6;
        up += 6;
    }
    const int32_t t2 = lobe_q_shift_right(v_up, 1);                       /* Q29 */
    const int32_t t4 = lobe_q_mul(r_up, r_up, 30);                        /* Q30 */
    const int32_t t6 = lobe_q_mul(t4, 1209850626, 31);                    /* Q29 */
    const int32_t t7 = t2 + t6;                                           /* Q29 */
    const lobe_q_inverse t8 = lobe_q_reciprocal(t7);                      /* mantissa and shift */
    const int32_t t9 = lobe_q_ratio(t2, t8);                              /* Q30 */
    const int32_t t12 = lobe_q_mul(t9, -942536704, 31);                   /* Q28 */
    const int32_t t13 = 417154400 + t12;                                  /* Q28 */
    const int32_t t14 = lobe_q_mul(t9, t13, 31);                          /* Q27 */
    const int32_t t15 = 15998796 + t14;                                   /* Q27 */
    const int32_t t16 = lobe_q_shift_right(t4, up);                       /* Q30 */
    const int32_t t23 = lobe_q_mul(t9, 1298204160, 30);                   /* Q25 */
    const int32_t t24 = -339784735 + t23;                                 /* Q25 */
    const int32_t t25 = lobe_q_mul(t9, t24, 29);                          /* Q26 */
    const int32_t t26 = 143715968 + t25;                                  /* Q26 */
    const int32_t t27 = lobe_q_mul(t16, t26, 28);                         /* Q28 */
    const int32_t t28 = -501702657 + t27;                                 /* Q28 */
    const int32_t t29 = lobe_q_mul(t16, t28, 31);                         /* Q27 */
    const int32_t t30 = 586276672 + t29;                                  /* Q27 */
    const int32_t t31 = lobe_q_mul(t16, t30, 30);                         /* Q27 */
    const int32_t t32 = 7968526 + t31;                                    /* Q27 */
    const int32_t t33 = lobe_q_mul(t16, t32, 30);                         /* Q27 */
    const int32_t t34 = t15 + t33;                                        /* Q27 */
    const int32_t t35 = lobe_q_mul(t9, t9, 30);                           /* Q30 */
    const int32_t t36 = t9 - t35;                                         /* Q30 */
    const int32_t t37 = lobe_q_mul(t34, t36, 28);                         /* Q29 */
    const int32_t t39 = t37 + 536870912;                                  /* Q29 */
    const lobe_q_inverse t40 = lobe_q_reciprocal(t39);                    /* mantissa and shift */
    const int32_t t41 = lobe_q_shift_right(t40.mantissa, t40.shift - 58); /* Q29 */
    const int32_t t42 = lobe_q_min(t41, 536870912);                       /* Q29 */
    const int32_t t43 = t42 * 2;                                          /* Q30 */
    return t43;
}

void lobe_energy_low_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *e, size_t n)
{
    size_t i;
    for (i = 0; i < n; i++)
        e[i] = lobe_energy_low_q30(roughness[i], n_dot_v[i]);
}
