#define LOBE_DOUBLE 1
#define LOBE_FIT 1
#include "lit_fit.h"
#include <stdlib.h>
#include <string.h>
#include "fit.h"
#include "judge.h"
#include "lit_objective.h"
#include "row.h"
#include "solve.h"

static bool solve(const lobe_sphere_lit_tier *tier, const lobe_sphere_cells cells[2],
                  double *const under[LOBE_SPHERE_BASES][2], const lobe_fit_request *request, double *c)
{
    lobe_sphere_lit_problem thinned, whole;
    lobe_sphere_task task = {.name = tier->name,
                             .count = tier->count,
                             .box = tier->box,
                             .searches = tier->searches,
                             .generations = tier->generations,
                             .seed = tier->seed,
                             .sum = lobe_sphere_lit_sum,
                             .residuals = lobe_sphere_lit_residuals,
                             .thinned = &thinned,
                             .whole = &whole};
    bool good = lobe_sphere_lit_problem_make(&thinned, tier, cells, under, LOBE_SPHERE_THINNED);
    good = lobe_sphere_lit_problem_make(&whole, tier, cells, under, 1) && good;
    task.rows = whole.rows;
    if (!good)
        fputs("lobefit: fit: not enough memory\n", stderr);
    good = good && lobe_sphere_solve(&task, request, c);
    lobe_sphere_lit_problem_free(&thinned);
    lobe_sphere_lit_problem_free(&whole);
    return good;
}

/* Radiances of the tiers that schlick is under, fitted here and now: no fit reads what another wrote. */
static bool fit_under(const lobe_sphere_lit_tier *tier, const lobe_sphere_cells cells[2],
                      const lobe_fit_request *request, double *under[LOBE_SPHERE_BASES][2])
{
    double c[LOBE_SPHERE_MOST];
    int b, set, i;
    for (b = 0; b < LOBE_SPHERE_BASES && tier->under[b]; b++) {
        const lobe_sphere_tier *below = lobe_sphere_tier_named(tier->under[b]);
        if (!lobe_sphere_tier_solve(below, cells, request, c))
            return false;
        for (set = 0; set < 2; set++) {
            under[b][set] = malloc(LOBE_SPHERE_COUNT * sizeof *under[b][set]);
            if (!under[b][set]) {
                fputs("lobefit: fit: not enough memory\n", stderr);
                return false;
            }
            for (i = 0; i < LOBE_SPHERE_COUNT; i++) {
                const double *row = cells[set].in + 5 * i;
                under[b][set][i] = below->call(c, row[0], lobe_sphere_of_row(row));
            }
        }
    }
    return true;
}

/* What F0 = .02 adds to the error over all cells, in points. */
static double added(const double *radiance, const double *schlick, const lobe_sphere_cells *cells,
                    lobe_sphere_score *score)
{
    double dim;
    lobe_sphere_judge_lit(radiance, schlick, .02, cells, score);
    dim = score->all;
    lobe_sphere_judge_values(radiance, cells, score);
    return 100 * (dim - score->all);
}

/* On the fit cells, as text of the generated header. */
static bool judge(const lobe_sphere_lit_tier *tier, const lobe_sphere_cells cells[2],
                  double *const under[LOBE_SPHERE_BASES][2], const double *c, char *text, size_t size)
{
    double *y = malloc(2 * LOBE_SPHERE_COUNT * sizeof *y), *s = y + LOBE_SPHERE_COUNT;
    lobe_sphere_score *score = malloc(2 * sizeof *score);
    double more[LOBE_SPHERE_BASES][2];
    int i, set, b;
    for (set = 0; y && score && set < 2; set++) {
        for (i = 0; i < LOBE_SPHERE_COUNT; i++) {
            const double *row = cells[set].in + 5 * i;
            const lobe_sphere_lit lit = tier->call(c, row[0], lobe_sphere_of_row(row));
            y[i] = lit.radiance;
            s[i] = lit.schlick;
        }
        for (b = 0; b < LOBE_SPHERE_BASES; b++)
            more[b][set] = added(tier->under[b] ? under[b][set] : y, s, &cells[set], &score[set]);
    }
    if (y && score && tier->own > 0) {
        const int length = lobe_sphere_score_text(score, text, size);
        snprintf(text + length, size - (size_t)length, ";\n *          F0 = .02 adds %+.3f / %+.3f points to all cells",
                 more[0][0], more[0][1]);
    } else if (y && score) {
        snprintf(text, size,
                 "uniform / mixed positions: F0 = .02 adds to all cells of %s %+.3f / %+.3f points,\n"
                 " *          of %s %+.3f / %+.3f, on those cells, in double",
                 tier->under[0], more[0][0], more[0][1], tier->under[1], more[1][0], more[1][1]);
    }
    free(y);
    free(score);
    return y && score;
}

static bool fit_tier(const struct lobe_case *self, const lobe_fit_request *request, const lobe_sphere_lit_tier *tier)
{
    lobe_sphere_cells cells[2] = {{.in = NULL}};
    double *under[LOBE_SPHERE_BASES][2] = {{NULL}}, c[LOBE_SPHERE_LIT_MOST];
    lobe_sphere_fitted fitted = {.tier = tier->name,
                                 .kernel = tier->kernel,
                                 .source = tier->source,
                                 .tiers = "lit_tiers.h",
                                 .seed = tier->seed,
                                 .values = c,
                                 .count = tier->count};
    lobe_sweep_options sweep = request->sweep;
    bool good = lobe_sphere_fit_cells(cells, request);
    int b, set;
    sweep.label = "truth of the fit cells, F0 = 0";
    good = good && lobe_sphere_cells_add_dark(&cells[0], &sweep) && lobe_sphere_cells_add_dark(&cells[1], &sweep) &&
           fit_under(tier, cells, request, under) && solve(tier, cells, under, request, c) &&
           judge(tier, cells, under, c, fitted.error, sizeof fitted.error) &&
           lobe_sphere_fitted_write(self, request, &fitted);
    for (set = 0; set < 2; set++) {
        lobe_sphere_cells_free(&cells[set]);
        for (b = 0; b < LOBE_SPHERE_BASES; b++)
            free(under[b][set]);
    }
    return good;
}

bool lobe_sphere_fit_high(const struct lobe_case *self, const lobe_fit_request *request)
{
    return fit_tier(self, request, lobe_sphere_lit_tier_at(0));
}
bool lobe_sphere_fit_schlick(const struct lobe_case *self, const lobe_fit_request *request)
{
    return fit_tier(self, request, lobe_sphere_lit_tier_at(1));
}
