/* Generated, not edited: lobefit emit diffuse_sh --tier medium --to q30
 * Digest of the formula with its coefficients: ac21809a69907576 (FNV-1a 64 of `lobefit emit --to c`).
 *
 * Shape of diffuse_sh, medium, in 32-bit integers: inputs Q30, held at [0, 1]; results Q30 in [0, 1]. Each local's scale
 * stands beside it. Every product and shift rounds to nearest, ties up.
 * Difference to the same formula in double over [.02, 1], 1024 x 1024 points:
 *   2.04e-09 (2^-28.9) in c1n at 0x3b768bb7 0x02ff2630: got 0x1ccbef88, want 0.449947247457.
 * Difference to the same formula in double over [0, 1], 511 x 511 points, uniform in the logarithm:
 *   2.03e-09 (2^-28.9) in c1n at 0x00008000 0x001f0f0f: got 0x0a6e6a89, want 0.162989269183.
 * Proved by interval analysis: no value leaves 32 bits; the difference is at most 3.41e-09 over
 * [.02, 1] and 3.50e-09 over [0, 1]. */
#include "../lobe.h"
#include "../../core/q30.h"
#include "diffuse_sh.h"

lobe_diffuse_shape_q30 lobe_diffuse_shape_medium_q30(int32_t roughness, int32_t n_dot_v)
{
    const int32_t r = lobe_q_saturate(roughness);
    const int32_t v = lobe_q_saturate(n_dot_v);
    const int32_t t2 = 1073741824 - v;                 /* Q30 */
    const int32_t t3 = lobe_q_mul(t2, t2, 30);         /* Q30 */
    const int32_t t4 = lobe_q_mul(t3, t3, 30);         /* Q30 */
    const int32_t t5 = lobe_q_mul(t2, t4, 30);         /* Q30 */
    const int32_t t8 = lobe_q_mul(r, 165973472, 31);   /* Q32 */
    const int32_t t10 = lobe_q_mul(v, 1549595261, 31); /* Q32 */
    const int32_t t12 = t10 + 1143079806;              /* Q32 */
    const int32_t t13 = t8 + t12;                      /* Q32 */
    const int32_t t14 = lobe_q_mul(r, t13, 31);        /* Q31 */
    const int32_t t16 = t14 - 295511200;               /* Q31 */
    const int32_t t17 = lobe_q_mul(t5, t16, 31);       /* Q30 */
    const int32_t t19 = lobe_q_mul(r, 33977752, 31);   /* Q30 */
    const int32_t t21 = t19 + 295638432;               /* Q30 */
    const int32_t t22 = t17 + t21;                     /* Q30 */
    const int32_t t24 = lobe_q_mul(r, -80846184, 31);  /* Q30 */
    const int32_t t26 = t24 + 1258741764;              /* Q30 */
    const int32_t t27 = lobe_q_mul(t22, t26, 30);      /* Q30 */
    const int32_t t29 = lobe_q_mul(r, 187116160, 31);  /* Q32 */
    const int32_t t31 = t29 + 478101345;               /* Q32 */
    const int32_t t32 = lobe_q_mul(t5, t31, 31);       /* Q31 */
    const int32_t t34 = t32 + 23069874;                /* Q31 */
    const int32_t t35 = lobe_q_mul(r, t34, 31);        /* Q30 */
    const int32_t t37 = lobe_q_mul(v, 1554188419, 31); /* Q32 */
    const int32_t t39 = t37 + 669108862;               /* Q32 */
    const int32_t t40 = lobe_q_mul(r, t39, 31);        /* Q31 */
    const int32_t t42 = t40 - 171562656;               /* Q31 */
    const int32_t t43 = lobe_q_mul(t5, t42, 31);       /* Q30 */
    const int32_t t45 = lobe_q_mul(r, -27999240, 31);  /* Q30 */
    const int32_t t47 = t45 + 175429824;               /* Q30 */
    const int32_t t48 = t43 + t47;                     /* Q30 */
    const int32_t t50 = lobe_q_mul(t5, 635060994, 31); /* Q31 */
    const int32_t t52 = t50 + 12333992;                /* Q31 */
    const int32_t t53 = lobe_q_mul(r, t52, 31);        /* Q30 */
    lobe_diffuse_shape_q30 d;
    d.c00 = t22;
    d.c1n = t27;
    d.c1t = t35;
    d.c2n = t48;
    d.c2t = t53;
    d.c2tt = 0;
    return d;
}

LOBE_DIFFUSE_SH_Q30(medium)
