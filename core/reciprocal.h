/* 1 / x for positive x.
 *
 * Domain      [2^-126, 2^126]. x outside it counts as the nearer end, so that 0, negative numbers and NaN give
 *             2^126 and infinity gives 2^-126: the result is always finite, normal and positive.
 * Error       0.50 ulp; measured at every float of the domain (make exhaustive).
 *             Correctly rounded wherever division is: C, and OpenCL on processors. Vulkan promises 2.5 ulp.
 * Operations  1 div, 2 min/max. */
#ifndef LOBE_RECIPROCAL_H
#define LOBE_RECIPROCAL_H
#include "scalar.h"

#define LOBE_RECIPROCAL_ULP 0.5

LOBE_FN lobe_real lobe_reciprocal(lobe_real x)
{
    LOBE_LET c = lobe_clamp(x, LOBE_R(1.17549435e-38), LOBE_R(8.50705917e+37));
    LOBE_LET y = LOBE_R(1.0) / c;
    return y;
}

#endif
