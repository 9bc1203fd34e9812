#include "solve.h"
#include <math.h>
#include <string.h>
#include "../fit/coefficients.h"
#include "../fit/differential_evolution.h"
#include "../fit/least_squares.h"
#include "../fit/parallel.h"
#include "../fit/progress.h"

static bool explain(const lobe_sphere_task *task, const lobe_fit_result *r)
{
    if (r->status == LOBE_FIT_CONVERGED || r->status == LOBE_FIT_STALLED)
        return true;
    fprintf(stderr, "lobefit: fit sphere_light %s: %s: %s; the old coefficients stand\n", task->name,
            lobe_fit_status_name(r->status), r->reason);
    return false;
}

static size_t threads_of(const lobe_fit_request *request)
{
    return request->sweep.threads < LOBE_PARALLEL_MAX ? (size_t)request->sweep.threads : LOBE_PARALLEL_MAX;
}

/* The basin. */
static bool search(const lobe_sphere_task *task, const lobe_fit_request *request, uint64_t seed,
                   lobe_progress_line *line, double *c)
{
    lobe_parallel parallel = {task->sum, task->thinned, task->count, 1, threads_of(request)};
    lobe_objective objective = {.f = lobe_parallel_eval, .ctx = &parallel, .dim = task->count};
    lobe_de_options o = lobe_de_default();
    lobe_fit_result result;
    double lower[LOBE_SPHERE_SOLVED_MOST], upper[LOBE_SPHERE_SOLVED_MOST];
    size_t i;
    for (i = 0; i < task->count; i++) {
        lower[i] = task->box[i][0];
        upper[i] = task->box[i][1];
    }
    objective.lower = lower;
    objective.upper = upper;
    o.population = 8 * task->count;
    o.seed = seed;
    o.budget = o.population * (task->generations + 1);
    o.progress = lobe_progress_print;
    o.progress_ctx = line;
    result = lobe_differential_evolution(&objective, &o, c);
    lobe_progress_finish(line);
    /* this search is over when its generations are */
    return result.status == LOBE_FIT_BUDGET || explain(task, &result);
}

/* Its bottom, and how deep that is. */
static bool polish(const lobe_sphere_task *task, const lobe_fit_request *request, lobe_progress_line *line, double *c,
                   double *value)
{
    lobe_parallel parallel = {task->residuals, task->whole, task->count, task->rows, threads_of(request)};
    lobe_residuals residuals = {.f = lobe_parallel_eval, .ctx = &parallel, .dim = task->count, .rows = task->rows};
    lobe_ls_options o = lobe_ls_default();
    lobe_fit_result result;
    o.value_tolerance = 1e-14;
    o.step_tolerance = 1e-12;
    o.budget = 3000;
    o.progress = lobe_progress_print;
    o.progress_ctx = line;
    result = lobe_least_squares(&residuals, &o, c);
    lobe_progress_finish(line);
    *value = result.value;
    return explain(task, &result);
}

bool lobe_sphere_solve(const lobe_sphere_task *task, const lobe_fit_request *request, double *c)
{
    lobe_progress_line line = lobe_progress_line_default();
    double tried[LOBE_SPHERE_SOLVED_MOST], value, best = HUGE_VAL;
    uint64_t i;
    size_t k;
    line.out = request->sweep.progress ? stderr : NULL;
    for (i = 0; i < task->searches; i++) {
        if (!search(task, request, task->seed + i, &line, tried) || !polish(task, request, &line, tried, &value))
            return false;
        if (value < best) {
            best = value;
            memcpy(c, tried, task->count * sizeof *c);
        }
    }
    for (k = 0; k < task->count; k++)
        c[k] = lobe_coefficient_rounded(c[k]);
    return true;
}
