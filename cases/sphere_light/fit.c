#define LOBE_DOUBLE 1
#define LOBE_FIT 1
#include "fit.h"
#include <stdlib.h>
#include "../fit/coefficients.h"
#include "lit_fit.h"
#include "objective.h"
#include "row.h"
#include "solve.h"

bool lobe_sphere_fit_cells(lobe_sphere_cells cells[2], const lobe_fit_request *request)
{
    lobe_sweep_options sweep = request->sweep;
    sweep.label = "truth of the fit cells";
    if (lobe_sphere_cells_make(&cells[0], false, false, &sweep) &&
        lobe_sphere_cells_make(&cells[1], false, true, &sweep))
        return true;
    fputs("lobefit: fit: not enough memory\n", stderr);
    return false;
}

bool lobe_sphere_tier_solve(const lobe_sphere_tier *tier, const lobe_sphere_cells cells[2],
                            const lobe_fit_request *request, double *c)
{
    lobe_sphere_problem thinned, whole;
    lobe_sphere_task task = {.name = tier->name,
                             .count = tier->count,
                             .box = tier->box,
                             .searches = tier->searches,
                             .generations = tier->generations,
                             .seed = tier->seed,
                             .sum = lobe_sphere_sum,
                             .residuals = lobe_sphere_residuals,
                             .thinned = &thinned,
                             .whole = &whole};
    bool good = lobe_sphere_problem_make(&thinned, tier, cells, LOBE_SPHERE_THINNED);
    good = lobe_sphere_problem_make(&whole, tier, cells, 1) && good;
    task.rows = whole.rows;
    if (!good)
        fputs("lobefit: fit: not enough memory\n", stderr);
    good = good && lobe_sphere_solve(&task, request, c);
    lobe_sphere_problem_free(&thinned);
    lobe_sphere_problem_free(&whole);
    return good;
}

int lobe_sphere_score_text(const lobe_sphere_score score[2], char *text, size_t size)
{
    return snprintf(text, size,
                    "uniform / mixed positions: all cells %.4g / %.4g, worst cell %.3g / %.3g,\n"
                    " *          energy %+.3g / %+.3g, on those cells, in double",
                    score[0].all, score[1].all, score[0].worst, score[1].worst, score[0].energy, score[1].energy);
}

/* On the fit cells, as text of the generated header. */
static bool judge(const lobe_sphere_tier *tier, const lobe_sphere_cells cells[2], const double *c, char *text,
                  size_t size)
{
    double *y = malloc(LOBE_SPHERE_COUNT * sizeof *y);
    lobe_sphere_score *score = malloc(2 * sizeof *score);
    int i, set;
    for (set = 0; y && score && set < 2; set++) {
        for (i = 0; i < LOBE_SPHERE_COUNT; i++) {
            const double *row = cells[set].in + 5 * i;
            y[i] = tier->call(c, row[0], lobe_sphere_of_row(row));
        }
        lobe_sphere_judge_values(y, &cells[set], &score[set]);
    }
    if (y && score)
        lobe_sphere_score_text(score, text, size);
    free(y);
    free(score);
    return y && score;
}

bool lobe_sphere_fitted_write(const lobe_case *self, const lobe_fit_request *request, const lobe_sphere_fitted *fitted)
{
    lobe_coefficients out = {0};
    char metric[200];
    snprintf(metric, sizeof metric,
             "relative L2 error of a cell over its positions, rms over the cells; cases/sphere_light/%s",
             fitted->tiers);
    out.model = "sphere_light";
    out.tier = fitted->tier;
    out.brdf = self->brdf;
    out.domain = "alpha .05 to 1, half angle 1 to 45 degrees, view 0 to 85 degrees, lights above and through\n"
                 " *          the horizon";
    out.grid = "294 cells of 200 light positions, uniform and mixed: cases/sphere_light/cells.h";
    out.metric = metric;
    out.error = fitted->error;
    out.seed = fitted->seed;
    out.kernel = fitted->kernel;
    out.source = fitted->source;
    out.values = fitted->values;
    out.count = fitted->count;
    return lobe_coefficients_write(&out, request->coeffs);
}

static bool fit_tier(const lobe_case *self, const lobe_fit_request *request, const lobe_sphere_tier *tier)
{
    lobe_sphere_cells cells[2] = {{.in = NULL}};
    double c[LOBE_SPHERE_MOST];
    lobe_sphere_fitted fitted = {.tier = tier->name,
                                 .kernel = tier->kernel,
                                 .source = tier->source,
                                 .tiers = "fit_tiers.h",
                                 .seed = tier->seed,
                                 .values = c,
                                 .count = tier->count};
    const bool good = lobe_sphere_fit_cells(cells, request) && lobe_sphere_tier_solve(tier, cells, request, c) &&
                      judge(tier, cells, c, fitted.error, sizeof fitted.error) &&
                      lobe_sphere_fitted_write(self, request, &fitted);
    lobe_sphere_cells_free(&cells[0]);
    lobe_sphere_cells_free(&cells[1]);
    return good;
}

static bool fit_low(const lobe_case *self, const lobe_fit_request *request)
{
    return fit_tier(self, request, lobe_sphere_tier_named("low"));
}
static bool fit_medium(const lobe_case *self, const lobe_fit_request *request)
{
    return fit_tier(self, request, lobe_sphere_tier_named("medium"));
}

int lobe_sphere_fit(const lobe_case *self, int argc, char **argv)
{
    static const lobe_fit_tier all[] = {
        {"low", fit_low}, {"medium", fit_medium}, {"high", lobe_sphere_fit_high}, {"schlick", lobe_sphere_fit_schlick}};
    return lobe_fit_command(self, all, (int)(sizeof all / sizeof all[0]), argc, argv);
}
