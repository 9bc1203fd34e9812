#include "global_local.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

lobe_global_local_options lobe_global_local_default(void)
{
    lobe_global_local_options o = {0};
    o.global = lobe_de_default();
    o.global.value_tolerance = 1e-4; /* the polish does the rest */
    o.global.spread_tolerance = 1e-3;
    o.rounds = 1;
    o.local_share = 0.25;
    o.budget = 100000;
    return o;
}

lobe_fit_result lobe_local_nelder_mead(void *ctx, const lobe_objective *objective, size_t budget, double *x)
{
    lobe_nm_options o = *(const lobe_nm_options *)ctx;
    o.budget = budget;
    return lobe_nelder_mead(objective, &o, x);
}

/* The objective decides about the point: residuals may be a smooth stand-in for it. */
static void settle(const lobe_objective *objective, const double *before, double *x, lobe_fit_result *result)
{
    if (result->status == LOBE_FIT_BAD_INPUT || result->status == LOBE_FIT_NO_MEMORY)
        return;
    double values[2];
    lobe_objective_eval(objective, before, 1, &values[0]);
    lobe_objective_eval(objective, x, 1, &values[1]);
    result->evaluations += 2;
    if (!(values[1] < values[0]))
        memcpy(x, before, objective->dim * sizeof *x);
    result->value = values[1] < values[0] ? values[1] : values[0];
}

lobe_fit_result lobe_local_least_squares(void *ctx, const lobe_objective *objective, size_t budget, double *x)
{
    const lobe_local_residuals *local = ctx;
    lobe_ls_options o = local->least_squares;
    if (local->residuals->dim != objective->dim)
        return lobe_fit_refused("objective and residuals differ in their number of parameters");
    double *before = malloc(objective->dim * sizeof *before);
    if (!before)
        return lobe_fit_no_memory();
    memcpy(before, x, objective->dim * sizeof *x);
    o.budget = budget > 2 ? budget - 2 : 1;
    lobe_fit_result result = lobe_least_squares(local->residuals, &o, x);
    settle(objective, before, x, &result);
    free(before);
    return result;
}

lobe_fit_result lobe_local_minimax(void *ctx, const lobe_objective *objective, size_t budget, double *x)
{
    const lobe_local_residuals *local = ctx;
    lobe_minimax_options o = local->minimax;
    if (local->residuals->dim != objective->dim)
        return lobe_fit_refused("objective and residuals differ in their number of parameters");
    double *before = malloc(objective->dim * sizeof *before);
    if (!before)
        return lobe_fit_no_memory();
    memcpy(before, x, objective->dim * sizeof *x);
    o.budget = budget > 2 ? budget - 2 : 1;
    lobe_fit_result result = lobe_minimax(local->residuals, &o, x).fit;
    settle(objective, before, x, &result);
    free(before);
    return result;
}

static bool failed(const lobe_fit_result *r)
{
    return r->status == LOBE_FIT_BAD_INPUT || r->status == LOBE_FIT_NO_MEMORY;
}

lobe_fit_result lobe_global_local(const lobe_objective *objective, const lobe_global_local_options *options, double *x)
{
    const lobe_global_local_options o = options ? *options : lobe_global_local_default();
    if (o.rounds < 1)
        return lobe_fit_refused("at least one round is needed");
    if (!(o.local_share > 0.0 && o.local_share < 1.0))
        return lobe_fit_refused("the local share must be inside (0, 1)");
    lobe_nm_options nelder_mead = lobe_nm_default();
    nelder_mead.size = 0.02;
    nelder_mead.target = o.global.target;
    nelder_mead.progress = o.global.progress;
    nelder_mead.progress_ctx = o.global.progress_ctx;
    const lobe_local_fn local = o.local ? o.local : lobe_local_nelder_mead;
    void *ctx = o.local ? o.local_ctx : &nelder_mead;

    lobe_fit_result total = {LOBE_FIT_BUDGET, "the evaluations ran out", HUGE_VAL, 0, 0};
    for (size_t round = 0; round < o.rounds; round++) {
        const size_t left = o.budget > total.evaluations ? o.budget - total.evaluations : 0;
        const double share = (double)left / (double)(o.rounds - round);
        lobe_de_options global = o.global;
        global.budget = (size_t)(share * (1.0 - o.local_share));
        global.seed = o.global.seed + round; /* a round starts afresh around the best so far */
        global.start_at_x = o.global.start_at_x || round > 0;
        lobe_fit_result r = lobe_differential_evolution(objective, &global, x);
        if (failed(&r))
            return round == 0 ? r : total;
        total.evaluations += r.evaluations;
        total.iterations += r.iterations;
        total.value = r.value;
        if (r.status == LOBE_FIT_INTERRUPTED || r.value <= o.global.target) {
            total.status = r.status;
            total.reason = r.reason;
            return total;
        }
        /* What the global stage did not use is the polish's. */
        const size_t rest = (size_t)share > r.evaluations ? (size_t)share - r.evaluations : 0;
        r = local(ctx, objective, rest, x);
        if (failed(&r)) {
            r.value = total.value;
            r.evaluations = total.evaluations;
            return r;
        }
        total.evaluations += r.evaluations;
        total.iterations += r.iterations;
        total.value = r.value;
        total.status = r.status;
        total.reason = r.reason;
        if (r.status == LOBE_FIT_INTERRUPTED || r.value <= o.global.target)
            return total;
    }
    return total;
}
