/* Fixed-point primitives in C, for kernels that have neither a float unit nor a divider.
 *
 * lobe_q30 is an int32_t with 30 fractional bits: the real number is x / 2^30, in [-2, 2), and 1 is exact. The
 * functions take plain int32_t, since generated kernels choose another scale for each intermediate result.
 *
 * Rounding is to nearest, ties towards plus infinity, everywhere: floor(exact + 1/2). Right shifts of negative
 * numbers are arithmetic, and a conversion to int32_t wraps, as on every compiler this library knows. Nothing here
 * divides, calls a run-time library, branches on data except where there is no count of leading zeros, or needs
 * more than a 32 x 32 -> 64 multiply. */
#ifndef LOBE_Q30_H
#define LOBE_Q30_H
#include <stdint.h>

typedef int32_t lobe_q30;

#define LOBE_Q30_ONE ((int32_t)1 << 30)

/* Thumb-1 (Cortex-M0, M0+, M23) multiplies 32 x 32 -> 32 only: a 64-bit product would call __aeabi_lmul. */
#if !defined(LOBE_Q_HALVES) && defined(__thumb__) && !defined(__thumb2__)
#define LOBE_Q_HALVES 1
#endif

/* A right shift leaves the rounding bit in the carry; C cannot say so. */
#if !defined(LOBE_Q_CARRY) && defined(LOBE_Q_HALVES) && defined(__GNUC__) && defined(__OPTIMIZE__) &&                  \
    defined(__thumb__) && !defined(__thumb2__)
#define LOBE_Q_CARRY 1
#endif

/* A multiply has its shift as a constant; out of line it would test it at run time. */
#if defined(__GNUC__)
#define LOBE_Q_INLINE static inline __attribute__((always_inline))
#else
#define LOBE_Q_INLINE static inline
#endif

/* Where __builtin_clz is an instruction or two; elsewhere it would call libgcc. */
#if !defined(LOBE_Q_NO_CLZ) && defined(__GNUC__) &&                                                                    \
    (defined(__x86_64__) || defined(__i386__) || defined(__aarch64__) || defined(__ARM_FEATURE_CLZ) ||                 \
     defined(__s390x__) || defined(__powerpc__) || defined(__wasm__) || (defined(__mips__) && __mips >= 32))
#define LOBE_Q_CLZ 1
#endif

/* The general product in 64 bits. shift in [0, 62]; the low 32 bits of the rounded result. */
LOBE_Q_INLINE int32_t lobe_q_mul_wide(int32_t a, int32_t b, int shift)
{
    const int64_t product = (int64_t)a * b;
    return (int32_t)(shift > 0 ? (product + ((int64_t)1 << (shift - 1))) >> shift : product);
}

/* The low half; gcc spends two shifts on it where one uxth would do. */
LOBE_Q_INLINE uint32_t lobe_q_low_half(int32_t a)
{
#if defined(LOBE_Q_CARRY) && defined(__ARM_ARCH) && __ARM_ARCH >= 6
    if (!__builtin_constant_p(a)) {
        uint32_t half;
        __asm__("uxth %0, %1" : "=l"(half) : "l"(a));
        return half;
    }
#endif
    return (uint32_t)a & 0xffffu;
}

/* The same without a 64-bit product. With a = ah 2^16 + al (ah signed, al not), b likewise:
 *   a b / 2^16 = ah bh 2^16 + ah bl + al bh + al bl / 2^16
 * For shift in [17, 31] bits under 2^16 drop out, since the rounding bit lies above them. No sum overflows:
 * 65535 * 32767 + 65535 < 2^31. */
LOBE_Q_INLINE int32_t lobe_q_mul_halves(int32_t a, int32_t b, int shift)
{
    const uint32_t al = lobe_q_low_half(a), bl = lobe_q_low_half(b);
    const int32_t ah = a >> 16, bh = b >> 16;
    const int32_t mid = (int32_t)al * bh + (int32_t)((al * bl) >> 16);
    const int32_t side = ah * (int32_t)bl + (int32_t)lobe_q_low_half(mid);
    const uint32_t high = (uint32_t)(ah * bh) + (uint32_t)(mid >> 16);
    if (shift >= 17 && shift <= 31) {
        uint32_t sum = high << (32 - shift);
#if defined(LOBE_Q_CARRY)
        if (__builtin_constant_p(shift)) {
            int32_t rest = side;
            __asm__(".syntax unified\n\tasrs %1, %1, %2\n\tadcs %0, %0, %1"
                    : "+l"(sum), "+l"(rest)
                    : "i"(shift - 16)
                    : "cc");
            return (int32_t)sum;
        }
#endif
        sum += (uint32_t)(side >> (shift - 16)) + ((uint32_t)(side >> (shift - 17)) & 1u);
        return (int32_t)sum;
    }
    /* The rest needs all 64 bits: top and low. */
    const int32_t top = (int32_t)(high + (uint32_t)(side >> 16));
    const uint32_t low = (uint32_t)a * (uint32_t)b;
    if (shift > 32)
        return (top >> (shift - 32)) + ((top >> (shift - 33)) & 1);
    if (shift == 32)
        return (int32_t)((uint32_t)top + (low >> 31));
    return (int32_t)(shift > 0 ? ((uint32_t)top << (32 - shift)) + (low >> shift) + ((low >> (shift - 1)) & 1u) : low);
}

/* (a * b) / 2^shift, rounded. shift in [0, 62], best a constant; the result must fit in 32 bits (else it wraps).
 * Error at most 1/2 unit. Both spellings give the same bits. In line 16 to 18 instructions on Cortex-M0, 5 on M3
 * and up. */
LOBE_Q_INLINE int32_t lobe_q_mul(int32_t a, int32_t b, int shift)
{
#if defined(LOBE_Q_HALVES)
    return lobe_q_mul_halves(a, b, shift);
#else
    return lobe_q_mul_wide(a, b, shift);
#endif
}

/* a / 2^n, rounded; n in [0, 31]. No overflow for any a. Error at most 1/2 unit. */
LOBE_Q_INLINE int32_t lobe_q_shift_right(int32_t a, int n) { return n > 0 ? (a >> n) + ((a >> (n - 1)) & 1) : a; }

static inline int32_t lobe_q_min(int32_t a, int32_t b) { return a < b ? a : b; }

static inline int32_t lobe_q_max(int32_t a, int32_t b) { return a > b ? a : b; }

static inline int32_t lobe_q_clamp(int32_t x, int32_t lo, int32_t hi) { return lobe_q_min(lobe_q_max(x, lo), hi); }

/* x inside [0, 1], as Q30. */
static inline int32_t lobe_q_saturate(int32_t x) { return lobe_q_clamp(x, 0, LOBE_Q30_ONE); }

/* a + b and a - b, held at the ends of int32_t. */
static inline int32_t lobe_q_add_saturated(int32_t a, int32_t b)
{
    const int32_t sum = (int32_t)((uint32_t)a + (uint32_t)b);
    const int32_t end = (int32_t)(0x7fffffffu + ((uint32_t)a >> 31));
    return ((a ^ sum) & (b ^ sum)) < 0 ? end : sum;
}

static inline int32_t lobe_q_subtract_saturated(int32_t a, int32_t b)
{
    const int32_t difference = (int32_t)((uint32_t)a - (uint32_t)b);
    const int32_t end = (int32_t)(0x7fffffffu + ((uint32_t)a >> 31));
    return ((a ^ b) & (a ^ difference)) < 0 ? end : difference;
}

/* a * 2^n, held at the ends of int32_t; n in [0, 30]. */
static inline int32_t lobe_q_shift_left_saturated(int32_t a, int n)
{
    const int32_t hi = 0x7fffffff >> n;
    const int32_t end = (int32_t)(0x7fffffffu + ((uint32_t)a >> 31));
    return a > hi || a < -hi - 1 ? end : (int32_t)((uint32_t)a << n);
}

/* Q16.16 holds what is unbounded (radiance). Into it: rounded, cannot overflow. Out of it: held at [-2, 2). */
static inline int32_t lobe_q16_from_q30(int32_t x) { return lobe_q_shift_right(x, 14); }

static inline int32_t lobe_q30_from_q16(int32_t x) { return lobe_q_shift_left_saturated(x, 14); }

/* How far x, in [1, 2^31), can be shifted left and stay positive: 30 - floor(log2 x). */
static inline int lobe_q_headroom(int32_t x)
{
#if defined(LOBE_Q_CLZ)
    return __builtin_clz((unsigned)x) - 1;
#else
    uint32_t u = (uint32_t)x;
    int n = 0;
    if (u < (uint32_t)1 << 15) {
        u <<= 16;
        n += 16;
    }
    if (u < (uint32_t)1 << 23) {
        u <<= 8;
        n += 8;
    }
    if (u < (uint32_t)1 << 27) {
        u <<= 4;
        n += 4;
    }
    if (u < (uint32_t)1 << 29) {
        u <<= 2;
        n += 2;
    }
    return u < (uint32_t)1 << 30 ? n + 1 : n;
#endif
}

/* 1 / x as an integer: mantissa / 2^shift, mantissa in [2^29, 2^30], shift in [30, 60]. */
typedef struct lobe_q_inverse {
    int32_t mantissa;
    int shift;
} lobe_q_inverse;

/* The reciprocal of the integer x >= 1; x < 1 counts as 1.
 * With z = lobe_q_headroom(x) and m = x << z, in [2^30, 2^31):
 *   shift = 60 - z,   mantissa = floor(2^60 / m + 1/2)   exactly,
 * so 1/x = mantissa / 2^shift within a relative error of 2^-30, and powers of two are exact. The exactness makes
 * other implementations (a hardware divider, a tool that predicts results) interchangeable with this one.
 * Cost: 10 multiplies 32 x 32 -> 32, about 50 instructions on Cortex-M0 after the normalisation.
 *
 * How: d = m / 2^31 in [1/2, 1). Seed p(d) = (256 d^2 - 576 d + 420) / 99, the minimax quadratic to 1/d, relative
 * error 1/99 (1 - d p(d) is the Chebyshev polynomial T3(4 d - 3) / -99). A Newton step in 16 bits leaves
 * |t| = |1 - d x| < 2^-12. Then 1/d = x / (1 - t) = x (1 + t + t^2) to 2^-36. The estimate is biased to stay under
 * the exact value by 0 to 1.4 units, and the remainder, whose low 32 bits are enough, rounds it. */
static inline lobe_q_inverse lobe_q_reciprocal(int32_t x)
{
    const int32_t positive = x < 1 ? 1 : x;
    const int z = lobe_q_headroom(positive);
    const uint32_t m = (uint32_t)positive << z;
    const uint32_t mh = m >> 15, ml = m & 0x7fffu;                                   /* d, 16 bits and the rest */
    const uint32_t seed = 139016u - ((mh * (47663u - ((mh * 21184u) >> 16))) >> 14); /* 15 fractional bits */
    const uint32_t x1 = (seed * (131072u - ((mh * seed) >> 15))) >> 16;              /* 15 */
    const int32_t t = (int32_t)(0u - (((mh * x1) << 3) + ((ml * x1) >> 12)));        /* 34, |t| < 2^22 */
    const int32_t t_short = t >> 12;                                                 /* 22 */
    const int32_t u = t + ((t_short * t_short) >> 10) - 3;                           /* 34 */
    const int32_t step = ((int32_t)x1 * (u >> 10) + (int32_t)((x1 * ((uint32_t)u & 1023u)) >> 10)) >> 10; /* 29 */
    const uint32_t y = (x1 << 14) + (uint32_t)step;
    const uint32_t remainder = 0u - m * y; /* 2^60 - m y, in [0, 1.4 m) */
    lobe_q_inverse inverse;
    inverse.mantissa = (int32_t)(y + (remainder >= (m + 1) >> 1 ? 1u : 0u));
    inverse.shift = 60 - z;
    return inverse;
}

/* n / d as Q30 for |n| <= d, where inverse = lobe_q_reciprocal(d): n and d have any common scale.
 * Error at most 1.5 units (2^-29.4); n = d gives exactly 1 or 1 minus a unit. The shift of the product is a
 * constant, so this costs one multiply and one shift more than the reciprocal. */
static inline int32_t lobe_q_ratio(int32_t n, lobe_q_inverse inverse)
{
    const int32_t aligned = (int32_t)((uint32_t)n << (60 - inverse.shift));
    return lobe_q_mul(aligned, inverse.mantissa, 30);
}

/* n / d with `fraction` fractional bits in the result, held at the ends of int32_t: for quotients that may exceed
 * 1. fraction in [0, 30]. Relative error of the reciprocal, 2^-30, plus half a unit. Needs 64-bit shifts. */
static inline int32_t lobe_q_quotient(int32_t n, lobe_q_inverse inverse, int fraction)
{
    const int shift = inverse.shift - fraction; /* [0, 60] */
    const int64_t product = (int64_t)n * inverse.mantissa;
    const int64_t value = shift > 0 ? (product + ((int64_t)1 << (shift - 1))) >> shift : product;
    return value > 0x7fffffff ? 0x7fffffff : value < -0x7fffffff - 1 ? -0x7fffffff - 1 : (int32_t)value;
}

#endif
