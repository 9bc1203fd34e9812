/* Logarithm to base 2 in 32-bit integers. */
#ifndef LOBE_Q30_LOG2_H
#define LOBE_Q30_LOG2_H
#include "q30.h"

#define LOBE_Q_LOG2_ERROR 1.5e-8

/* log2 of the integer x, in [1, 2^31), with 26 fractional bits: in [0, 31). x < 1 counts as 1. For a number with n
 * fractional bits take n << 26 from the result. Error under 1.5e-8 (2^-26), measured at every
 * mantissa; powers of two are exact.
 *
 * x = 2^n (1 + f), f in [0, 1): log2 x = n + f g(f), g of degree 9 through log2(1 + f) / f at the Chebyshev points. */
static inline int32_t lobe_q_log2(int32_t x)
{
    const int32_t positive = x < 1 ? 1 : x;
    const int z = lobe_q_headroom(positive);
    const int32_t f = (int32_t)((uint32_t)positive << z) - LOBE_Q30_ONE; /* Q30 */
    const int32_t g9 = -4919973;                                         /* Q30 */
    const int32_t g8 = 30272977 + lobe_q_mul(f, g9, 30);
    const int32_t g7 = -87327349 + lobe_q_mul(f, g8, 30);
    const int32_t g6 = 163329379 + lobe_q_mul(f, g7, 30);
    const int32_t g5 = -236539665 + lobe_q_mul(f, g6, 30);
    const int32_t g4 = 304600243 + lobe_q_mul(f, g5, 30);
    const int32_t g3 = -386520997 + lobe_q_mul(f, g4, 30);
    const int32_t g2 = 516304548 + lobe_q_mul(f, g3, 30);
    const int32_t g1 = -774539339 + lobe_q_mul(f, g2, 30);
    const int32_t g0 = 1549081996 + lobe_q_mul(f, g1, 30);
    return (int32_t)((uint32_t)(30 - z) << 26) + lobe_q_mul(f, g0, 34);
}

#endif
