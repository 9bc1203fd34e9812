#include "fit.h"
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "../fit/coefficients.h"
#include "../fit/fit_command.h"
#include "fan_fit.h"

enum { TIERS = 4, FEW = 2 };

/* One or two taps cannot follow a lobe; left to the objective of the others they would grow until no sample is far too
 * bright, and lose against the split sum where it is not wrong. */
#define SPECTRA 0.5
#define SPECTRA_OF_FEW 2.0

/* A tier starts from the one before, so they are made in order, once for all that one command writes; the training set
 * is too. */
static struct {
    lobe_training *training;
    lobe_training *few; /* for tiers below FEW, which are improved from their place in the chain */
    double p[TIERS][LOBE_FAN_MOST];
    int made;
} chain;

static bool make_chain(const lobe_fit_request *request, int tiers)
{
    lobe_fan_fit fit = {NULL, request->sweep.threads, lobe_progress_line_default()};
    fit.line.out = request->sweep.progress ? stderr : NULL;
    if (!chain.training)
        chain.training = lobe_training_new(SPECTRA, request->sweep.threads);
    if (!chain.training) {
        fputs("lobefit: fit: not enough memory\n", stderr);
        return false;
    }
    fit.training = chain.training;
    for (; chain.made < tiers; chain.made++) {
        double *p = chain.p[chain.made];
        const lobe_fit_result result =
            lobe_fan_search(&fit, 1 << chain.made, chain.made ? chain.p[chain.made - 1] : NULL, p);
        lobe_progress_finish(&fit.line);
        if (result.status == LOBE_FIT_INTERRUPTED || !isfinite(result.value)) {
            fprintf(stderr, "lobefit: fit env_lobes lobes%d: %s: %s; the old coefficients stand\n", 1 << chain.made,
                    lobe_fit_status_name(result.status), result.reason);
            return false;
        }
        for (int i = 0; i < LOBE_FAN_MOST; i++)
            p[i] = lobe_coefficient_rounded(p[i]);
    }
    return true;
}

static bool improve_few(const lobe_fit_request *request, int taps, double *p)
{
    lobe_fan_fit fit = {NULL, request->sweep.threads, lobe_progress_line_default()};
    lobe_fit_result result;
    fit.line.out = request->sweep.progress ? stderr : NULL;
    if (!chain.few)
        chain.few = lobe_training_new(SPECTRA_OF_FEW, request->sweep.threads);
    if (!chain.few) {
        fputs("lobefit: fit: not enough memory\n", stderr);
        return false;
    }
    fit.training = chain.few;
    result = lobe_fan_improve(&fit, taps, 100, p);
    lobe_progress_finish(&fit.line);
    if (result.status == LOBE_FIT_INTERRUPTED || !isfinite(result.value)) {
        fprintf(stderr, "lobefit: fit env_lobes lobes%d: %s: %s; the old coefficients stand\n", taps,
                lobe_fit_status_name(result.status), result.reason);
        return false;
    }
    for (int i = 0; i < LOBE_FAN_MOST; i++)
        p[i] = lobe_coefficient_rounded(p[i]);
    return true;
}

static bool fit_tier(const lobe_case *self, const lobe_fit_request *request, int index)
{
    const int taps = 1 << index;
    lobe_coefficients out = {0};
    lobe_fan_fit fit = {NULL, 1, lobe_progress_line_default()};
    char name[16], kernel[40], source[40], error[160];
    double part[LOBE_CELL_PARTS], p[LOBE_FAN_MOST];
    if (!make_chain(request, index + 1))
        return false;
    memcpy(p, chain.p[index], sizeof p);
    if (index < FEW && !improve_few(request, taps, p))
        return false;
    fit.training = chain.training;
    lobe_fan_score(&fit, taps, p, part);
    snprintf(name, sizeof name, "lobes%d", taps);
    snprintf(kernel, sizeof kernel, "lobe_env_lobes_lobes%d", taps);
    snprintf(source, sizeof source, "models/env_lobes%d.h", taps);
    snprintf(error, sizeof error, "rms of the three from alpha .04 on: %.4f, %.4f, %.4f", part[LOBE_CELL_SAMPLES],
             part[LOBE_CELL_SPECTRA], part[LOBE_CELL_SHAPE]);
    out.model = "env_lobes";
    out.tier = name;
    out.brdf = self->brdf;
    out.domain = "alpha in [.02, 1], n_dot_v in [.03, 1]";
    out.grid = "10 x 10, denser toward low alpha and grazing views; nine environments, 80 orientations of each";
    out.metric =
        "radiance relative to each orientation's; to its rms over all orientations (.5; for few taps 2); shape (.05)";
    out.error = error;
    out.seed = 1;
    out.kernel = kernel;
    out.source = source;
    out.values = p;
    out.count = (size_t)lobe_fan_count(taps);
    return lobe_coefficients_write(&out, request->coeffs);
}

static bool fit1(const lobe_case *self, const lobe_fit_request *request) { return fit_tier(self, request, 0); }
static bool fit2(const lobe_case *self, const lobe_fit_request *request) { return fit_tier(self, request, 1); }
static bool fit4(const lobe_case *self, const lobe_fit_request *request) { return fit_tier(self, request, 2); }
static bool fit8(const lobe_case *self, const lobe_fit_request *request) { return fit_tier(self, request, 3); }

int lobe_env_lobes_fit(const lobe_case *self, int argc, char **argv)
{
    static const lobe_fit_tier all[TIERS] = {{"lobes1", fit1}, {"lobes2", fit2}, {"lobes4", fit4}, {"lobes8", fit8}};
    const int status = lobe_fit_command(self, all, TIERS, argc, argv);
    lobe_training_free(chain.training);
    lobe_training_free(chain.few);
    chain.training = chain.few = NULL;
    chain.made = 0;
    return status;
}
