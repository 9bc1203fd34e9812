/* Nelder-Mead: the local stage where there are no residuals, with the coefficients of Gao and Han (2012) that keep
 * it alive in many dimensions. Restarts from a fresh simplex undo a collapse; several starts, spread over the box,
 * undo a bad one. A simplex that is flat is repaired before use. */
#ifndef LOBE_NELDER_MEAD_H
#define LOBE_NELDER_MEAD_H

#include "objective.h"
#include "status.h"
#include <stdint.h>

typedef struct lobe_nm_options {
    double size;            /* first edge, as part of the parameter's range (of max(1, |x|) without bounds); (0, 1] */
    const double *simplex;  /* optional first simplex, (dim + 1) x dim, instead of x and size */
    size_t starts;          /* 1: from x alone; more: also from points of a Latin hypercube; these need bounds */
    size_t restarts;        /* at most this many, each from a fresh simplex around the best, while they help */
    double value_tolerance; /* a run ends where the values differ by <= this * |best| + 1e-300 ... */
    double size_tolerance;  /* ... and the vertices by <= this part of the scale of size */
    double target;          /* stop where the best value is at most this; -infinity: never */
    uint64_t seed;          /* of the further starts */
    size_t budget;          /* evaluations, at least dim + 2 for every start */
    lobe_progress_fn progress;
    void *progress_ctx;
} lobe_nm_options;

lobe_nm_options lobe_nm_default(void);
/* x: start in, best point out. options NULL: the defaults. */
lobe_fit_result lobe_nelder_mead(const lobe_objective *objective, const lobe_nm_options *options, double *x);

/* Makes a simplex of dim + 1 points non-degenerate: an edge from its first point that lies (nearly) in the span of
 * the edges before it is replaced by a step of scale[k] along the axis k that lies least in it; steps turn round at
 * an upper bound. Returns the number of replaced edges, or -1 without memory. upper may be NULL. */
int lobe_simplex_repair(double *simplex, size_t dim, const double *scale, const double *upper);

#endif
