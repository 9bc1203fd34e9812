#include "adaptive_tier.h"
#include <math.h>
#include <stdio.h>
#include "../case.h"
#include "../fit/coefficients.h"

/* Of what is held against all orientations. The more it weighs the more taps a dark reflection is denied. */
#define SPECTRA 0.06

/* Of a tap in the mean, to begin with (adaptive_search.c). */
#define PRICE 0.012

enum { GRID = LOBE_ENV_TABLE_GRID, FEW = 10 };

/* Every other row and column, both ends among them. */
static const int few[FEW] = {0, 2, 4, 6, 8, 11, 13, 15, 17, 19};

static void make_fits(const lobe_env_table_training *t, const lobe_fit_request *request, lobe_cell **some,
                      lobe_adaptive_fit *coarse, lobe_adaptive_fit *fine)
{
    const double *share = t->options[0].share;
    lobe_fan_point point[LOBE_ENV_TABLE_CELLS], at[FEW * FEW];
    for (int c = 0; c < LOBE_ENV_TABLE_CELLS; c++)
        point[c] = lobe_fan_point_of(t->point[c].alpha, t->point[c].n_dot_v);
    for (int c = 0; c < FEW * FEW; c++) {
        const int place = few[c / FEW] * GRID + few[c % FEW];
        some[c] = t->cell[place];
        at[c] = point[place];
    }
    lobe_adaptive_fit_of(some, at, FEW, FEW, share, request->sweep.threads, coarse);
    lobe_adaptive_fit_of(t->cell, point, GRID, GRID, share, request->sweep.threads, fine);
    coarse->line.out = fine->line.out = request->sweep.progress ? stderr : NULL;
    fine->price = PRICE;
}

bool lobe_env_adaptive_tier(const lobe_case *self, const lobe_fit_request *request, lobe_env_table_training *training,
                            const lobe_adaptive_tiers *tiers)
{
    lobe_fit_result result = lobe_fit_no_memory();
    lobe_coefficients out = {0};
    static lobe_adaptive_fit coarse, fine;
    lobe_cell *some[FEW * FEW];
    char error[200];
    double p[LOBE_ADAPTIVE_COUNT], part[LOBE_CELL_PARTS] = {0};
    if (lobe_env_table_training_weigh(training, SPECTRA, request->sweep.threads)) {
        make_fits(training, request, some, &coarse, &fine);
        result = lobe_adaptive_search(&coarse, &fine, tiers, p);
        lobe_progress_finish(&fine.line);
    }
    if (result.status == LOBE_FIT_INTERRUPTED || result.status == LOBE_FIT_NO_MEMORY || !isfinite(result.value)) {
        fprintf(stderr, "lobefit: fit env_lobes adaptive: %s: %s; the old coefficients stand\n",
                lobe_fit_status_name(result.status), result.reason);
        return false;
    }
    for (int i = 0; i < LOBE_ADAPTIVE_COUNT; i++)
        p[i] = lobe_coefficient_rounded(p[i]);
    lobe_adaptive_score(&fine, p, part);
    snprintf(error, sizeof error, "%.3f taps in the mean; rms of the three from alpha .04 on: %.4f, %.4f, %.4f",
             lobe_adaptive_mean_taps(p, 1024), part[LOBE_CELL_SAMPLES], part[LOBE_CELL_SPECTRA], part[LOBE_CELL_SHAPE]);
    out.model = "env_lobes";
    out.tier = "adaptive";
    out.brdf = self->brdf;
    out.domain = "alpha in [.02, 1], n_dot_v in [.03, 1]";
    out.grid = "20 x 20, weighed as dense as the judge's points; eighteen environments, 80 orientations of each";
    out.metric = "radiance relative to each orientation's; to its rms over all orientations (.06); shape (.05); and\n"
                 " *          taps in the mean over (roughness, n_dot_v) (.012)";
    out.error = error;
    out.seed = 1;
    out.kernel = "lobe_env_adaptive_fan";
    out.source = "models/env_lobes_adaptive.h";
    out.values = p;
    out.count = LOBE_ADAPTIVE_COUNT;
    return lobe_coefficients_write(&out, request->coeffs);
}
