/* Choices between scalars, spelled so that a NaN gives a documented result in every language.
 * lobe_min(a, b) and lobe_max(a, b) give b when either is NaN; lobe_clamp(NaN) gives lo. */
#ifndef LOBE_SCALAR_H
#define LOBE_SCALAR_H
#include "dialect.h"

#if !defined(LOBE_TRACE) /* the tracer brings its own, since a branch leaves no record */

LOBE_FN lobe_real lobe_min(lobe_real a, lobe_real b) { return a < b ? a : b; }

LOBE_FN lobe_real lobe_max(lobe_real a, lobe_real b) { return a > b ? a : b; }

/* x inside [lo, hi]; NaN gives lo. */
LOBE_FN lobe_real lobe_clamp(lobe_real x, lobe_real lo, lobe_real hi) { return lobe_min(lobe_max(x, lo), hi); }

/* x inside [0, 1]; NaN gives 0. A shader's compiler folds it into the instruction before. */
#if defined(LOBE_ARRAYS) && defined(LOBE_HOST) && !defined(LOBE_DOUBLE)
/* The same bits without a choice between floats, for the array functions: gcc 12 makes paths of those choices, copies
 * the polynomials behind them into each, and a vectorised loop then computes them all. Above 0 floats order as their
 * bits do. */
LOBE_FN lobe_real lobe_saturate(lobe_real x)
{
    union {
        float f;
        uint32_t bits;
        int32_t order;
    } u;
    u.f = x;
    u.bits &= 0u - (uint32_t)(x > 0.0f);
    u.order = u.order < 0x3f800000 ? u.order : 0x3f800000;
    return u.f;
}
#else
LOBE_FN lobe_real lobe_saturate(lobe_real x) { return lobe_clamp(x, LOBE_R(0.0), LOBE_R(1.0)); }
#endif

/* yes where test > 0, else no: also for a NaN test. Neither side may trap. */
LOBE_FN lobe_real lobe_select(lobe_real test, lobe_real yes, lobe_real no) { return test > LOBE_R(0.0) ? yes : no; }

#endif
#endif
