/* Errors measured on growing subsets of the rows, since most candidates show on a few that they are hopeless.
 *
 * Levels go from coarse to fine, each a superset of the one before, so that a maximum over a level never exceeds the
 * maximum over a finer one. Then screening is exact: a candidate that is beaten on a coarse level is beaten. */
#ifndef LOBE_COARSE_TO_FINE_H
#define LOBE_COARSE_TO_FINE_H

#include "differential_evolution.h"
#include "nelder_mead.h"

typedef struct lobe_levels {
    /* The largest error of each candidate over the rows of a level. params: count x dim. */
    void (*f)(void *ctx, size_t level, const double *params, size_t count, double *values);
    void *ctx;
    size_t dim, levels; /* levels 0 .. levels - 1, at most LOBE_LEVELS_MAX */
    const size_t *rows; /* of each level, growing */
    const double *lower, *upper;
} lobe_levels;

#define LOBE_LEVELS_MAX 16

/* Rows 0 .. rows - 1 cut into nested levels by stride: level l has every (factor^(levels-1-l))-th row. Writes the
 * strides, and the number of rows of each. */
void lobe_levels_by_stride(size_t rows, size_t factor, size_t levels, size_t *strides, size_t *counts);

/* values[i]: exact where at most cutoffs[i], else the first level's maximum above cutoffs[i]. Returns the rows that
 * were looked at, or 0 without memory (values are then all infinite). */
size_t lobe_levels_screen(const lobe_levels *levels, const double *params, size_t count, const double *cutoffs,
                          double *values);

typedef struct lobe_level_estimate {
    double value;  /* maximum on the level reached: a lower bound of the truth */
    double growth; /* by how much the last refinement raised it */
    size_t level;  /* reached */
    size_t rows;   /* looked at */
} lobe_level_estimate;
/* Refines until a level raises the maximum by at most tolerance * value, or the finest is reached. */
lobe_level_estimate lobe_levels_estimate(const lobe_levels *levels, const double *params, double tolerance);

typedef struct lobe_coarse_to_fine_options {
    lobe_de_options global; /* runs with screening, on all levels */
    lobe_nm_options local;  /* polishes on every level from `polish_from` to the finest, each from the one before */
    size_t polish_from;
    bool screen; /* false: every candidate on the finest level; the results are the same */
} lobe_coarse_to_fine_options;

typedef struct lobe_coarse_to_fine_result {
    lobe_fit_result fit;              /* its value is on the finest level */
    double rows;                      /* looked at in all, polishes included */
    double on_level[LOBE_LEVELS_MAX]; /* the result's maximum on each level */
} lobe_coarse_to_fine_result;

lobe_coarse_to_fine_options lobe_coarse_to_fine_default(void);
lobe_coarse_to_fine_result lobe_coarse_to_fine(const lobe_levels *levels, const lobe_coarse_to_fine_options *options,
                                               double *x);

#endif
