/* Generated, not edited: lobefit emit split_sum_sep --tier medium --to q30
 * Digest of the formula with its coefficients: 9212c728a2ee5b2b (FNV-1a 64 of `lobefit emit --to c`).
 *
 * split_sum_sep, medium, in 32-bit integers: inputs Q30, held at [0, 1]; results Q30 in [0, 1]. Each local's scale
 * stands beside it. Every product and shift rounds to nearest, ties up.
 * Difference to the same formula in double over [.02, 1], 1024 x 1024 points:
 *   2.49e-08 (2^-25.3) in bias at 0x04d6024d 0x0147ae14: got 0x35d74914, want 0.841264956871.
 * Difference to the same formula in double over [0, 1], 511 x 511 points, uniform in the logarithm:
 *   3.08e-08 (2^-25.0) in bias at 0x0000070f 0x00001000: got 0x3d86d625, want 0.961354736134.
 * Proved by interval analysis: no value leaves 32 bits; the difference is at most 7.04e-07 over
 * [.02, 1] and 8.51e-07 over [0, 1]. */
#include "../lobe.h"
#include "../../core/q30.h"

lobe_dfg_q30 lobe_split_sum_sep_medium_q30(int32_t roughness, int32_t n_dot_v)
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
    const int32_t t1 = 281474977 >> (18 - up);           /* Q30 */
    const int32_t t3 = lobe_q_mul(r_up, r_up, 30);       /* Q30 */
    const int32_t t4 = t1 + t3;                          /* Q30 */
    const int32_t t5 = lobe_q_shift_right(t4, up);       /* Q30 */
    const int32_t t6 = lobe_q_mul(t5, t5, 30);           /* Q30 */
    const int32_t t8 = lobe_q_mul(t5, 948629504, 31);    /* Q31 */
    const int32_t t10 = t8 - 1586583936;                 /* Q31 */
    const int32_t t11 = lobe_q_mul(t5, t10, 30);         /* Q31 */
    const int32_t t13 = t11 + 1824350207;                /* Q31 */
    const int32_t t14 = lobe_q_mul(t6, t13, 31);         /* Q30 */
    const int32_t t16 = t14 + 54364992;                  /* Q30 */
    const int32_t t18 = lobe_q_shift_right(v_up, 1);     /* Q29 */
    const int32_t t20 = lobe_q_mul(t4, 1520860031, 31);  /* Q29 */
    const int32_t t21 = t18 + t20;                       /* Q29 */
    const lobe_q_inverse t22 = lobe_q_reciprocal(t21);   /* mantissa and shift */
    const int32_t t23 = lobe_q_ratio(t18, t22);          /* Q30 */
    const int32_t t25 = lobe_q_mul(t6, 1113857151, 30);  /* Q30 */
    const int32_t t27 = t25 + 369675456;                 /* Q30 */
    const int32_t t28 = lobe_q_mul(t23, t23, 30);        /* Q30 */
    const int32_t t30 = lobe_q_mul(t5, -1447623680, 30); /* Q27 */
    const int32_t t32 = t30 + 1643432192;                /* Q27 */
    const int32_t t33 = lobe_q_mul(t5, t32, 29);         /* Q28 */
    const int32_t t35 = t33 + 418289120;                 /* Q28 */
    const int32_t t36 = lobe_q_mul(t6, t35, 29);         /* Q29 */
    const int32_t t38 = lobe_q_mul(t23, 1857697665, 31); /* Q27 */
    const int32_t t40 = t38 - 1453304445;                /* Q27 */
    const int32_t t41 = lobe_q_mul(t23, t40, 29);        /* Q28 */
    const int32_t t43 = t41 + 980720383;                 /* Q28 */
    const int32_t t44 = lobe_q_mul(t23, t43, 29);        /* Q29 */
    const int32_t t45 = t36 + t44;                       /* Q29 */
    const int32_t t46 = lobe_q_mul(t28, t45, 29);        /* Q30 */
    const int32_t t47 = t27 + t46;                       /* Q30 */
    const int32_t t48 = lobe_q_mul(t23, t47, 30);        /* Q30 */
    const int32_t t49 = t16 + t48;                       /* Q30 */
    const int32_t t50 = 1073741824 - t23;                /* Q30 */
    const int32_t t51 = lobe_q_mul(t49, t50, 30);        /* Q30 */
    const int32_t t52 = 1073741824 - t51;                /* Q30 */
    const int32_t t53 = lobe_q_min(t52, 1073741824);     /* Q30 */
    const int32_t t54 = lobe_q_shift_right(t21, up);     /* Q29 */
    const int32_t t57 = lobe_q_mul(r, 647060223, 31);    /* Q27 */
    const int32_t t59 = t57 - 1099460736;                /* Q27 */
    const int32_t t60 = lobe_q_mul(r, t59, 30);          /* Q27 */
    const int32_t t62 = t60 + 1502724486;                /* Q27 */
    const int32_t t63 = lobe_q_mul(r, t62, 29);          /* Q28 */
    const int32_t t65 = t63 - 2137503231;                /* Q28 */
    const int32_t t66 = lobe_q_mul(r, t65, 29);          /* Q29 */
    const int32_t t68 = t66 + 1553058816;                /* Q29 */
    const int32_t t70 = lobe_q_mul(r, 1275839999, 31);   /* Q27 */
    const int32_t t72 = t70 - 1564208003;                /* Q27 */
    const int32_t t73 = lobe_q_mul(r, t72, 30);          /* Q27 */
    const int32_t t75 = t73 + 1423419781;                /* Q27 */
    const int32_t t76 = lobe_q_mul(r, t75, 28);          /* Q29 */
    const int32_t t78 = t76 - 1970523007;                /* Q29 */
    const int32_t t80 = lobe_q_mul(r, -1229427710, 30);  /* Q29 */
    const int32_t t82 = t80 + 1238584194;                /* Q29 */
    const int32_t t84 = lobe_q_mul(t23, -580998976, 31); /* Q29 */
    const int32_t t85 = t82 + t84;                       /* Q29 */
    const int32_t t86 = lobe_q_mul(t28, t85, 30);        /* Q29 */
    const int32_t t87 = t78 + t86;                       /* Q29 */
    const int32_t t88 = lobe_q_mul(t23, t87, 30);        /* Q29 */
    const int32_t t89 = t68 + t88;                       /* Q29 */
    const int32_t t90 = lobe_q_mul(t54, t89, 28);        /* Q30 */
    const int32_t t91 = 1073741824 - t90;                /* Q30 */
    const int32_t t92 = lobe_q_max(t91, 0);              /* Q30 */
    const int32_t t93 = lobe_q_mul(t92, t92, 30);        /* Q30 */
    const int32_t t94 = lobe_q_mul(t93, t93, 29);        /* Q31 */
    const int32_t t95 = lobe_q_mul(t92, t94, 30);        /* Q31 */
    const int32_t t96 = lobe_q_mul(t53, t95, 31);        /* Q30 */
    const int32_t t97 = t53 - t96;                       /* Q30 */
    lobe_dfg_q30 d;
    d.scale = t97;
    d.bias = t96;
    return d;
}

void lobe_split_sum_sep_medium_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *scale, int32_t *bias,
                                     size_t n)
{
    size_t i;
    for (i = 0; i < n; i++) {
        const lobe_dfg_q30 d = lobe_split_sum_sep_medium_q30(roughness[i], n_dot_v[i]);
        scale[i] = d.scale;
        bias[i] = d.bias;
    }
}
