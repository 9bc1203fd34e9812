/* Differential evolution over every sixth position finds a basin, Levenberg-Marquardt over all of them its bottom; the
 * lowest of a few such searches is taken. */
#include "fit.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../fit/coefficients.h"
#include "../fit/differential_evolution.h"
#include "../fit/fit_command.h"
#include "../fit/least_squares.h"
#include "../fit/parallel.h"
#include "../fit/progress.h"
#include "fit_tiers.h"
#include "judge.h"

enum { THINNED = 6 };

typedef struct problem {
    const lobe_capsule_tier *tier;
    const lobe_capsule_cells *cells;
    double weight[LOBE_CAPSULE_CELLS];
    size_t stride, rows; /* every stride-th position */
} problem;

static void problem_make(problem *p, const lobe_capsule_tier *tier, const lobe_capsule_cells *cells, size_t stride)
{
    size_t cell, i;
    p->tier = tier;
    p->cells = cells;
    p->stride = stride;
    p->rows = LOBE_CAPSULE_COUNT / stride;
    for (cell = 0; cell < LOBE_CAPSULE_CELLS; cell++) {
        double square = 0;
        for (i = 0; i < LOBE_CAPSULE_POSITIONS; i += stride) {
            const double t = cells->truth[cell * LOBE_CAPSULE_POSITIONS + i];
            square += t * t;
        }
        p->weight[cell] = 1 / sqrt(square * LOBE_CAPSULE_CELLS);
    }
}

static double residual(const problem *p, const double *c, size_t row)
{
    const size_t i = row * p->stride;
    const double y = p->tier->call(c, p->cells->in + LOBE_CAPSULE_COLUMNS * i);
    return (y - p->cells->truth[i]) * p->weight[i / LOBE_CAPSULE_POSITIONS];
}

static void residuals(void *ctx, const double *params, size_t count, double *values)
{
    const problem *p = ctx;
    size_t n, i;
    for (n = 0; n < count; n++)
        for (i = 0; i < p->rows; i++)
            values[n * p->rows + i] = residual(p, params + n * p->tier->count, i);
}

static void sum(void *ctx, const double *params, size_t count, double *values)
{
    const problem *p = ctx;
    size_t n, i;
    for (n = 0; n < count; n++) {
        values[n] = 0;
        for (i = 0; i < p->rows; i++) {
            const double e = residual(p, params + n * p->tier->count, i);
            values[n] += e * e;
        }
    }
}

static bool explain(const lobe_capsule_tier *tier, const lobe_fit_result *r)
{
    if (r->status == LOBE_FIT_CONVERGED || r->status == LOBE_FIT_STALLED)
        return true;
    fprintf(stderr, "lobefit: fit capsule_light %s: %s: %s; the old coefficients stand\n", tier->name,
            lobe_fit_status_name(r->status), r->reason);
    return false;
}

/* The basin. */
static bool search(problem *p, size_t threads, uint64_t seed, lobe_progress_line *line, double *c)
{
    const lobe_capsule_tier *tier = p->tier;
    lobe_parallel parallel = {sum, p, tier->count, 1, threads};
    lobe_objective objective = {.f = lobe_parallel_eval, .ctx = &parallel, .dim = tier->count};
    lobe_de_options o = lobe_de_default();
    lobe_fit_result result;
    double lower[LOBE_CAPSULE_MOST], upper[LOBE_CAPSULE_MOST];
    size_t i;
    for (i = 0; i < tier->count; i++) {
        lower[i] = tier->box[i][0];
        upper[i] = tier->box[i][1];
    }
    objective.lower = lower;
    objective.upper = upper;
    o.population = 8 * tier->count;
    o.seed = seed;
    o.budget = o.population * (tier->generations + 1);
    o.progress = lobe_progress_print;
    o.progress_ctx = line;
    result = lobe_differential_evolution(&objective, &o, c);
    lobe_progress_finish(line);
    /* this search is over when its generations are */
    return result.status == LOBE_FIT_BUDGET || explain(tier, &result);
}

/* Its bottom, and how deep that is. */
static bool polish(problem *p, size_t threads, lobe_progress_line *line, double *c, double *value)
{
    lobe_parallel parallel = {residuals, p, p->tier->count, p->rows, threads};
    lobe_residuals r = {.f = lobe_parallel_eval, .ctx = &parallel, .dim = p->tier->count, .rows = p->rows};
    lobe_ls_options o = lobe_ls_default();
    lobe_fit_result result;
    o.value_tolerance = 1e-8;
    o.step_tolerance = 1e-6;
    o.budget = 3000;
    o.progress = lobe_progress_print;
    o.progress_ctx = line;
    result = lobe_least_squares(&r, &o, c);
    lobe_progress_finish(line);
    *value = result.value;
    return explain(p->tier, &result);
}

static bool solve(const lobe_capsule_tier *tier, const lobe_capsule_cells *cells, const lobe_fit_request *request,
                  double *c)
{
    const size_t threads = (size_t)request->sweep.threads;
    lobe_progress_line line = lobe_progress_line_default();
    problem *thin = malloc(2 * sizeof *thin), *all = thin ? thin + 1 : NULL;
    double tried[LOBE_CAPSULE_MOST], value, best = HUGE_VAL;
    bool good = thin != NULL;
    uint64_t i;
    line.out = request->sweep.progress ? stderr : NULL;
    if (good) {
        problem_make(thin, tier, cells, THINNED);
        problem_make(all, tier, cells, 1);
    } else {
        fputs("lobefit: fit: not enough memory\n", stderr);
    }
    for (i = 0; good && i < tier->searches; i++) {
        good = search(thin, threads, tier->seed + i, &line, tried) && polish(all, threads, &line, tried, &value);
        if (good && value < best) {
            best = value;
            memcpy(c, tried, tier->count * sizeof *c);
        }
    }
    free(thin);
    return good;
}

/* On the fit cells, as text of the generated header. */
static bool judge(const lobe_capsule_tier *tier, const lobe_capsule_cells *cells, const double *c, char *text,
                  size_t size)
{
    double *y = malloc(LOBE_CAPSULE_COUNT * sizeof *y);
    lobe_capsule_score score;
    int i;
    if (!y)
        return false;
    for (i = 0; i < LOBE_CAPSULE_COUNT; i++)
        y[i] = tier->call(c, cells->in + LOBE_CAPSULE_COLUMNS * i);
    lobe_capsule_judge_values(y, cells, &score);
    snprintf(text, size, "all cells %.4g, worst cell %.3g, energy %+.3g, on those cells, in double", score.all,
             score.worst, score.energy);
    free(y);
    return true;
}

static bool fit_tier(const lobe_case *self, const lobe_fit_request *request, const lobe_capsule_tier *tier)
{
    lobe_capsule_cells cells = {.in = NULL};
    lobe_sweep_options sweep = request->sweep;
    lobe_coefficients out = {0};
    double c[LOBE_CAPSULE_MOST];
    char error[200];
    size_t i;
    bool good;
    sweep.label = "truth of the fit cells";
    good = lobe_capsule_cells_make(&cells, false, &sweep);
    if (!good)
        fputs("lobefit: fit: not enough memory\n", stderr);
    good = good && solve(tier, &cells, request, c);
    for (i = 0; good && i < tier->count; i++)
        c[i] = lobe_coefficient_rounded(c[i]);
    if (good && (good = judge(tier, &cells, c, error, sizeof error))) {
        out.model = "capsule_light";
        out.tier = tier->name;
        out.brdf = self->brdf;
        out.domain = "alpha .05 to 1, radius 1.5 to 15 degrees, half length .1 to 1 distance, view 0 to 85 degrees,\n"
                     " *          lights above and through the horizon";
        out.grid = "225 cells of 60 capsules: cases/capsule_light/cells.h";
        out.metric =
            "relative L2 error of a cell over its positions, rms over the cells; cases/capsule_light/fit_tiers.h";
        out.error = error;
        out.seed = tier->seed;
        out.kernel = tier->kernel;
        out.source = tier->source;
        out.values = c;
        out.count = tier->count;
        good = lobe_coefficients_write(&out, request->coeffs);
    }
    lobe_capsule_cells_free(&cells);
    return good;
}

static bool fit_low(const lobe_case *self, const lobe_fit_request *request)
{
    return fit_tier(self, request, lobe_capsule_tier_at(0));
}
static bool fit_medium(const lobe_case *self, const lobe_fit_request *request)
{
    return fit_tier(self, request, lobe_capsule_tier_at(1));
}
static bool fit_high(const lobe_case *self, const lobe_fit_request *request)
{
    return fit_tier(self, request, lobe_capsule_tier_at(2));
}

int lobe_capsule_fit(const lobe_case *self, int argc, char **argv)
{
    static const lobe_fit_tier all[] = {{"low", fit_low}, {"medium", fit_medium}, {"high", fit_high}};
    return lobe_fit_command(self, all, (int)(sizeof all / sizeof all[0]), argc, argv);
}
