#define LOBE_DOUBLE 1
#include "judge.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../../models/env_lobes1.h"
#include "../../models/env_lobes2.h"
#include "../../models/env_lobes4.h"
#include "../../models/env_lobes8.h"
#include "../fit/parallel.h"
#include "kernels.h"

const double lobe_judge_alpha[LOBE_JUDGE_ALPHAS] = {.04, .08, .16, .32, .6, 1};
const double lobe_judge_view[LOBE_JUDGE_VIEWS] = {.05, .25, .5, .75, 1};
const char *const lobe_judge_name[LOBE_JUDGE_MODELS] = {"split sum", "dominant direction", "lobes1", "lobes2", "lobes4",
                                                        "lobes8"};

static lobe_cell_tap of_kernel(lobe_env_tap tap)
{
    const double alpha = tap.width * tap.width;
    const lobe_cell_tap out = {tap.angle, log(lobe_prefilter_t_of_alpha(alpha)), tap.weight};
    return out;
}

static int split_sum(int dominant, double alpha, double n_dot_v, lobe_cell_tap *tap)
{
    const double smooth = 1 - alpha, along = dominant ? smooth * (sqrt(smooth) + alpha) : 1;
    tap->angle = atan2(along * sqrt(1 - n_dot_v * n_dot_v), along * n_dot_v + 1 - along);
    tap->log_t = log(lobe_prefilter_t_of_alpha(alpha));
    tap->weight = 1;
    return 1;
}

int lobe_judge_taps(int model, double alpha, double n_dot_v, lobe_cell_tap *taps)
{
    const double r = sqrt(alpha), v = n_dot_v;
    if (model == 2) {
        taps[0] = of_kernel(lobe_env_lobes_lobes1(r, v, 1));
        return 1;
    }
    if (model == 3) {
        const lobe_env_fan2 fan = lobe_env_lobes_lobes2(r, v, 1);
        taps[0] = of_kernel(fan.t0);
        taps[1] = of_kernel(fan.t1);
        return 2;
    }
    if (model == 4) {
        const lobe_env_fan4 fan = lobe_env_lobes_lobes4(r, v, 1);
        const lobe_env_tap tap[4] = {fan.t0, fan.t1, fan.t2, fan.t3};
        for (int i = 0; i < 4; i++)
            taps[i] = of_kernel(tap[i]);
        return 4;
    }
    if (model == 5) {
        const lobe_env_fan8 fan = lobe_env_lobes_lobes8(r, v, 1);
        const lobe_env_tap tap[8] = {fan.t0, fan.t1, fan.t2, fan.t3, fan.t4, fan.t5, fan.t6, fan.t7};
        for (int i = 0; i < 8; i++)
            taps[i] = of_kernel(tap[i]);
        return 8;
    }
    return split_sum(model == 1, alpha, n_dot_v, taps);
}

/* Per point: square errors of every model, relative and rms; the last tells whether there was memory. */
enum { COLUMNS = 2 * LOBE_JUDGE_MODELS + 1 };

static void ask(void *ctx, const double *params, size_t count, double *values)
{
    const lobe_cell_options *options = ctx;
    for (size_t i = 0; i < count; i++) {
        const int c = (int)params[i];
        const double alpha = lobe_judge_alpha[c / LOBE_JUDGE_VIEWS], v = lobe_judge_view[c % LOBE_JUDGE_VIEWS];
        double *out = values + i * COLUMNS;
        lobe_cell *cell = lobe_cell_new(alpha, v, options);
        double *scratch = cell ? malloc(sizeof *scratch * lobe_cell_scratch(cell)) : NULL;
        memset(out, 0, sizeof *out * COLUMNS);
        for (int m = 0; scratch && m < LOBE_JUDGE_MODELS; m++) {
            lobe_cell_tap taps[LOBE_CELL_TAPS];
            double part[LOBE_CELL_PARTS];
            lobe_cell_errors(cell, taps, lobe_judge_taps(m, alpha, v, taps), scratch, part);
            out[2 * m] = part[LOBE_CELL_SAMPLES];
            out[2 * m + 1] = part[LOBE_CELL_SPECTRA];
        }
        out[COLUMNS - 1] = scratch != NULL;
        free(scratch);
        lobe_cell_free(cell);
    }
}

bool lobe_judge_environment(const lobe_environment *map, unsigned seed, int threads, lobe_judge_errors *errors)
{
    lobe_env_spectrum spectrum;
    lobe_harmonics harmonics;
    lobe_orientations *orientations = lobe_orientations_new(map, 1, LOBE_JUDGE_ORIENTATIONS, seed, threads);
    lobe_sphere_kernels *kernels = lobe_sphere_kernels_new();
    bool good = orientations && kernels && lobe_harmonics_of(map, -1, &harmonics);
    memset(errors, 0, sizeof *errors);
    if (good) {
        double number[LOBE_JUDGE_CELLS], square[LOBE_JUDGE_CELLS * COLUMNS];
        lobe_cell_options options = {orientations, kernels, &spectrum, 1, {1, 1, 1}, 0, 112, 1};
        lobe_parallel parallel = {ask, &options, 1, COLUMNS, (size_t)threads};
        lobe_env_spectrum_of(&harmonics, &spectrum);
        lobe_harmonics_free(&harmonics);
        for (int c = 0; c < LOBE_JUDGE_CELLS; c++)
            number[c] = c;
        lobe_parallel_eval(&parallel, number, LOBE_JUDGE_CELLS, square);
        for (int c = 0; c < LOBE_JUDGE_CELLS; c++) {
            good = good && square[c * COLUMNS + COLUMNS - 1] != 0;
            for (int m = 0; m < LOBE_JUDGE_MODELS; m++) {
                errors->relative[m] += square[c * COLUMNS + 2 * m] / LOBE_JUDGE_CELLS;
                errors->rms[m] += square[c * COLUMNS + 2 * m + 1] / LOBE_JUDGE_CELLS;
            }
        }
        for (int m = 0; m < LOBE_JUDGE_MODELS; m++) {
            errors->relative[m] = sqrt(errors->relative[m]);
            errors->rms[m] = sqrt(errors->rms[m]);
        }
    }
    lobe_sphere_kernels_free(kernels);
    lobe_orientations_free(orientations);
    return good;
}
