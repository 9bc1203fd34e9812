/* Generated, not edited: lobefit emit diffuse_sh --tier zonal --to q30
 * Digest of the formula with its coefficients: 03074c465f6978c2 (FNV-1a 64 of `lobefit emit --to c`).
 *
 * Shape of diffuse_sh, zonal, in 32-bit integers: inputs Q30, held at [0, 1]; results Q30 in [0, 1]. Each local's scale
 * stands beside it. Every product and shift rounds to nearest, ties up.
 * Difference to the same formula in double over [.02, 1], 1024 x 1024 points:
 *   2.27e-09 (2^-28.7) in z1 at 0x38e3578e 0x02c05e2c: got 0x1cc40e91, want 0.449466365792.
 * Difference to the same formula in double over [0, 1], 511 x 511 points, uniform in the logarithm:
 *   2.29e-09 (2^-28.7) in z1 at 0x34b4b4b5 0x0005e1e2: got 0x1cb7fb47, want 0.448729345070.
 * Proved by interval analysis: no value leaves 32 bits; the difference is at most 3.64e-09 over
 * [.02, 1] and 3.78e-09 over [0, 1]. */
#include "../lobe.h"
#include "../../core/q30.h"
#include "diffuse_sh.h"

lobe_zonal_shape_q30 lobe_diffuse_shape_zonal_q30(int32_t roughness, int32_t n_dot_v)
{
    const int32_t r = lobe_q_saturate(roughness);
    const int32_t v = lobe_q_saturate(n_dot_v);
    const int32_t t3 = lobe_q_mul(v, 691769921, 31);    /* Q31 */
    const int32_t t5 = t3 + 610532223;                  /* Q31 */
    const int32_t t6 = lobe_q_mul(r, t5, 31);           /* Q30 */
    const int32_t t8 = t6 - 150326256;                  /* Q30 */
    const int32_t t10 = 1073741824 - v;                 /* Q30 */
    const int32_t t11 = lobe_q_mul(t10, t10, 30);       /* Q30 */
    const int32_t t12 = lobe_q_mul(t11, t11, 30);       /* Q30 */
    const int32_t t13 = lobe_q_mul(t10, t12, 30);       /* Q30 */
    const int32_t t14 = lobe_q_mul(t8, t13, 30);        /* Q30 */
    const int32_t t16 = lobe_q_mul(r, 34333988, 31);    /* Q30 */
    const int32_t t18 = t16 + 295739744;                /* Q30 */
    const int32_t t19 = t14 + t18;                      /* Q30 */
    const int32_t t21 = lobe_q_mul(t12, 172542576, 31); /* Q31 */
    const int32_t t23 = t21 - 81366216;                 /* Q31 */
    const int32_t t24 = lobe_q_mul(r, t23, 31);         /* Q30 */
    const int32_t t26 = t24 + 1257352320;               /* Q30 */
    const int32_t t27 = lobe_q_mul(t19, t26, 30);       /* Q30 */
    const int32_t t29 = lobe_q_mul(t12, 830545536, 31); /* Q32 */
    const int32_t t31 = t29 - 330116512;                /* Q32 */
    const int32_t t32 = lobe_q_mul(r, t31, 31);         /* Q31 */
    const int32_t t34 = t32 + 1270345728;               /* Q31 */
    const int32_t t35 = lobe_q_mul(t19, t34, 31);       /* Q30 */
    const int32_t t37 = lobe_q_mul(r, -2022399872, 31); /* Q32 */
    const int32_t t39 = t37 + 1978090494;               /* Q32 */
    const int32_t t40 = lobe_q_mul(t12, t39, 31);       /* Q31 */
    const int32_t t42 = t40 + 55961712;                 /* Q31 */
    const int32_t t43 = lobe_q_mul(r, t42, 31);         /* Q30 */
    lobe_zonal_shape_q30 d;
    d.z0 = t19;
    d.z1 = t27;
    d.z2 = t35;
    d.beta = t43;
    return d;
}

LOBE_DIFFUSE_ZONAL_Q30(zonal)
