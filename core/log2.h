/* Logarithm of x to base 2.
 *
 * Domain      x > 0, normal. Zero, denormals, negative numbers and NaN count as 2^-126 and give -126;
 *             infinity counts as the largest float and gives 128: the result is always in [-126, 128].
 * Error       1.33 ulp at 0x1.6a3012p-1: got -0x1.ff6444p-2, want -0x1.ff6446a7a2541p-2;
 *             measured at every float of the domain (make exhaustive).
 *             Powers of two are exact.
 * Operations  12 add, 10 mul, 2 min/max, 1 conversion, 5 integer.
 * Source      x = 2^n m with m in [sqrt(1/2), sqrt(2)), f = m - 1; log2(1 + f) = f + f q(f), q of degree 9,
 *             minimax (Sollya's fpminimax, absolute error of q 1.4e-8). Adding f outside q keeps the last bits:
 *             f is exact, and f q(f) is less than half of it. */
#ifndef LOBE_LOG2_H
#define LOBE_LOG2_H
#include "bits.h"

#define LOBE_LOG2_ULP 1.4

#if defined(LOBE_TRACE) /* the tracer brings its own */
#elif defined(LOBE_DOUBLE)
LOBE_FN lobe_real lobe_log2(lobe_real x)
{
    LOBE_LET c = lobe_clamp(x, LOBE_R(1.1754943508222875e-38), LOBE_R(3.4028234663852886e+38));
#if defined(LOBE_OPENCL)
    return log2(c);
#else
    return __builtin_log2(c);
#endif
}
#else
LOBE_FN lobe_real lobe_log2(lobe_real x)
{
    LOBE_LET c = lobe_clamp(x, LOBE_R(1.17549435e-38), LOBE_R(3.40282347e+38));
    lobe_bits b = lobe_bits_from_real(c);
    /* 0x3f3504f3 is sqrt(1/2); the bias of 128 keeps the shifted number positive. */
    lobe_int n = lobe_int_from_bits((b + LOBE_U(0x40000000) - LOBE_U(0x3f3504f3)) >> 23) - 128;
    LOBE_LET m = lobe_real_from_bits(b - (lobe_bits_from_int(n) << 23));
    LOBE_LET f = m - LOBE_R(1.0);
    LOBE_LET q8 = LOBE_R(0.19131124) + f * LOBE_R(-0.118617907);
    LOBE_LET q7 = LOBE_R(-0.189817101) + f * q8;
    LOBE_LET q6 = LOBE_R(0.203583524) + f * q7;
    LOBE_LET q5 = LOBE_R(-0.239658371) + f * q6;
    LOBE_LET q4 = LOBE_R(0.288634837) + f * q5;
    LOBE_LET q3 = LOBE_R(-0.360697091) + f * q4;
    LOBE_LET q2 = LOBE_R(0.480896592) + f * q3;
    LOBE_LET q1 = LOBE_R(-0.721347332) + f * q2;
    LOBE_LET q0 = LOBE_R(0.442695051) + f * q1;
    LOBE_LET y = (lobe_real_from_int(n) + f) + f * q0;
    return y;
}
#endif

#endif
