/* A global stage polished by a local one: differential evolution finds the basin, a local engine runs down from its
 * best; with several rounds the next search starts around the polished point. */
#ifndef LOBE_GLOBAL_LOCAL_H
#define LOBE_GLOBAL_LOCAL_H

#include "differential_evolution.h"
#include "least_squares.h"
#include "minimax.h"
#include "nelder_mead.h"

/* Improves x within the budget; result.value is the objective's value at the x handed back. */
typedef lobe_fit_result (*lobe_local_fn)(void *ctx, const lobe_objective *objective, size_t budget, double *x);

typedef struct lobe_global_local_options {
    lobe_de_options global;
    size_t rounds;       /* the global budget in this many parts, each followed by a polish; 1: polish at the end */
    double local_share;  /* of the whole budget for the polishes, in (0, 1) */
    size_t budget;       /* evaluations in all; replaces global.budget */
    lobe_local_fn local; /* NULL: Nelder-Mead with its defaults */
    void *local_ctx;
} lobe_global_local_options;

lobe_global_local_options lobe_global_local_default(void);
/* x: the best point out. The progress callback is that of global. */
lobe_fit_result lobe_global_local(const lobe_objective *objective, const lobe_global_local_options *options, double *x);

/* Ready local stages. ctx: lobe_nm_options; their budget is replaced. */
lobe_fit_result lobe_local_nelder_mead(void *ctx, const lobe_objective *objective, size_t budget, double *x);
/* ctx: lobe_local_residuals, whose residuals make up the objective: their sum of squares, or largest. */
typedef struct lobe_local_residuals {
    const lobe_residuals *residuals;
    lobe_ls_options least_squares;
    lobe_minimax_options minimax;
} lobe_local_residuals;
lobe_fit_result lobe_local_least_squares(void *ctx, const lobe_objective *objective, size_t budget, double *x);
lobe_fit_result lobe_local_minimax(void *ctx, const lobe_objective *objective, size_t budget, double *x);

#endif
