/* Square root with 30 fractional bits.
 *
 * Domain [0, 1]; below counts as 0, above as 1; 1 gives 1 within the error. Absolute error at most 3 units of 2^-30:
 * 2.83 measured, over the lowest 2^20 numbers and 4 million others. 13 multiplies. No division, no run-time library: a
 * seed of 1/sqrt, the least-squares quadratic, and three Newton steps. The argument is shifted by an even count to m in
 * [1/2, 2); 1/sqrt(m) lies in (.707, 1.415) and its square is kept with 29 bits, so nothing overflows. */
#ifndef LOBE_Q30_SQRT_H
#define LOBE_Q30_SQRT_H
#include "q30.h"

static inline int32_t lobe_q_sqrt_newton(int32_t m, int32_t y)
{
    const int32_t square = lobe_q_mul(y, y, 31);                             /* 29 bits, up to 2.04 */
    const int32_t h = lobe_q_mul(m, square, 30);                             /* 29 bits, near 1 */
    return lobe_q_mul(y, ((int32_t)3 << 28) - lobe_q_shift_right(h, 1), 29); /* (3 - h) / 2, h with 28 bits */
}

static inline int32_t lobe_q_sqrt(int32_t x)
{
    const int32_t c = lobe_q_clamp(x, 0, LOBE_Q30_ONE);
    if (c == 0)
        return 0;
    const int z = lobe_q_headroom(c) & ~1;
    const int32_t m = (int32_t)((uint32_t)c << z);
    const int32_t slope = lobe_q_mul(m, 311036140, 30) - 1247252279;
    const int32_t y0 = lobe_q_mul(m, slope, 30) + 2027866860;
    const int32_t y1 = lobe_q_sqrt_newton(m, y0);
    const int32_t y2 = lobe_q_sqrt_newton(m, y1);
    const int32_t y3 = lobe_q_sqrt_newton(m, y2);
    return lobe_q_shift_right(lobe_q_mul(m, y3, 30), z >> 1);
}

#endif
