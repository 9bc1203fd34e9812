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
LOBE_FN lobe_real lobe_saturate(lobe_real x) { return lobe_clamp(x, LOBE_R(0.0), LOBE_R(1.0)); }

/* yes where test > 0, else no: also for a NaN test. Neither side may trap. */
LOBE_FN lobe_real lobe_select(lobe_real test, lobe_real yes, lobe_real no) { return test > LOBE_R(0.0) ? yes : no; }

#endif
#endif
