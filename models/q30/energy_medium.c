/* Generated, not edited: lobefit emit energy --tier medium --to q30
 * Digest of the formula with its coefficients: 3efeb1e022d9cae7 (FNV-1a 64 of `lobefit emit --to c`).
 *
 * energy, medium, in 32-bit integers: inputs Q30, held at [0, 1]; results Q30 in [0, 1]. Each local's scale
 * stands beside it. Every product and shift rounds to nearest, ties up.
 * Difference to the same formula in double over [.02, 1], 1024 x 1024 points:
 *   8.22e-09 (2^-26.9) in energy at 0x0514ca51 0x01a5da1a: got 0x3dd1b312, want 0.965924049561.
 * Difference to the same formula in double over [0, 1], 511 x 511 points, uniform in the logarithm:
 *   1.37e-08 (2^-26.1) in energy at 0x00027878 0x00000048: got 0x3c6bb9ce, want 0.944075074675.
 * Proved by interval analysis: no value leaves 32 bits; the difference is at most 1.06e-07 over
 * [.02, 1] and 2.56e-07 over [0, 1]. */
#include "../lobe.h"
#include "../../core/q30.h"

int32_t lobe_energy_medium_q30(int32_t roughness, int32_t n_dot_v)
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
    const int32_t t4 = lobe_q_mul(r_up, r_up, 30);                        /* Q30 */
    const int32_t t6 = lobe_q_mul(t4, 1949050880, 31);                    /* Q30 */
    const int32_t t7 = v_up + t6;                                         /* Q30 */
    const lobe_q_inverse t8 = lobe_q_reciprocal(t7);                      /* mantissa and shift */
    const int32_t t9 = lobe_q_ratio(v_up, t8);                            /* Q30 */
    const int32_t t11 = t9 - 536870912;                                   /* Q29 */
    const int32_t t22 = lobe_q_mul(t11, 1400046080, 29);                  /* Q28 */
    const int32_t t23 = -477203425 + t22;                                 /* Q28 */
    const int32_t t24 = lobe_q_mul(t11, t23, 30);                         /* Q27 */
    const int32_t t25 = -1383241221 + t24;                                /* Q27 */
    const int32_t t26 = lobe_q_mul(t11, t25, 28);                         /* Q28 */
    const int32_t t27 = 641298623 + t26;                                  /* Q28 */
    const int32_t t28 = lobe_q_mul(t11, t27, 29);                         /* Q28 */
    const int32_t t29 = 1982006783 + t28;                                 /* Q28 */
    const int32_t t30 = lobe_q_mul(t11, t29, 28);                         /* Q29 */
    const int32_t t31 = -136517776 + t30;                                 /* Q29 */
    const int32_t t32 = lobe_q_mul(t11, t31, 29);                         /* Q29 */
    const int32_t t33 = -1099702786 + t32;                                /* Q29 */
    const int32_t t34 = lobe_q_mul(t11, t33, 28);                         /* Q30 */
    const int32_t t35 = -895119872 + t34;                                 /* Q30 */
    const int32_t t36 = lobe_q_mul(t11, t35, 28);                         /* Q31 */
    const int32_t t37 = -788415743 + t36;                                 /* Q31 */
    const int32_t t38 = lobe_q_mul(t11, t37, 31);                         /* Q29 */
    const int32_t t39 = 126462464 + t38;                                  /* Q29 */
    const int32_t t40 = lobe_q_mul(t11, t39, 31);                         /* Q27 */
    const int32_t t41 = 63412568 + t40;                                   /* Q27 */
    const int32_t t42 = lobe_q_shift_right(t4, up);                       /* Q30 */
    const int32_t t47 = lobe_q_mul(t11, 2048149505, 30);                  /* Q29 */
    const int32_t t48 = 1104718723 + t47;                                 /* Q29 */
    const int32_t t49 = lobe_q_mul(t11, t48, 31);                         /* Q27 */
    const int32_t t50 = 551591359 + t49;                                  /* Q27 */
    const int32_t t55 = lobe_q_mul(t11, -1471151739, 30);                 /* Q26 */
    const int32_t t56 = -615775680 + t55;                                 /* Q26 */
    const int32_t t57 = lobe_q_mul(t11, t56, 29);                         /* Q26 */
    const int32_t t58 = 111365608 + t57;                                  /* Q26 */
    const int32_t t59 = lobe_q_mul(t11, t58, 29);                         /* Q26 */
    const int32_t t60 = 51340788 + t59;                                   /* Q26 */
    const int32_t t67 = lobe_q_mul(t11, -1614235136, 30);                 /* Q27 */
    const int32_t t68 = -348952897 + t67;                                 /* Q27 */
    const int32_t t69 = lobe_q_mul(t11, t68, 30);                         /* Q26 */
    const int32_t t70 = 1564751746 + t69;                                 /* Q26 */
    const int32_t t71 = lobe_q_mul(t11, t70, 29);                         /* Q26 */
    const int32_t t72 = 1146686334 + t71;                                 /* Q26 */
    const int32_t t73 = lobe_q_mul(t11, t72, 29);                         /* Q26 */
    const int32_t t74 = -91760448 + t73;                                  /* Q26 */
    const int32_t t75 = lobe_q_mul(t11, t74, 29);                         /* Q26 */
    const int32_t t76 = -44117628 + t75;                                  /* Q26 */
    const int32_t t80 = lobe_q_mul(t11, 1315403776, 30);                  /* Q26 */
    const int32_t t81 = 819767295 + t80;                                  /* Q26 */
    const int32_t t82 = lobe_q_mul(t11, t81, 29);                         /* Q26 */
    const int32_t t83 = 240788720 + t82;                                  /* Q26 */
    const int32_t t84 = lobe_q_mul(t42, t83, 30);                         /* Q26 */
    const int32_t t85 = t76 + t84;                                        /* Q26 */
    const int32_t t86 = lobe_q_mul(t42, t85, 30);                         /* Q26 */
    const int32_t t87 = t60 + t86;                                        /* Q26 */
    const int32_t t88 = lobe_q_mul(t42, t87, 29);                         /* Q27 */
    const int32_t t89 = t50 + t88;                                        /* Q27 */
    const int32_t t90 = lobe_q_mul(t42, t89, 30);                         /* Q27 */
    const int32_t t91 = 746012 + t90;                                     /* Q27 */
    const int32_t t92 = lobe_q_mul(t42, t91, 30);                         /* Q27 */
    const int32_t t93 = t41 + t92;                                        /* Q27 */
    const int32_t t94 = lobe_q_mul(t9, t9, 30);                           /* Q30 */
    const int32_t t95 = t9 - t94;                                         /* Q30 */
    const int32_t t96 = lobe_q_mul(t93, t95, 28);                         /* Q29 */
    const int32_t t97 = 536870912 + t96;                                  /* Q29 */
    const lobe_q_inverse t98 = lobe_q_reciprocal(t97);                    /* mantissa and shift */
    const int32_t t99 = lobe_q_shift_right(t98.mantissa, t98.shift - 58); /* Q29 */
    const int32_t t100 = lobe_q_min(t99, 536870912);                      /* Q29 */
    const int32_t t101 = t100 * 2;                                        /* Q30 */
    return t101;
}

void lobe_energy_medium_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *e, size_t n)
{
    size_t i;
    for (i = 0; i < n; i++)
        e[i] = lobe_energy_medium_q30(roughness[i], n_dot_v[i]);
}
