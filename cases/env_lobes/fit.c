#include "fit.h"
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "../fit/coefficients.h"
#include "../fit/fit_command.h"
#include "adaptive_tier.h"
#include "fan_fit.h"
#include "table_tier.h"

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
    double written[TIERS][LOBE_FAN_MOST]; /* what tables start from */
    bool is_written[TIERS];
    lobe_env_table_training *tables;
} chain;

static bool make_chain(const lobe_fit_request *request, int tiers)
{
    lobe_fan_fit fit = {NULL, request->sweep.threads, lobe_progress_line_default(), false};
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
    lobe_fan_fit fit = {NULL, request->sweep.threads, lobe_progress_line_default(), false};
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
    lobe_fan_fit fit = {NULL, 1, lobe_progress_line_default(), false};
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
    memcpy(chain.written[index], p, sizeof p);
    chain.is_written[index] = lobe_coefficients_write(&out, request->coeffs);
    return chain.is_written[index];
}

static bool make_table_training(int threads)
{
    if (!chain.tables)
        chain.tables = lobe_env_table_training_new(threads);
    return chain.tables != NULL;
}

/* From the closed form that this command wrote; from the one that ships where it was asked for the table alone. */
static bool fit_table(const lobe_case *self, const lobe_fit_request *request, int index)
{
    const int taps = 1 << index, threads = request->sweep.threads;
    double p[LOBE_FAN_MOST] = {0};
    if (chain.is_written[index])
        memcpy(p, chain.written[index], sizeof p);
    else
        lobe_env_table_shipped(taps, p);
    if (!make_table_training(threads) ||
        !lobe_env_table_training_weigh(chain.tables, index < FEW ? SPECTRA_OF_FEW : SPECTRA, threads)) {
        fputs("lobefit: fit: not enough memory\n", stderr);
        return false;
    }
    return lobe_env_table_tier(self, request, chain.tables, taps, p);
}

/* Its first need is made from the other tiers: those that this command wrote, else those that ship. */
static bool fit_adaptive(const lobe_case *self, const lobe_fit_request *request)
{
    lobe_adaptive_tiers tiers;
    for (int i = 0; i < TIERS; i++) {
        if (chain.is_written[i])
            memcpy(tiers.p[i], chain.written[i], sizeof tiers.p[i]);
        else
            lobe_env_table_shipped(1 << i, tiers.p[i]);
    }
    if (!make_table_training(request->sweep.threads)) {
        fputs("lobefit: fit: not enough memory\n", stderr);
        return false;
    }
    return lobe_env_adaptive_tier(self, request, chain.tables, &tiers);
}

static bool fit1(const lobe_case *self, const lobe_fit_request *request) { return fit_tier(self, request, 0); }
static bool fit2(const lobe_case *self, const lobe_fit_request *request) { return fit_tier(self, request, 1); }
static bool fit4(const lobe_case *self, const lobe_fit_request *request) { return fit_tier(self, request, 2); }
static bool fit8(const lobe_case *self, const lobe_fit_request *request) { return fit_tier(self, request, 3); }
static bool table1(const lobe_case *self, const lobe_fit_request *request) { return fit_table(self, request, 0); }
static bool table2(const lobe_case *self, const lobe_fit_request *request) { return fit_table(self, request, 1); }
static bool table4(const lobe_case *self, const lobe_fit_request *request) { return fit_table(self, request, 2); }
static bool table8(const lobe_case *self, const lobe_fit_request *request) { return fit_table(self, request, 3); }

int lobe_env_lobes_fit(const lobe_case *self, int argc, char **argv)
{
    static const lobe_fit_tier all[2 * TIERS + 1] = {
        {"lobes1", fit1},           {"lobes2", fit2},           {"lobes4", fit4},
        {"lobes8", fit8},           {"lobes1_table16", table1}, {"lobes2_table16", table2},
        {"lobes4_table16", table4}, {"lobes8_table16", table8}, {"adaptive", fit_adaptive}};
    const int status = lobe_fit_command(self, all, 2 * TIERS + 1, argc, argv);
    lobe_env_table_training_free(chain.tables);
    lobe_training_free(chain.training);
    lobe_training_free(chain.few);
    memset(&chain, 0, sizeof chain);
    return status;
}
