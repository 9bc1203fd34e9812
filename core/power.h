/* Powers: the fifth, which Schlick's Fresnel wants, and any. */
#ifndef LOBE_POWER_H
#define LOBE_POWER_H
#include "exp2.h"
#include "log2.h"

#define LOBE_POW5_ULP 3.0

/* x^5.
 * Domain      any number with a normal result, |x| in [2^-25, 2^25]; outside as IEEE multiplication has it (NaN
 *             stays NaN), so saturate x first.
 * Error       2.93 ulp at 0x1.7fffe2p-25: got 0x1.e5ff48p-123, want 0x1.e5ff42281da9cp-123;
 *             measured at every float of the domain (make exhaustive).
 * Operations  3 mul. */
LOBE_FN lobe_real lobe_pow5(lobe_real x)
{
    LOBE_LET x2 = x * x;
    LOBE_LET x4 = x2 * x2;
    LOBE_LET x5 = x4 * x;
    return x5;
}

/* x^y = 2^(y log2 x).
 * Domain      x > 0 with what lobe_log2 makes of the rest: 0 counts as 2^-126, so that x <= 0 gives about 0 for
 *             y >= 1 and exactly 1 for y = 0; the result is always finite, as lobe_exp2 has it.
 * Error       relative, at most LOBE_POW_RELATIVE (1 + |y log2 x|): rounding the logarithm costs more the further
 *             the result is from 1. Measured over 2^24 random pairs with |y log2 x| < 126: 1.19e-7 (1 + |y log2 x|) at
 *             x = 0x1.403e3p+16, y = -0x1.ff5f06p+1.
 * Operations  lobe_log2, lobe_exp2 and 1 mul. */
#define LOBE_POW_RELATIVE 1.7e-7 /* times (1 + |y log2 x|) */
LOBE_FN lobe_real lobe_pow(lobe_real x, lobe_real y)
{
    LOBE_LET e = y * lobe_log2(x);
    return lobe_exp2(e);
}

#endif
