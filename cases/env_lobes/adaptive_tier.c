#include "adaptive_tier.h"
#include <math.h>
#include <stdio.h>
#include "../case.h"
#include "../fit/coefficients.h"

/* Of what is held against all orientations. The more it weighs the more taps a dark reflection is denied. */
#define SPECTRA 0.06

/* Of a tap in the mean, to begin with (adaptive_search.c). */
#define PRICE 0.012

bool lobe_env_adaptive_tier(const lobe_case *self, const lobe_fit_request *request, const lobe_adaptive_tiers *tiers)
{
    lobe_training *training = lobe_training_new(SPECTRA, request->sweep.threads);
    lobe_fit_result result = lobe_fit_no_memory();
    lobe_coefficients out = {0};
    lobe_adaptive_fit fit;
    char error[200];
    double p[LOBE_ADAPTIVE_COUNT], part[LOBE_CELL_PARTS] = {0};
    if (training) {
        lobe_adaptive_fit_of(training, request->sweep.threads, &fit);
        fit.price = PRICE;
        fit.line.out = request->sweep.progress ? stderr : NULL;
        result = lobe_adaptive_search(&fit, tiers, p);
        lobe_progress_finish(&fit.line);
    }
    if (!training || result.status == LOBE_FIT_INTERRUPTED || result.status == LOBE_FIT_NO_MEMORY ||
        !isfinite(result.value)) {
        fprintf(stderr, "lobefit: fit env_lobes adaptive: %s: %s; the old coefficients stand\n",
                lobe_fit_status_name(result.status), result.reason);
        lobe_training_free(training);
        return false;
    }
    for (int i = 0; i < LOBE_ADAPTIVE_COUNT; i++)
        p[i] = lobe_coefficient_rounded(p[i]);
    lobe_adaptive_score(&fit, p, part);
    lobe_training_free(training);
    snprintf(error, sizeof error, "%.3f taps in the mean; rms of the three from alpha .04 on: %.4f, %.4f, %.4f",
             lobe_adaptive_mean_taps(p, 1024), part[LOBE_CELL_SAMPLES], part[LOBE_CELL_SPECTRA], part[LOBE_CELL_SHAPE]);
    out.model = "env_lobes";
    out.tier = "adaptive";
    out.brdf = self->brdf;
    out.domain = "alpha in [.02, 1], n_dot_v in [.03, 1]";
    out.grid = "10 x 10, as dense as the judge's points; nine environments, 80 orientations of each";
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
