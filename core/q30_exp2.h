/* 2 to a negative power of a number with a block exponent, in 32-bit integers. */
#ifndef LOBE_Q30_EXP2_H
#define LOBE_Q30_EXP2_H
#include "q30_scaled.h"

/* 2^-x; x below 0 counts as 0, and from 127 on the result is 0. Relative error under 5e-8 (2^-24.2), of which 4e-8 are
 * the 24 fractional bits that x is held to.
 *
 * -x = -n + f with n whole and f in [0, 1): 2^f = 1 + f g(f), g of degree 6 through (2^f - 1) / f at the Chebyshev
 * points, 1.2e-10. */
static inline lobe_q_scaled lobe_qs_exp2_minus(lobe_q_scaled x)
{
    const int32_t x24 = lobe_q_max(lobe_qs_fixed(x, 24), 0);
    const int32_t n = (x24 >> 24) + ((x24 & 0xffffff) != 0);
    const int32_t f = (int32_t)((((uint32_t)n << 24) - (uint32_t)x24) << 6); /* Q30 */
    const int32_t g6 = 22261;
    const int32_t g5 = 156870 + lobe_q_mul(f, g6, 30);
    const int32_t g4 = 1437639 + lobe_q_mul(f, g5, 30);
    const int32_t g3 = 10325273 + lobe_q_mul(f, g4, 30);
    const int32_t g2 = 59597438 + lobe_q_mul(f, g3, 30);
    const int32_t g1 = 257941225 + lobe_q_mul(f, g2, 30);
    const int32_t g0 = 744261118 + lobe_q_mul(f, g1, 30);
    if (x24 >= (int32_t)127 << 24)
        return lobe_qs_made(0, LOBE_QS_ZERO);
    return lobe_qs_of((LOBE_Q30_ONE >> 1) + lobe_q_mul(f, g0, 31), 1 - n);
}

#endif
