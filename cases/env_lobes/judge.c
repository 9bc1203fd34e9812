#include "judge.h"
#include <math.h>
#include <stdlib.h>
#include "../fit/parallel.h"

const double lobe_judge_alpha[LOBE_JUDGE_ALPHAS] = {.04, .08, .16, .32, .6, 1};
const double lobe_judge_view[LOBE_JUDGE_VIEWS] = {.05, .25, .5, .75, 1};

typedef struct job {
    lobe_cell_options options;
    const lobe_judge_model *models;
    int count;
} job;

/* Square errors of every model at a point, relative and rms; the last column tells whether there was memory. */
static size_t columns(const job *j) { return 2 * (size_t)j->count + 1; }

static void judge_cell(const job *j, int c, double *room, double *out)
{
    const double alpha = lobe_judge_alpha[c / LOBE_JUDGE_VIEWS], v = lobe_judge_view[c % LOBE_JUDGE_VIEWS];
    lobe_cell *cell = lobe_cell_new(alpha, v, &j->options);
    double *scratch = cell ? malloc(sizeof *scratch * lobe_cell_scratch(cell)) : NULL;
    for (int m = 0; scratch && m < j->count; m++) {
        const lobe_judge_model *model = &j->models[m];
        if (model->taps) {
            lobe_cell_tap taps[LOBE_CELL_TAPS];
            double part[LOBE_CELL_PARTS];
            lobe_cell_errors(cell, taps, model->taps(model->ctx, alpha, v, taps), scratch, part);
            out[2 * m] = part[LOBE_CELL_SAMPLES];
            out[2 * m + 1] = part[LOBE_CELL_SPECTRA];
        } else {
            const int count = model->nodes(model->ctx, alpha, v, room);
            out[2 * m] = lobe_cell_samples_error(cell, room, count, scratch);
            out[2 * m + 1] = lobe_cell_spectra_error(cell, room, count, scratch);
        }
    }
    out[2 * j->count] = scratch != NULL;
    free(scratch);
    lobe_cell_free(cell);
}

static void ask(void *ctx, const double *params, size_t count, double *values)
{
    const job *j = ctx;
    double *room = malloc(sizeof *room * 5 * LOBE_JUDGE_NODES);
    for (size_t i = 0; i < count; i++) {
        double *out = values + i * columns(j);
        out[2 * j->count] = 0;
        if (room)
            judge_cell(j, (int)params[i], room, out);
    }
    free(room);
}

/* Means over the points. */
static bool sum_up(job *j, int threads, lobe_judge_error *errors)
{
    double number[LOBE_JUDGE_CELLS], *square = malloc(sizeof *square * LOBE_JUDGE_CELLS * columns(j));
    lobe_parallel parallel = {ask, j, 1, columns(j), (size_t)threads};
    bool good = square != NULL;
    for (int c = 0; c < LOBE_JUDGE_CELLS; c++)
        number[c] = c;
    if (good)
        lobe_parallel_eval(&parallel, number, LOBE_JUDGE_CELLS, square);
    for (int c = 0; good && c < LOBE_JUDGE_CELLS; c++)
        good = square[(size_t)(c + 1) * columns(j) - 1] != 0;
    for (int m = 0; good && m < j->count; m++) {
        lobe_judge_error sum = {0, 0};
        for (int c = 0; c < LOBE_JUDGE_CELLS; c++) {
            sum.relative += square[(size_t)c * columns(j) + 2 * (size_t)m] / LOBE_JUDGE_CELLS;
            sum.rms += square[(size_t)c * columns(j) + 2 * (size_t)m + 1] / LOBE_JUDGE_CELLS;
        }
        errors[m].relative = sqrt(sum.relative);
        errors[m].rms = sqrt(sum.rms);
    }
    free(square);
    return good;
}

bool lobe_judge_environment(const lobe_environment *map, const lobe_judge_options *options,
                            const lobe_judge_model *models, int count, lobe_judge_error *errors)
{
    lobe_env_spectrum spectrum;
    lobe_harmonics harmonics;
    lobe_orientations *orientations =
        lobe_orientations_new(map, 1, LOBE_JUDGE_ORIENTATIONS, options->seed, options->threads);
    lobe_sphere_kernels *kernels = lobe_sphere_kernels_new();
    bool good = orientations && kernels && lobe_harmonics_of(map, -1, &harmonics);
    if (good) {
        job j = {{orientations, kernels, &spectrum, 1, {1, 1, 1}, options->dark, 112, 1}, models, count};
        lobe_env_spectrum_of(&harmonics, &spectrum);
        lobe_harmonics_free(&harmonics);
        good = sum_up(&j, options->threads, errors);
    }
    lobe_sphere_kernels_free(kernels);
    lobe_orientations_free(orientations);
    return good;
}
