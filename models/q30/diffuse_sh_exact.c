/* Generated, not edited: lobefit emit diffuse_sh --tier exact --to q30
 * Digest of the formula with its coefficients: 86efda705d917e28 (FNV-1a 64 of `lobefit emit --to c`).
 *
 * Shape of diffuse_sh, exact, in 32-bit integers: inputs Q30, held at [0, 1]; results Q30 in [0, 1]. Each local's scale
 * stands beside it. Every product and shift rounds to nearest, ties up.
 * Difference to the same formula in double over [.02, 1], 1024 x 1024 points:
 *   1.84e-09 (2^-29.0) in c1n at 0x31d6611d 0x01a5da1a: got 0x1a70cf25, want 0.413135326440.
 * Difference to the same formula in double over [0, 1], 511 x 511 points, uniform in the logarithm:
 *   1.67e-09 (2^-29.2) in c2n at 0x40000000 0x00012d2d: got 0x0e414845, want 0.222734513884.
 * Proved by interval analysis: no value leaves 32 bits; the difference is at most 2.90e-09 over
 * [.02, 1] and 2.99e-09 over [0, 1]. */
#include "../lobe.h"
#include "../../core/q30.h"
#include "diffuse_sh.h"

lobe_diffuse_shape_q30 lobe_diffuse_shape_exact_q30(int32_t roughness, int32_t n_dot_v)
{
    const int32_t r = lobe_q_saturate(roughness);
    const int32_t v = lobe_q_saturate(n_dot_v);
    const int32_t t3 = lobe_q_mul(v, 14423666, 31);    /* Q31 */
    const int32_t t5 = t3 + 28847331;                  /* Q31 */
    const int32_t t6 = lobe_q_mul(r, t5, 31);          /* Q30 */
    const int32_t t8 = t6 + 295685143;                 /* Q30 */
    const int32_t t10 = 1073741824 - v;                /* Q30 */
    const int32_t t11 = lobe_q_mul(t10, t10, 30);      /* Q30 */
    const int32_t t12 = lobe_q_mul(t11, t11, 30);      /* Q30 */
    const int32_t t13 = lobe_q_mul(t10, t12, 30);      /* Q30 */
    const int32_t t15 = lobe_q_mul(v, -173083986, 31); /* Q34 */
    const int32_t t17 = t15 + 115389324;               /* Q34 */
    const int32_t t18 = lobe_q_mul(r, t17, 31);        /* Q33 */
    const int32_t t20 = t18 + 1586603209;              /* Q33 */
    const int32_t t21 = lobe_q_mul(v, t20, 31);        /* Q32 */
    const int32_t t23 = lobe_q_mul(r, 168276098, 31);  /* Q32 */
    const int32_t t25 = t23 + 1153893243;              /* Q32 */
    const int32_t t26 = t21 + t25;                     /* Q32 */
    const int32_t t27 = lobe_q_mul(r, t26, 31);        /* Q31 */
    const int32_t t29 = t27 - 295685143;               /* Q31 */
    const int32_t t30 = lobe_q_mul(t13, t29, 31);      /* Q30 */
    const int32_t t31 = t8 + t30;                      /* Q30 */
    const int32_t t33 = lobe_q_mul(v, 8327507, 31);    /* Q31 */
    const int32_t t35 = t33 + 12491261;                /* Q31 */
    const int32_t t36 = lobe_q_mul(r, t35, 31);        /* Q30 */
    const int32_t t38 = t36 + 346632486;               /* Q30 */
    const int32_t t40 = lobe_q_mul(v, -29979026, 31);  /* Q33 */
    const int32_t t42 = t40 + 33310029;                /* Q33 */
    const int32_t t43 = lobe_q_mul(r, t42, 31);        /* Q32 */
    const int32_t t45 = t43 + 1040938398;              /* Q32 */
    const int32_t t46 = lobe_q_mul(v, t45, 31);        /* Q31 */
    const int32_t t48 = lobe_q_mul(r, 35808281, 31);   /* Q31 */
    const int32_t t50 = t48 + 687019342;               /* Q31 */
    const int32_t t51 = t46 + t50;                     /* Q31 */
    const int32_t t52 = lobe_q_mul(r, t51, 30);        /* Q31 */
    const int32_t t54 = t52 - 346632486;               /* Q31 */
    const int32_t t55 = lobe_q_mul(t13, t54, 31);      /* Q30 */
    const int32_t t56 = t38 + t55;                     /* Q30 */
    const int32_t t58 = lobe_q_mul(v, 86606075, 31);   /* Q33 */
    const int32_t t60 = t58 + 183205158;               /* Q33 */
    const int32_t t61 = lobe_q_mul(r, t60, 31);        /* Q32 */
    const int32_t t63 = t61 + 478831663;               /* Q32 */
    const int32_t t64 = lobe_q_mul(t13, t63, 31);      /* Q31 */
    const int32_t t66 = t64 + 22900645;                /* Q31 */
    const int32_t t67 = lobe_q_mul(r, t66, 31);        /* Q30 */
    const int32_t t69 = lobe_q_mul(v, -9675689, 31);   /* Q31 */
    const int32_t t71 = t69 - 24189222;                /* Q31 */
    const int32_t t72 = lobe_q_mul(r, t71, 31);        /* Q30 */
    const int32_t t74 = t72 + 175371863;               /* Q30 */
    const int32_t t76 = lobe_q_mul(v, 164193510, 31);  /* Q34 */
    const int32_t t78 = t76 - 77405512;                /* Q34 */
    const int32_t t79 = lobe_q_mul(r, t78, 31);        /* Q33 */
    const int32_t t81 = t79 + 1464254267;              /* Q33 */
    const int32_t t82 = lobe_q_mul(v, t81, 31);        /* Q32 */
    const int32_t t84 = lobe_q_mul(r, -142691979, 31); /* Q32 */
    const int32_t t86 = t84 + 725676674;               /* Q32 */
    const int32_t t87 = t82 + t86;                     /* Q32 */
    const int32_t t88 = lobe_q_mul(r, t87, 31);        /* Q31 */
    const int32_t t90 = t88 - 175371863;               /* Q31 */
    const int32_t t91 = lobe_q_mul(t13, t90, 31);      /* Q30 */
    const int32_t t92 = t74 + t91;                     /* Q30 */
    const int32_t t94 = lobe_q_mul(v, 60941036, 31);   /* Q33 */
    const int32_t t96 = t94 + 96828535;                /* Q33 */
    const int32_t t97 = lobe_q_mul(r, t96, 31);        /* Q32 */
    const int32_t t99 = t97 + 601454170;               /* Q32 */
    const int32_t t100 = lobe_q_mul(t13, t99, 31);     /* Q31 */
    const int32_t t102 = t100 + 12103567;              /* Q31 */
    const int32_t t103 = lobe_q_mul(r, t102, 31);      /* Q30 */
    const int32_t t105 = lobe_q_mul(r, 47398584, 31);  /* Q32 */
    const int32_t t106 = lobe_q_mul(r, t105, 31);      /* Q31 */
    const int32_t t107 = lobe_q_mul(t13, t106, 31);    /* Q30 */
    const int32_t t108 = lobe_q_max(t107, 0);          /* Q30 */
    lobe_diffuse_shape_q30 d;
    d.c00 = t31;
    d.c1n = t56;
    d.c1t = t67;
    d.c2n = t92;
    d.c2t = t103;
    d.c2tt = t108;
    return d;
}

LOBE_DIFFUSE_SH_Q30(exact)
