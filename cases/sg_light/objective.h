/* The objective of fit_tiers.h over both sets of fit cells, as residuals and as their sum of squares. */
#ifndef LOBE_SG_LIGHT_OBJECTIVE_H
#define LOBE_SG_LIGHT_OBJECTIVE_H
#include <stdbool.h>
#include "cells.h"
#include "fit_tiers.h"

typedef struct lobe_sg_problem {
    const lobe_sg_tier *tier;
    size_t positions, rows; /* of a cell; residuals */
    lobe_sg *light;         /* a row each, as roughness, truth and weight of the error */
    double *roughness, *truth, *weight;
} lobe_sg_problem;

/* From uniform and mixed cells, each stride-th position. false: no memory. Free it either way. */
bool lobe_sg_problem_make(lobe_sg_problem *p, const lobe_sg_tier *tier, const lobe_sg_cells cells[2], int stride);
void lobe_sg_problem_free(lobe_sg_problem *p);

/* lobe_batch_fn's; ctx is a lobe_sg_problem. */
void lobe_sg_residuals(void *ctx, const double *params, size_t count, double *values);
void lobe_sg_sum(void *ctx, const double *params, size_t count, double *values);

#endif
