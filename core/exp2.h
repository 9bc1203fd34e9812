/* 2 to the power x.
 *
 * Domain      any number. x < -126 gives 0 (no denormal results, which many GPUs would flush); NaN gives 0;
 *             x > 127.999992 gives what 127.999992 gives, 3.40280561e38: the result is always finite.
 * Error       1.16 ulp at 0x1.fffe96p-2: got 0x1.6a099p+0, want 0x1.6a098db15fb73p+0;
 *             measured at every float of the domain (make exhaustive).
 *             Whole numbers are exact.
 * Operations  8 add, 6 mul, 2 min/max, 1 select, 2 conversions, 3 integer.
 * Source      x = n + f with n whole and |f| <= 1/2; 2^f = 1 + f q(f), q of degree 5, minimax in relative error
 *             with coefficients in float (Sollya's fpminimax, 3.6e-9); n goes into the exponent as an integer.
 *             No magic-number rounding, so -Ofast cannot break it. */
#ifndef LOBE_EXP2_H
#define LOBE_EXP2_H
#include "bits.h"

#define LOBE_EXP2_ULP 1.2

#if defined(LOBE_TRACE) /* the tracer brings its own */
#elif defined(LOBE_DOUBLE)
LOBE_FN lobe_real lobe_exp2(lobe_real x)
{
    LOBE_LET c = lobe_clamp(x, LOBE_R(-126.0), LOBE_R(127.99999237060547));
#if defined(LOBE_OPENCL)
    LOBE_LET y = exp2(c);
#else
    LOBE_LET y = __builtin_exp2(c);
#endif
    return x >= LOBE_R(-126.0) ? y : LOBE_R(0.0);
}
#else
LOBE_FN lobe_real lobe_exp2(lobe_real x)
{
    LOBE_LET c = lobe_clamp(x, LOBE_R(-126.0), LOBE_R(127.999992));
    LOBE_LET up = c + LOBE_R(256.5);
    lobe_int n = lobe_int_from_real(up) - 256;
    LOBE_LET f = c - lobe_real_from_int(n);
    LOBE_LET p5 = LOBE_R(0.00133913022) + f * LOBE_R(0.000152412846);
    LOBE_LET p4 = LOBE_R(0.00961883366) + f * p5;
    LOBE_LET p3 = LOBE_R(0.0555035882) + f * p4;
    LOBE_LET p2 = LOBE_R(0.240226448) + f * p3;
    LOBE_LET p1 = LOBE_R(0.693147182) + f * p2;
    LOBE_LET y = LOBE_R(1.0) + f * p1;
    LOBE_LET scaled = lobe_real_from_bits(lobe_bits_from_real(y) + (lobe_bits_from_int(n) << 23));
    return x >= LOBE_R(-126.0) ? scaled : LOBE_R(0.0);
}
#endif

#endif
