/* Generated, not edited: lobefit emit diffuse_sh --tier low --to q30
 * Digest of the formula with its coefficients: 04b00bb7a1b59c69 (FNV-1a 64 of `lobefit emit --to c`).
 *
 * Shape of diffuse_sh, low, in 32-bit integers: inputs Q30, held at [0, 1]; results Q30 in [0, 1]. Each local's scale
 * stands beside it. Every product and shift rounds to nearest, ties up.
 * Difference to the same formula in double over [.02, 1], 1024 x 1024 points:
 *   1.95e-09 (2^-28.9) in c1n at 0x2be3eebe 0x036d0437: got 0x18a65363, want 0.385151714926.
 * Difference to the same formula in double over [0, 1], 511 x 511 points, uniform in the logarithm:
 *   1.96e-09 (2^-28.9) in c1n at 0x0001e1e2 0x0005e1e2: got 0x0a16192e, want 0.157598774779.
 * Proved by interval analysis: no value leaves 32 bits; the difference is at most 2.43e-09 over
 * [.02, 1] and 2.48e-09 over [0, 1]. */
#include "../lobe.h"
#include "../../core/q30.h"
#include "diffuse_sh.h"

lobe_diffuse_shape_q30 lobe_diffuse_shape_low_q30(int32_t roughness, int32_t n_dot_v)
{
    const int32_t r = lobe_q_saturate(roughness);
    const int32_t v = lobe_q_saturate(n_dot_v);
    const int32_t t2 = 1073741824 - v;                   /* Q30 */
    const int32_t t3 = lobe_q_mul(t2, t2, 30);           /* Q30 */
    const int32_t t4 = lobe_q_mul(t3, t3, 30);           /* Q30 */
    const int32_t t5 = lobe_q_mul(t2, t4, 30);           /* Q30 */
    const int32_t t8 = lobe_q_mul(r, 1269159297, 31);    /* Q31 */
    const int32_t t10 = t8 - 302684863;                  /* Q31 */
    const int32_t t11 = lobe_q_mul(t5, t10, 31);         /* Q30 */
    const int32_t t13 = lobe_q_mul(r, 30613380, 31);     /* Q30 */
    const int32_t t15 = t13 + 297754944;                 /* Q30 */
    const int32_t t16 = t11 + t15;                       /* Q30 */
    const int32_t t18 = lobe_q_mul(t16, 1238388483, 30); /* Q30 */
    const int32_t t20 = lobe_q_mul(t5, 568685698, 31);   /* Q31 */
    const int32_t t22 = t20 + 16968578;                  /* Q31 */
    const int32_t t23 = lobe_q_mul(r, t22, 31);          /* Q30 */
    const int32_t t25 = lobe_q_mul(r, -280680096, 31);   /* Q31 */
    const int32_t t27 = t25 + 1265455744;                /* Q31 */
    const int32_t t28 = lobe_q_mul(t16, t27, 31);        /* Q30 */
    const int32_t t30 = lobe_q_mul(t23, 1152502913, 30); /* Q30 */
    lobe_diffuse_shape_q30 d;
    d.c00 = t16;
    d.c1n = t18;
    d.c1t = t23;
    d.c2n = t28;
    d.c2t = t30;
    d.c2tt = 0;
    return d;
}

LOBE_DIFFUSE_SH_Q30(low)
