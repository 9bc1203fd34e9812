/* What goes wrong in the fit of lobes and what helps, as small experiments with fixed seeds: each writes one table.
 * All of them fit the shape of the response with its energy fixed, by the same quadrature. */
#ifndef LOBE_SG_EXPERIMENT_H
#define LOBE_SG_EXPERIMENT_H
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include "../../fit/random.h"
#include "../../fit/status.h"
#include "../target.h"

/* Each writes its table to out. false: no memory, with a line on stderr. */
bool lobe_experiment_sampling(FILE *out);
bool lobe_experiment_noise(FILE *out);
bool lobe_experiment_optimisers(FILE *out);
bool lobe_experiment_starts(FILE *out);
bool lobe_experiment_neighbours(FILE *out);
bool lobe_experiment_wobble(FILE *out);
bool lobe_experiment_spread(FILE *out);
bool lobe_experiment_amplitude(FILE *out);

/* A fit at one point. Parameters of a fan: centre, ln sharpness, ln spread, taper. Of free lobes, for each: angle,
 * ln sharpness, ln weight (before the weights are scaled to the albedo). */
enum { LOBE_FAN_PARAMETERS = 4, LOBE_EXPERIMENT_MOST = 3 * LOBE_SG_MOST };

typedef struct lobe_shape_fit {
    const lobe_sg_target *target;
    int count;          /* lobes */
    bool free;          /* false: a fan */
    bool within;        /* of a fan: spread at most the angle of the centre */
    bool any_amplitude; /* weights follow by least squares, not from the albedo */
    double (*estimate)(void *ctx, const lobe_sg *lobes, int count); /* instead of the quadrature, or NULL */
    void *estimate_ctx;
} lobe_shape_fit;

int lobe_shape_parameters(const lobe_shape_fit *fit);
void lobe_shape_lobes(const lobe_shape_fit *fit, const double *x, lobe_sg *lobes);
/* A lobe_batch_fn, ctx a lobe_shape_fit: relative L2 error; 10 and more outside of what lobes can be. */
void lobe_shape_errors(void *ctx, const double *x, size_t count, double *values);

/* The analytic start, and a uniform one from the box that covers all that a fit may want. */
void lobe_shape_start(const lobe_shape_fit *fit, double *x);
void lobe_shape_box(const lobe_shape_fit *fit, double *lower, double *upper);
void lobe_shape_random(const lobe_shape_fit *fit, lobe_random *random, double *x);

/* Nelder-Mead from x with this budget; the error in result.value. */
lobe_fit_result lobe_shape_nelder_mead(const lobe_shape_fit *fit, size_t budget, double *x);

#endif
