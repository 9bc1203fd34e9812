/* Generated, not edited: lobefit emit diffuse_sh --tier zonal_low --to q30
 * Digest of the formula with its coefficients: 15fada787724e020 (FNV-1a 64 of `lobefit emit --to c`).
 *
 * Shape of diffuse_sh, zonal_low, in 32-bit integers: inputs Q30, held at [0, 1]; results Q30 in [0, 1]. Each local's scale
 * stands beside it. Every product and shift rounds to nearest, ties up.
 * Difference to the same formula in double over [.02, 1], 1024 x 1024 points:
 *   1.93e-09 (2^-28.9) in z1 at 0x3488f949 0x0147ae14: got 0x1c89deaf, want 0.445914906381.
 * Difference to the same formula in double over [0, 1], 511 x 511 points, uniform in the logarithm:
 *   2.17e-09 (2^-28.8) in z1 at 0x00000022 0x000ad2d3: got 0x0a19a47b, want 0.157815096271.
 * Proved by interval analysis: no value leaves 32 bits; the difference is at most 2.93e-09 over
 * [.02, 1] and 3.03e-09 over [0, 1]. */
#include "../lobe.h"
#include "../../core/q30.h"
#include "diffuse_sh.h"

lobe_zonal_shape_q30 lobe_diffuse_shape_zonal_low_q30(int32_t roughness, int32_t n_dot_v)
{
    const int32_t r = lobe_q_saturate(roughness);
    const int32_t v = lobe_q_saturate(n_dot_v);
    const int32_t t2 = lobe_q_mul(r, 656773057, 31);     /* Q30 */
    const int32_t t4 = t2 - 152680400;                   /* Q30 */
    const int32_t t7 = 1073741824 - v;                   /* Q30 */
    const int32_t t8 = lobe_q_mul(t7, t7, 30);           /* Q30 */
    const int32_t t9 = lobe_q_mul(t8, t8, 30);           /* Q30 */
    const int32_t t10 = lobe_q_mul(t7, t9, 30);          /* Q30 */
    const int32_t t11 = lobe_q_mul(t4, t10, 30);         /* Q30 */
    const int32_t t13 = lobe_q_mul(r, 23820264, 31);     /* Q30 */
    const int32_t t15 = t13 + 298763936;                 /* Q30 */
    const int32_t t16 = t11 + t15;                       /* Q30 */
    const int32_t t18 = lobe_q_mul(t16, 1241229947, 30); /* Q30 */
    const int32_t t20 = lobe_q_mul(t16, 1208107649, 31); /* Q30 */
    const int32_t t22 = lobe_q_mul(t9, 1180058624, 31);  /* Q31 */
    const int32_t t24 = t22 + 57903316;                  /* Q31 */
    const int32_t t25 = lobe_q_mul(r, t24, 31);          /* Q30 */
    lobe_zonal_shape_q30 d;
    d.z0 = t16;
    d.z1 = t18;
    d.z2 = t20;
    d.beta = t25;
    return d;
}

LOBE_DIFFUSE_ZONAL_Q30(zonal_low)
