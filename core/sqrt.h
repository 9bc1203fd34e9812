/* Square root of x.
 *
 * Domain      x >= 0. Negative numbers, negative zero and NaN give 0; infinity counts as the largest float and
 *             gives 1.84467429e19: the result is always finite. A shader may take a denormal x for 0.
 * Error       0.50 ulp; measured at every float of the domain (make exhaustive), hardware and soft.
 *             Correctly rounded: the hardware's instruction where the target has one, else the same bits from
 *             integers (-Ofast may use an estimate: 3 ulp). Build with -fno-math-errno, or the compiler keeps a
 *             call of libm beside the instruction.
 * Operations  1 sqrt, 2 min/max. Soft: about 25 times 9 integer instructions. */
#ifndef LOBE_SQRT_H
#define LOBE_SQRT_H
#include "bits.h"

#define LOBE_SQRT_ULP 0.5

#if defined(LOBE_HOST) && !defined(LOBE_DOUBLE)
/* With no instruction __builtin_sqrtf would be a call of libm, which what ships does not make. */
#if defined(__x86_64__) || defined(__i386__) || defined(__aarch64__) || defined(__s390x__) || defined(__wasm__) ||     \
    defined(__riscv_flen) || defined(__mips_hard_float) || defined(_ARCH_PPCSQ) || defined(__powerpc64__) ||           \
    (defined(__ARM_FP) && (__ARM_FP & 4))
#define LOBE_SQRT_HARDWARE 1
#endif

/* Correctly rounded root of a number in [0, largest float]: one bit of the root a turn, as by hand, then the
 * remainder says whether the 25th bit rounds up. A tie cannot happen. */
static inline float lobe_sqrt_soft(float x)
{
    uint32_t b = lobe_bits_from_real(x);
    int32_t exponent = (int32_t)(b >> 23);
    uint32_t m = b & 0x7fffffu;
    uint32_t root = 0, trial = 0, bit;
    if (b == 0)
        return 0.0f;
    if (exponent == 0) { /* denormal */
        for (exponent = 1; m < 0x800000u; exponent--)
            m <<= 1;
    }
    m |= 0x800000u;
    exponent -= 127;
    if (exponent & 1) { /* an even exponent halves exactly */
        m <<= 1;
        exponent -= 1;
    }
    m <<= 1;
    for (bit = 0x1000000u; bit != 0; bit >>= 1) {
        const uint32_t next = trial + bit;
        if (next <= m) {
            trial = next + bit;
            m -= next;
            root += bit;
        }
        m <<= 1;
    }
    root += root & 1u; /* 25 bits to 24: a remainder of 0 has an even root, so this rounds to nearest */
    return lobe_real_from_bits((root >> 1) + ((uint32_t)(exponent / 2 + 126) << 23));
}
#endif

#if !defined(LOBE_TRACE) /* the tracer brings its own */
LOBE_FN lobe_real lobe_sqrt(lobe_real x)
{
    LOBE_LET c = lobe_clamp(x, LOBE_R(0.0), LOBE_R(3.40282347e+38));
#if defined(LOBE_DOUBLE) && !defined(LOBE_OPENCL)
    return __builtin_sqrt(c);
#elif defined(LOBE_HOST) && defined(LOBE_SQRT_HARDWARE)
    return __builtin_sqrtf(c);
#elif defined(LOBE_HOST)
    return lobe_sqrt_soft(c);
#else
    return sqrt(c);
#endif
}
#endif

#endif
