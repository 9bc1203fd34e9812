/* Generated, not edited: lobefit emit split_sum --tier medium --to q30
 * Digest of the formula with its coefficients: 60c0429882676c84 (FNV-1a 64 of `lobefit emit --to c`).
 *
 * split_sum, medium, in 32-bit integers: inputs Q30, held at [0, 1]; results Q30 in [0, 1]. Each local's scale
 * stands beside it. Every product and shift rounds to nearest, ties up.
 * Difference to the same formula in double over [.02, 1], 1024 x 1024 points:
 *   3.06e-08 (2^-25.0) in bias at 0x04a6ec4a 0x0147ae14: got 0x3632898d, want 0.846834521850.
 * Difference to the same formula in double over [0, 1], 511 x 511 points, uniform in the logarithm:
 *   3.53e-08 (2^-24.8) in bias at 0x0001c3c4 0x01000000: got 0x3b22c842, want 0.923997905226.
 * Proved by interval analysis: no value leaves 32 bits; the difference is at most 1.11e-06 over
 * [.02, 1] and 1.39e-06 over [0, 1]. */
#include "../lobe.h"
#include "../../core/q30.h"

lobe_dfg_q30 lobe_split_sum_medium_q30(int32_t roughness, int32_t n_dot_v)
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
    const int32_t t2 = lobe_q_shift_right(v_up, 1);       /* Q29 */
    const int32_t t3 = 281474977 >> (18 - up);            /* Q30 */
    const int32_t t5 = lobe_q_mul(r_up, r_up, 30);        /* Q30 */
    const int32_t t6 = t3 + t5;                           /* Q30 */
    const int32_t t9 = lobe_q_mul(r, -1271731838, 30);    /* Q30 */
    const int32_t t11 = t9 + 1922695937;                  /* Q30 */
    const int32_t t12 = lobe_q_mul(t6, t11, 31);          /* Q29 */
    const int32_t t13 = t2 + t12;                         /* Q29 */
    const lobe_q_inverse t14 = lobe_q_reciprocal(t13);    /* mantissa and shift */
    const int32_t t15 = lobe_q_ratio(t2, t14);            /* Q30 */
    const int32_t t16 = 1073741824 - t15;                 /* Q30 */
    const int32_t t17 = lobe_q_mul(t15, t16, 30);         /* Q30 */
    const int32_t t18 = lobe_q_shift_right(t6, up);       /* Q30 */
    const int32_t t19 = lobe_q_mul(t18, t18, 30);         /* Q30 */
    const int32_t t21 = lobe_q_mul(t18, -1088106369, 31); /* Q28 */
    const int32_t t23 = t21 + 1090090367;                 /* Q28 */
    const int32_t t24 = lobe_q_mul(t19, t23, 29);         /* Q29 */
    const int32_t t26 = t24 + 274205984;                  /* Q29 */
    const int32_t t28 = lobe_q_mul(t18, -1167505537, 30); /* Q28 */
    const int32_t t30 = t28 - 375107457;                  /* Q28 */
    const int32_t t32 = lobe_q_mul(t18, 1156140288, 30);  /* Q26 */
    const int32_t t34 = t32 - 1582462849;                 /* Q26 */
    const int32_t t35 = lobe_q_mul(t19, t34, 29);         /* Q27 */
    const int32_t t37 = t35 + 1912175234;                 /* Q27 */
    const int32_t t38 = lobe_q_mul(t18, t37, 31);         /* Q26 */
    const int32_t t40 = t38 + 545267328;                  /* Q26 */
    const int32_t t42 = lobe_q_mul(t18, -1083294335, 30); /* Q25 */
    const int32_t t44 = t42 + 1381363585;                 /* Q25 */
    const int32_t t45 = lobe_q_mul(t18, t44, 29);         /* Q26 */
    const int32_t t47 = t45 + 214463472;                  /* Q26 */
    const int32_t t48 = lobe_q_mul(t18, t47, 29);         /* Q27 */
    const int32_t t50 = t48 - 1473238019;                 /* Q27 */
    const int32_t t51 = lobe_q_mul(t18, t50, 31);         /* Q26 */
    const int32_t t53 = t51 - 1076167165;                 /* Q26 */
    const int32_t t55 = lobe_q_mul(t15, 1211179136, 31);  /* Q26 */
    const int32_t t56 = t53 + t55;                        /* Q26 */
    const int32_t t57 = lobe_q_mul(t15, t56, 30);         /* Q26 */
    const int32_t t58 = t40 + t57;                        /* Q26 */
    const int32_t t59 = lobe_q_mul(t15, t58, 28);         /* Q28 */
    const int32_t t60 = t30 + t59;                        /* Q28 */
    const int32_t t61 = lobe_q_mul(t15, t60, 29);         /* Q29 */
    const int32_t t62 = t26 + t61;                        /* Q29 */
    const int32_t t63 = lobe_q_mul(t17, t62, 29);         /* Q30 */
    const int32_t t64 = 1073741824 - t63;                 /* Q30 */
    const int32_t t65 = lobe_q_min(t64, 1073741824);      /* Q30 */
    const int32_t t66 = lobe_q_shift_right(t13, up);      /* Q29 */
    const int32_t t67 = t66 * 2;                          /* Q30 */
    const int32_t t69 = lobe_q_mul(r, 1404814213, 31);    /* Q29 */
    const int32_t t71 = t69 - 1235600641;                 /* Q29 */
    const int32_t t72 = lobe_q_mul(r, t71, 29);           /* Q30 */
    const int32_t t74 = t72 + 1879597701;                 /* Q30 */
    const int32_t t76 = lobe_q_mul(r, -1476559741, 31);   /* Q29 */
    const int32_t t78 = t76 + 1333379711;                 /* Q29 */
    const int32_t t79 = lobe_q_mul(r, t78, 29);           /* Q30 */
    const int32_t t81 = t79 - 1519331195;                 /* Q30 */
    const int32_t t83 = lobe_q_mul(t15, -1539115908, 31); /* Q29 */
    const int32_t t85 = t83 + 1604371327;                 /* Q29 */
    const int32_t t86 = lobe_q_mul(t15, t85, 29);         /* Q30 */
    const int32_t t88 = t86 - 573006208;                  /* Q30 */
    const int32_t t89 = lobe_q_mul(t15, t88, 30);         /* Q30 */
    const int32_t t91 = t89 - 379404576;                  /* Q30 */
    const int32_t t92 = lobe_q_mul(t15, t91, 30);         /* Q30 */
    const int32_t t93 = t81 + t92;                        /* Q30 */
    const int32_t t94 = lobe_q_mul(t15, t93, 30);         /* Q30 */
    const int32_t t95 = t74 + t94;                        /* Q30 */
    const int32_t t96 = lobe_q_mul(t67, t95, 30);         /* Q30 */
    const int32_t t97 = 1073741824 - t96;                 /* Q30 */
    const int32_t t98 = lobe_q_max(t97, 0);               /* Q30 */
    const int32_t t99 = lobe_q_mul(t98, t98, 30);         /* Q30 */
    const int32_t t100 = lobe_q_mul(t99, t99, 29);        /* Q31 */
    const int32_t t101 = lobe_q_mul(t98, t100, 30);       /* Q31 */
    const int32_t t102 = lobe_q_mul(t65, t101, 31);       /* Q30 */
    const int32_t t103 = t65 - t102;                      /* Q30 */
    lobe_dfg_q30 d;
    d.scale = t103;
    d.bias = t102;
    return d;
}

void lobe_split_sum_medium_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *scale, int32_t *bias,
                                 size_t n)
{
    size_t i;
    for (i = 0; i < n; i++) {
        const lobe_dfg_q30 d = lobe_split_sum_medium_q30(roughness[i], n_dot_v[i]);
        scale[i] = d.scale;
        bias[i] = d.bias;
    }
}
