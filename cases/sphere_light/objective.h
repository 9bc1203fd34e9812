/* The objective of fit_tiers.h over both sets of fit cells, as residuals and as their sum of squares. */
#ifndef LOBE_SPHERE_LIGHT_OBJECTIVE_H
#define LOBE_SPHERE_LIGHT_OBJECTIVE_H
#include <stdbool.h>
#include "cells.h"
#include "fit_tiers.h"

/* One set of cells, thinned and prepared. */
typedef struct lobe_sphere_set {
    lobe_sphere *light;      /* a position each */
    double *roughness;       /* a cell each, as all that follows */
    double *truth, *weight;  /* of a position; of the error of one */
    double *energy, *excess; /* the sum of the truth; what the cell's error may be, infinite where nothing is held */
    double part;             /* what the set counts in the whole */
} lobe_sphere_set;

typedef struct lobe_sphere_problem {
    const lobe_sphere_tier *tier;
    size_t positions, rows; /* of a cell; residuals */
    lobe_sphere_set set[2];
} lobe_sphere_problem;

/* From uniform and mixed cells, each stride-th position. false: no memory. Free it either way. */
bool lobe_sphere_problem_make(lobe_sphere_problem *p, const lobe_sphere_tier *tier, const lobe_sphere_cells cells[2],
                              int stride);
void lobe_sphere_problem_free(lobe_sphere_problem *p);

/* lobe_batch_fn's; ctx is a lobe_sphere_problem. */
void lobe_sphere_residuals(void *ctx, const double *params, size_t count, double *values);
void lobe_sphere_sum(void *ctx, const double *params, size_t count, double *values);

#endif
