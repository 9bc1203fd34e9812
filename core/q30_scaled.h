/* Numbers with a block exponent, in 32-bit integers: for formulas whose terms span more than 30 bits.
 *
 * The value is m 2^(e - 30). Normalised, as every function here returns it: |m| in [2^29, 2^30), or m = 0 with e =
 * LOBE_QS_ZERO, far below every other exponent, so that alignment never shifts the other term away. Relative error of a
 * result at most 2^-28.9 (sum and difference: of the larger term, 2^-29); powers of two are exact.
 *
 * No overflow: mantissas are under 2^30 in magnitude, so a sum is under 2^31 and a product, shifted by 29, too.
 * Exponents are sums of those of the inputs: a formula of degree n in numbers with |e| <= 4096 keeps |e| under 4096 n +
 * 64 n, which bounds n at 2^19. A root or a quotient of 0 is 0; a divisor of 0 counts as 2^-100.
 *
 * Neither a 64-bit product nor a count of leading zeros is needed, and no division. */
#ifndef LOBE_Q30_SCALED_H
#define LOBE_Q30_SCALED_H
#include "q30.h"

#define LOBE_QS_ZERO (-4096)

typedef struct lobe_q_scaled {
    int32_t m, e;
} lobe_q_scaled;

/* A coefficient as an integer with that many fractional bits, when it is compiled. The float type of the coefficient's
 * literal does not matter: scaling by a power of two is exact, and the sum is in double. */
#define LOBE_Q_CONSTANT(x, bits)                                                                                       \
    ((int32_t)((double)(x) * (double)((int64_t)1 << (bits)) + ((double)(x) < 0.0 ? -0.5 : 0.5)))

/* The same as an initialiser of a lobe_q_scaled: LOBE_QS_EXPONENT(x) is the e with 2^(e - 1) <= |x| < 2^e, in [-11, 8];
 * |x| under 2^-12 counts as 0, 256 and more does not compile where overflow of a constant is an error. */
#define LOBE_QS_SIZE(x) ((double)(x) < 0.0 ? -(double)(x) : (double)(x))
#define LOBE_QS_LEAST (1.0 / 4096.0)
#define LOBE_QS_STEP(x, e) (LOBE_QS_SIZE(x) >= ((e) < 0 ? 1.0 / (double)(1 << (-(e)&31)) : (double)(1 << ((e)&31))))
#define LOBE_QS_EXPONENT(x)                                                                                            \
    (-11 + LOBE_QS_STEP(x, -11) + LOBE_QS_STEP(x, -10) + LOBE_QS_STEP(x, -9) + LOBE_QS_STEP(x, -8) +                   \
     LOBE_QS_STEP(x, -7) + LOBE_QS_STEP(x, -6) + LOBE_QS_STEP(x, -5) + LOBE_QS_STEP(x, -4) + LOBE_QS_STEP(x, -3) +     \
     LOBE_QS_STEP(x, -2) + LOBE_QS_STEP(x, -1) + LOBE_QS_STEP(x, 0) + LOBE_QS_STEP(x, 1) + LOBE_QS_STEP(x, 2) +        \
     LOBE_QS_STEP(x, 3) + LOBE_QS_STEP(x, 4) + LOBE_QS_STEP(x, 5) + LOBE_QS_STEP(x, 6) + LOBE_QS_STEP(x, 7))
#define LOBE_QS_CONSTANT(x)                                                                                            \
    {                                                                                                                  \
        LOBE_QS_SIZE(x) < LOBE_QS_LEAST ? 0 : LOBE_Q_CONSTANT(x, 30 - LOBE_QS_EXPONENT(x)),                            \
            LOBE_QS_SIZE(x) < LOBE_QS_LEAST ? LOBE_QS_ZERO : LOBE_QS_EXPONENT(x)                                       \
    }

LOBE_Q_INLINE lobe_q_scaled lobe_qs_made(int32_t m, int32_t e)
{
    lobe_q_scaled y;
    y.m = m;
    y.e = e;
    return y;
}

/* Cortex-M0 calls the larger functions, or a formula would take 13 KiB; and there a struct of two words comes back in
 * memory, but a 64-bit integer in registers. Elsewhere the compiler decides. */
#if defined(LOBE_Q_HALVES) && defined(__GNUC__)
#define LOBE_QS_FUNCTION static __attribute__((noinline, unused))
#else
#define LOBE_QS_FUNCTION static inline
#endif

LOBE_Q_INLINE uint64_t lobe_qs_packed(int32_t m, int32_t e) { return (uint64_t)(uint32_t)e << 32 | (uint32_t)m; }

LOBE_Q_INLINE lobe_q_scaled lobe_qs_unpacked(uint64_t y)
{
    return lobe_qs_made((int32_t)(uint32_t)y, (int32_t)(uint32_t)(y >> 32));
}

LOBE_QS_FUNCTION uint64_t lobe_qs_of_packed(int32_t m, int32_t e)
{
    const int32_t sign = m >> 31;
    const int32_t u = (m ^ sign) - sign;
    int32_t z;
    if (u >= LOBE_Q30_ONE)
        return lobe_qs_packed((((u >> 1) + (u & 1)) ^ sign) - sign, e + 1);
    if (u >= LOBE_Q30_ONE >> 1)
        return lobe_qs_packed(m, e);
    if (u == 0)
        return lobe_qs_packed(0, LOBE_QS_ZERO);
    z = lobe_q_headroom(u) - 1;
    return lobe_qs_packed((int32_t)((uint32_t)m << z), e - z);
}

/* m 2^(e - 30), |m| <= 2^31 - 2: exact up to 30 bits, 31 are rounded. */
LOBE_Q_INLINE lobe_q_scaled lobe_qs_of(int32_t m, int32_t e) { return lobe_qs_unpacked(lobe_qs_of_packed(m, e)); }

/* The product p, |p| <= 2^31 - 2, has 31 bits or 30: it is rounded to 30. */
LOBE_Q_INLINE uint64_t lobe_qs_rounded(int32_t p, int32_t e)
{
    if ((uint32_t)p + (uint32_t)(LOBE_Q30_ONE - 1) > 2u * (uint32_t)(LOBE_Q30_ONE - 1))
        return lobe_qs_packed((p + 1) >> 1, e);
    return lobe_qs_packed(p, e - 1);
}

LOBE_QS_FUNCTION uint64_t lobe_qs_mul_packed(lobe_q_scaled a, lobe_q_scaled b)
{
    return lobe_qs_rounded(lobe_q_mul(a.m, b.m, 29), a.e + b.e);
}

/* a b; 0 stays 0. */
LOBE_Q_INLINE lobe_q_scaled lobe_qs_mul(lobe_q_scaled a, lobe_q_scaled b)
{
    return lobe_qs_unpacked(lobe_qs_mul_packed(a, b));
}

LOBE_QS_FUNCTION uint64_t lobe_qs_add_packed(lobe_q_scaled a, lobe_q_scaled b)
{
    int32_t apart = a.e - b.e;
    if (apart > 0) {
        if (apart > 31)
            return lobe_qs_packed(a.m, a.e);
        return lobe_qs_of_packed(a.m + (((b.m >> (apart - 1)) + 1) >> 1), a.e);
    }
    if (apart < 0) {
        if (apart < -31)
            return lobe_qs_packed(b.m, b.e);
        return lobe_qs_of_packed(b.m + (((a.m >> (-1 - apart)) + 1) >> 1), b.e);
    }
    return lobe_qs_of_packed(a.m + b.m, a.e);
}

/* a + b */
LOBE_Q_INLINE lobe_q_scaled lobe_qs_add(lobe_q_scaled a, lobe_q_scaled b)
{
    return lobe_qs_unpacked(lobe_qs_add_packed(a, b));
}

LOBE_Q_INLINE lobe_q_scaled lobe_qs_negative(lobe_q_scaled a) { return lobe_qs_made(-a.m, a.e); }

LOBE_Q_INLINE lobe_q_scaled lobe_qs_sub(lobe_q_scaled a, lobe_q_scaled b)
{
    return lobe_qs_add(a, lobe_qs_negative(b));
}

/* a 2^n */
LOBE_Q_INLINE lobe_q_scaled lobe_qs_shifted(lobe_q_scaled a, int32_t n) { return lobe_qs_made(a.m, a.e + n); }

/* 3 a */
LOBE_Q_INLINE lobe_q_scaled lobe_qs_thrice(lobe_q_scaled a) { return lobe_qs_of(a.m + (a.m >> 1), a.e + 1); }

/* max(a, 0) */
LOBE_Q_INLINE lobe_q_scaled lobe_qs_positive(lobe_q_scaled a) { return a.m > 0 ? a : lobe_qs_made(0, LOBE_QS_ZERO); }

/* 1 if a < b. */
static inline int lobe_qs_less(lobe_q_scaled a, lobe_q_scaled b)
{
    if ((a.m ^ b.m) < 0 || a.m == 0 || b.m == 0 || a.e == b.e)
        return a.m < b.m;
    return (a.e < b.e) == (a.m > 0);
}

LOBE_QS_FUNCTION uint64_t lobe_qs_div_packed(lobe_q_scaled a, lobe_q_scaled b)
{
    const int32_t sign = b.m >> 31;
    lobe_q_inverse inverse;
    if (b.m == 0)
        return lobe_qs_packed(a.m, a.e + 100);
    inverse = lobe_q_reciprocal((b.m ^ sign) - sign); /* 2^59 / |m| */
    return lobe_qs_rounded(lobe_q_mul((a.m ^ sign) - sign, inverse.mantissa, 29), a.e - b.e + 1);
}

/* a / b */
LOBE_Q_INLINE lobe_q_scaled lobe_qs_div(lobe_q_scaled a, lobe_q_scaled b)
{
    return lobe_qs_unpacked(lobe_qs_div_packed(a, b));
}

/* u, in [1/4, 1), is m with an even exponent. The quadratic nearest to 1 / sqrt(u), within 2.4 %, and two Newton steps
 * in 16 bits give y to 2^-14; s = u y is the first half of the root, and the remainder u - s^2, which is exact in 32
 * bits, gives the other. */
LOBE_QS_FUNCTION uint64_t lobe_qs_sqrt_packed(lobe_q_scaled a)
{
    const int32_t odd = a.e & 1;
    const uint32_t u = (uint32_t)a.m << (2 - odd); /* Q32 */
    const uint32_t uh = (u >> 16) + 1;             /* Q16, at most 2^16 */
    uint32_t y, s;                                 /* Q15, Q16 */
    int32_t root;
    if (a.m <= 0)
        return lobe_qs_packed(0, LOBE_QS_ZERO);
    y = 87518u - ((uh * (107655u - ((uh * 53693u) >> 16))) >> 16);
    y = (y * ((3221225472u - ((y * y) >> 16) * uh) >> 16)) >> 15;
    y = y < 65535u ? y : 65535u;
    y = (y * ((3221225472u - ((y * y + 32768u) >> 16) * uh + 32768u) >> 16) + 16384u) >> 15;
    s = (uh * y) >> 15;
    root = (int32_t)(s << 14) + lobe_q_mul((int32_t)(u - s * s), (int32_t)y, 18) + 1; /* 0 to 3 too low without the 1 */
    return lobe_qs_packed(lobe_q_clamp(root, LOBE_Q30_ONE >> 1, LOBE_Q30_ONE - 1), (a.e + odd) >> 1);
}

/* The root; of a negative number 0. Relative error 2^-28.1. */
LOBE_Q_INLINE lobe_q_scaled lobe_qs_sqrt(lobe_q_scaled a) { return lobe_qs_unpacked(lobe_qs_sqrt_packed(a)); }

/* As an integer with that many fractional bits: rounded, held at the ends of int32_t; bits in [0, 40]. */
LOBE_QS_FUNCTION int32_t lobe_qs_fixed(lobe_q_scaled a, int32_t bits)
{
    const int32_t n = 30 - bits - a.e;
    if (n > 31)
        return 0;
    if (n > 0)
        return ((a.m >> (n - 1)) + 1) >> 1;
    if (n < -1)
        return a.m > 0 ? 0x7fffffff : a.m < 0 ? -0x7fffffff - 1 : 0;
    return (int32_t)((uint32_t)a.m << -n);
}

#endif
