/* Errors of models of the response, the split sum among them (contenders.h), on environments that no fit has seen. */
#ifndef LOBE_ENV_JUDGE_H
#define LOBE_ENV_JUDGE_H
#include <stdbool.h>
#include "../environment/environment.h"
#include "cell.h"

enum { LOBE_JUDGE_ORIENTATIONS = 96, LOBE_JUDGE_NODES = 4096 };

/* 30 points: alpha .04 .08 .16 .32 .6 1 by n_dot_v .05 .25 .5 .75 1. */
enum { LOBE_JUDGE_ALPHAS = 6, LOBE_JUDGE_VIEWS = 5, LOBE_JUDGE_CELLS = LOBE_JUDGE_ALPHAS * LOBE_JUDGE_VIEWS };
extern const double lobe_judge_alpha[LOBE_JUDGE_ALPHAS], lobe_judge_view[LOBE_JUDGE_VIEWS];

/* Weights sum to 1: they are held against the response over its albedo. ctx is the model's. */
typedef struct lobe_judge_model {
    const char *name;
    /* At most LOBE_CELL_TAPS; their number is returned. */
    int (*taps)(const void *ctx, double alpha, double n_dot_v, lobe_cell_tap *taps);
    /* Where taps is NULL: a quadrature of a lobe of any other kind, rows as of lobe_visible_nodes, at most
     * LOBE_JUDGE_NODES. */
    int (*nodes)(const void *ctx, double alpha, double n_dot_v, double *rows);
    const void *ctx;
} lobe_judge_model;

typedef struct lobe_judge_options {
    int threads;
    unsigned seed; /* of the orientations */
    double dark;   /* a truth below this part of the mean over its environment counts as if it were it */
} lobe_judge_options;

typedef struct lobe_judge_error {
    double relative; /* |model - truth| / truth, rms over points and orientations */
    double rms;      /* rms |model - truth| / rms truth over all orientations, rms over points */
} lobe_judge_error;

/* One error a model. Radiance is the mean of the colours; detail below .8 degrees is blurred away. False where there is
 * no memory. */
bool lobe_judge_environment(const lobe_environment *map, const lobe_judge_options *options,
                            const lobe_judge_model *models, int count, lobe_judge_error *errors);

#endif
