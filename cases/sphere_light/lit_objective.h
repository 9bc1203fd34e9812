/* The objective of lit_tiers.h over both sets of fit cells, as residuals and as their sum of squares: the mean over the
 * cells of a set, added over the sets. */
#ifndef LOBE_SPHERE_LIGHT_LIT_OBJECTIVE_H
#define LOBE_SPHERE_LIGHT_LIT_OBJECTIVE_H
#include "cells.h"
#include "lit_tiers.h"

/* One set of cells, thinned and prepared. The errors under a radiance that is given are a parabola in schlick: with all
 * f0 together slope schlick + offset, and a rest that no schlick takes away. */
typedef struct lobe_sphere_lit_set {
    lobe_sphere *light;                    /* a position each */
    double *truth, *dark, *slope, *offset; /* a position each */
    double *roughness, *weight;            /* a cell each; and F0S of a cell, of the errors under its own radiance */
} lobe_sphere_lit_set;

typedef struct lobe_sphere_lit_problem {
    const lobe_sphere_lit_tier *tier;
    size_t positions, rows; /* of a cell; residuals */
    lobe_sphere_lit_set set[2];
    double rest;
} lobe_sphere_lit_problem;

/* From uniform and mixed cells with their dark truth, each stride-th position; under[b][set] are the radiances of
 * tier->under[b] at all of them. false: no memory. Free it either way. */
bool lobe_sphere_lit_problem_make(lobe_sphere_lit_problem *p, const lobe_sphere_lit_tier *tier,
                                  const lobe_sphere_cells cells[2], double *const under[LOBE_SPHERE_BASES][2],
                                  int stride);
void lobe_sphere_lit_problem_free(lobe_sphere_lit_problem *p);

/* lobe_batch_fn's; ctx is a lobe_sphere_lit_problem. */
void lobe_sphere_lit_residuals(void *ctx, const double *params, size_t count, double *values);
void lobe_sphere_lit_sum(void *ctx, const double *params, size_t count, double *values);

#endif
