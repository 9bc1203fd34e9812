/* Sign and magnitude without a branch or a call. */
#ifndef LOBE_SIGN_H
#define LOBE_SIGN_H
#include "scalar.h"

/* |x|; NaN stays NaN, the sign of a zero stays. */
LOBE_FN lobe_real lobe_abs(lobe_real x)
{
    LOBE_LET minus = -x;
    return lobe_max(minus, x);
}

/* -1 where x < 0, else 1: never 0, also for zeros of both signs and NaN. */
LOBE_FN lobe_real lobe_sign(lobe_real x)
{
    LOBE_LET minus = -x;
    return lobe_select(minus, LOBE_R(-1.0), LOBE_R(1.0));
}

#endif
