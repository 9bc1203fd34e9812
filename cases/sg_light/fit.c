/* Differential evolution over every tenth position finds a basin, Levenberg-Marquardt over all of them its bottom; the
 * lowest of a few such searches is taken, since the kernels' maxima make small basins of their own. */
#define LOBE_DOUBLE 1
#define LOBE_FIT 1
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
#include "judge.h"
#include "objective.h"
#include "row.h"

enum { THINNED = 10 };

static bool explain(const lobe_sg_tier *tier, const lobe_fit_result *r)
{
    if (r->status == LOBE_FIT_CONVERGED || r->status == LOBE_FIT_STALLED)
        return true;
    fprintf(stderr, "lobefit: fit sg_light %s: %s: %s; the old coefficients stand\n", tier->name,
            lobe_fit_status_name(r->status), r->reason);
    return false;
}

static size_t threads_of(const lobe_fit_request *request)
{
    return request->sweep.threads < LOBE_PARALLEL_MAX ? (size_t)request->sweep.threads : LOBE_PARALLEL_MAX;
}

/* The basin. */
static bool search(const lobe_sg_tier *tier, const lobe_sg_cells cells[2], const lobe_fit_request *request,
                   uint64_t seed, lobe_progress_line *line, double *c)
{
    lobe_sg_problem problem;
    lobe_parallel parallel = {lobe_sg_sum, &problem, tier->count, 1, threads_of(request)};
    lobe_objective objective = {.f = lobe_parallel_eval, .ctx = &parallel, .dim = tier->count};
    lobe_de_options o = lobe_de_default();
    lobe_fit_result result;
    double lower[LOBE_SG_MOST], upper[LOBE_SG_MOST];
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
    if (!lobe_sg_problem_make(&problem, tier, cells, THINNED))
        result = lobe_fit_no_memory();
    else
        result = lobe_differential_evolution(&objective, &o, c);
    lobe_progress_finish(line);
    lobe_sg_problem_free(&problem);
    /* this search is over when its generations are */
    return result.status == LOBE_FIT_BUDGET || explain(tier, &result);
}

/* Its bottom, and how deep that is. */
static bool polish(const lobe_sg_tier *tier, const lobe_sg_cells cells[2], const lobe_fit_request *request,
                   lobe_progress_line *line, double *c, double *value)
{
    lobe_sg_problem problem;
    lobe_parallel parallel = {lobe_sg_residuals, &problem, tier->count, 0, threads_of(request)};
    lobe_residuals residuals = {.f = lobe_parallel_eval, .ctx = &parallel, .dim = tier->count};
    lobe_ls_options o = lobe_ls_default();
    lobe_fit_result result;
    o.value_tolerance = 1e-14;
    o.step_tolerance = 1e-12;
    o.budget = 3000;
    o.progress = lobe_progress_print;
    o.progress_ctx = line;
    if (!lobe_sg_problem_make(&problem, tier, cells, 1)) {
        result = lobe_fit_no_memory();
    } else {
        parallel.width = residuals.rows = problem.rows;
        result = lobe_least_squares(&residuals, &o, c);
    }
    lobe_progress_finish(line);
    lobe_sg_problem_free(&problem);
    *value = result.value;
    return explain(tier, &result);
}

static bool solve(const lobe_sg_tier *tier, const lobe_sg_cells cells[2], const lobe_fit_request *request, double *c)
{
    lobe_progress_line line = lobe_progress_line_default();
    double tried[LOBE_SG_MOST], value, best = HUGE_VAL;
    uint64_t i;
    line.out = request->sweep.progress ? stderr : NULL;
    for (i = 0; i < tier->searches; i++) {
        if (!search(tier, cells, request, tier->seed + i, &line, tried) ||
            !polish(tier, cells, request, &line, tried, &value))
            return false;
        if (value < best) {
            best = value;
            memcpy(c, tried, tier->count * sizeof *c);
        }
    }
    return true;
}

/* On the fit cells, as text of the generated header. */
static bool judge(const lobe_sg_tier *tier, const lobe_sg_cells cells[2], const double *c, char *text, size_t size)
{
    double *y = malloc(LOBE_SG_COUNT * sizeof *y);
    lobe_sg_score score[2];
    int i, set;
    for (set = 0; y && set < 2; set++) {
        for (i = 0; i < LOBE_SG_COUNT; i++) {
            const double *row = cells[set].in + 5 * i;
            y[i] = tier->call(c, row[0], lobe_sg_of_row(row));
        }
        lobe_sg_judge_values(y, &cells[set], &score[set]);
    }
    if (y)
        snprintf(text, size,
                 "uniform / mixed positions: all cells %.4g / %.4g, smooth %.4g / %.4g,\n"
                 " *          worst cell %.3g / %.3g, energy %+.3g / %+.3g, on those cells, in double",
                 score[0].all, score[1].all, score[0].smooth, score[1].smooth, score[0].worst, score[1].worst,
                 score[0].energy, score[1].energy);
    free(y);
    return y != NULL;
}

static bool fit_tier(const lobe_case *self, const lobe_fit_request *request, const lobe_sg_tier *tier)
{
    lobe_sg_cells cells[2] = {{.in = NULL}};
    lobe_sweep_options sweep = request->sweep;
    lobe_coefficients out = {0};
    double c[LOBE_SG_MOST];
    char error[400];
    size_t i;
    bool good;
    sweep.label = "truth of the fit cells";
    good = lobe_sg_cells_make(&cells[0], false, false, &sweep) && lobe_sg_cells_make(&cells[1], false, true, &sweep);
    if (!good)
        fputs("lobefit: fit: not enough memory\n", stderr);
    good = good && solve(tier, cells, request, c);
    for (i = 0; good && i < tier->count; i++)
        c[i] = lobe_coefficient_rounded(c[i]);
    if (good && (good = judge(tier, cells, c, error, sizeof error))) {
        out.model = "sg_light";
        out.tier = tier->name;
        out.brdf = self->brdf;
        out.domain = "alpha .05 to 1, sharpness 4 to 4096, n_dot_v .05 to 1, axes above and below the horizon";
        out.grid = "216 cells of 120 positions of the axis, uniform and mixed: cases/sg_light/cells.h";
        out.metric = "relative L2 error of a cell over its positions, rms over the cells; cases/sg_light/fit_tiers.h";
        out.error = error;
        out.seed = tier->seed;
        out.kernel = tier->kernel;
        out.source = tier->source;
        out.values = c;
        out.count = tier->count;
        good = lobe_coefficients_write(&out, request->coeffs);
    }
    lobe_sg_cells_free(&cells[0]);
    lobe_sg_cells_free(&cells[1]);
    return good;
}

static bool fit_low(const lobe_case *self, const lobe_fit_request *request)
{
    return fit_tier(self, request, lobe_sg_tier_at(0));
}
static bool fit_medium(const lobe_case *self, const lobe_fit_request *request)
{
    return fit_tier(self, request, lobe_sg_tier_at(1));
}
static bool fit_high(const lobe_case *self, const lobe_fit_request *request)
{
    return fit_tier(self, request, lobe_sg_tier_at(2));
}

int lobe_sg_fit(const lobe_case *self, int argc, char **argv)
{
    static const lobe_fit_tier all[] = {{"low", fit_low}, {"medium", fit_medium}, {"high", fit_high}};
    return lobe_fit_command(self, all, (int)(sizeof all / sizeof all[0]), argc, argv);
}
