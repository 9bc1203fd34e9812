#include "table_training.h"
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include "../fit/parallel.h"

enum { GRID = LOBE_ENV_TABLE_GRID, CELLS = LOBE_ENV_TABLE_CELLS, LATER = 10 };

static void make_cells(void *ctx, const double *params, size_t count, double *values)
{
    lobe_env_table_training *t = ctx;
    for (size_t i = 0; i < count; i++) {
        const int c = (int)params[i];
        const lobe_cell_options *options = &t->options[(c / GRID + c % GRID) % 2];
        if (t->cell[c]) {
            values[i] = lobe_cell_weigh(t->cell[c], options);
        } else {
            t->cell[c] = lobe_cell_new(t->point[c].alpha, t->point[c].n_dot_v, options);
            values[i] = t->cell[c] != NULL;
        }
    }
}

/* Even in the roughness from alpha .02 on, and from n_dot_v .03 on denser toward grazing views, where smooth surfaces
 * change over shorter stretches. */
static lobe_env_table_point place(int c)
{
    const double x = (c / GRID) / (GRID - 1.0), y = (c % GRID) / (GRID - 1.0);
    const double least = sqrt(.02), r = least + (1 - least) * x, alpha = x < 1 ? r * r : 1;
    const double bend = .1 + .4 * alpha, from = (1 + bend) * .03 / (.03 + bend), at = from + (1 - from) * y;
    return lobe_env_table_point_of(alpha, y < 1 ? bend * at / (1 + bend - at) : 1);
}

lobe_env_table_training *lobe_env_table_training_new(int threads)
{
    lobe_env_table_training *t = calloc(1, sizeof *t);
    bool good = t && (t->kernels = lobe_sphere_kernels_new()) != NULL;
    double sum = 0;
    for (unsigned i = 0; good && i < 2; i++) {
        t->orientations[i] = lobe_training_light(i * LATER, t->spectra[i], threads);
        good = t->orientations[i] != NULL;
    }
    if (!good) {
        lobe_env_table_training_free(t);
        return NULL;
    }
    for (int c = 0; c < CELLS; c++) {
        t->point[c] = place(c);
        t->weight[c] = t->point[c].alpha < .03 ? .3 : 1;
        sum += t->weight[c];
    }
    for (int c = 0; c < CELLS; c++)
        t->weight[c] /= sum;
    return t;
}

static void forget_cells(lobe_env_table_training *t)
{
    for (int c = 0; c < CELLS; c++) {
        lobe_cell_free(t->cell[c]);
        t->cell[c] = NULL;
    }
}

bool lobe_env_table_training_weigh(lobe_env_table_training *t, double part, int threads)
{
    lobe_parallel parallel = {make_cells, t, 1, 1, (size_t)threads};
    double number[CELLS], made[CELLS];
    bool good = true;
    if (t->cell[0] && t->part == part)
        return true;
    for (int i = 0; i < 2; i++) {
        const lobe_cell_options options = {
            t->orientations[i], t->kernels, t->spectra[i], LOBE_TRAINING_MAPS, {1, part, .05}, .1, 72, 0};
        t->options[i] = options;
    }
    for (int c = 0; c < CELLS; c++)
        number[c] = c;
    lobe_parallel_eval(&parallel, number, CELLS, made);
    for (int c = 0; c < CELLS; c++)
        good = good && made[c] != 0;
    t->part = part;
    if (!good)
        forget_cells(t);
    return good;
}

void lobe_env_table_training_free(lobe_env_table_training *t)
{
    if (t) {
        forget_cells(t);
        lobe_orientations_free(t->orientations[0]);
        lobe_orientations_free(t->orientations[1]);
        lobe_sphere_kernels_free(t->kernels);
    }
    free(t);
}
