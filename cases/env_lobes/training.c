#include "training.h"
#include <stdbool.h>
#include <stdlib.h>
#include "../fit/parallel.h"
#include "rooms.h"

/* Seeds from 101 on are for judging (front.c). */
static const struct {
    lobe_room room;
    unsigned seed;
} maps[LOBE_TRAINING_MAPS] = {
    {LOBE_ROOM_SKY, 1},   {LOBE_ROOM_SKY, 2},     {LOBE_ROOM_SKY, 3},    {LOBE_ROOM_LAMPS, 1},  {LOBE_ROOM_LAMPS, 2},
    {LOBE_ROOM_LAMPS, 3}, {LOBE_ROOM_CHECKER, 1}, {LOBE_ROOM_CLOUDS, 1}, {LOBE_ROOM_CLOUDS, 2},
};

enum { EACH = 80, WIDTH = 256 };

static const double alphas[LOBE_TRAINING_ALPHAS] = {.02, .04, .07, .11, .17, .25, .37, .52, .74, 1};
static const double views[LOBE_TRAINING_VIEWS] = {.03, .06, .12, .2, .32, .46, .62, .78, .9, 1};

lobe_orientations *lobe_training_light(unsigned later, lobe_env_spectrum spectra[LOBE_TRAINING_MAPS], int threads)
{
    lobe_orientations *orientations;
    lobe_environment map[LOBE_TRAINING_MAPS];
    bool good = true;
    int made = 0;
    for (; good && made < LOBE_TRAINING_MAPS; made++) {
        lobe_harmonics h;
        good = lobe_room_make(&map[made], maps[made].room, WIDTH, maps[made].seed + later);
        if (good && lobe_harmonics_of(&map[made], -1, &h)) {
            lobe_env_spectrum_of(&h, &spectra[made]);
            lobe_harmonics_free(&h);
        } else {
            good = false;
        }
    }
    orientations = good ? lobe_orientations_new(map, LOBE_TRAINING_MAPS, EACH, 1 + later, threads) : NULL;
    while (made--)
        lobe_environment_free(&map[made]);
    return orientations;
}

static bool light(lobe_training *t, int threads)
{
    t->orientations = lobe_training_light(0, t->spectra, threads);
    return t->orientations != NULL;
}

static void make_cells(void *ctx, const double *params, size_t count, double *values)
{
    lobe_training *t = ctx;
    for (size_t i = 0; i < count; i++) {
        const int c = (int)params[i];
        t->cell[c] = lobe_cell_new(t->alpha[c], t->n_dot_v[c], &t->options);
        values[i] = t->cell[c] != NULL;
    }
}

static bool fill(lobe_training *t, int threads)
{
    lobe_parallel parallel = {make_cells, t, 1, 1, (size_t)threads};
    double number[LOBE_TRAINING_CELLS], made[LOBE_TRAINING_CELLS];
    bool good = true;
    for (int c = 0; c < LOBE_TRAINING_CELLS; c++) {
        t->alpha[c] = alphas[c / LOBE_TRAINING_VIEWS];
        t->n_dot_v[c] = views[c % LOBE_TRAINING_VIEWS];
        /* what is narrower than .04 stands there to keep the polynomials sane */
        t->weight[c] = (c < LOBE_TRAINING_VIEWS ? 0.1 : 1) / (LOBE_TRAINING_CELLS - 0.9 * LOBE_TRAINING_VIEWS);
        number[c] = c;
    }
    lobe_parallel_eval(&parallel, number, LOBE_TRAINING_CELLS, made);
    for (int c = 0; c < LOBE_TRAINING_CELLS; c++)
        good = good && made[c] != 0;
    return good;
}

/* t or, where anything failed, NULL. */
static lobe_training *filled(lobe_training *t, bool good, int threads)
{
    if (good && fill(t, threads))
        return t;
    lobe_training_free(t);
    return NULL;
}

lobe_training *lobe_training_new(double spectra, int threads)
{
    lobe_training *t = calloc(1, sizeof *t);
    const bool good = t && light(t, threads) && (t->kernels = lobe_sphere_kernels_new()) != NULL;
    if (good) {
        const lobe_cell_options options = {t->orientations,   t->kernels, t->spectra, LOBE_TRAINING_MAPS,
                                           {1, spectra, .05}, .1,         72,         0};
        t->options = options;
    }
    return filled(t, good, threads);
}

lobe_training *lobe_training_of_shape(int threads)
{
    lobe_training *t = calloc(1, sizeof *t);
    const bool good = t && (t->kernels = lobe_sphere_kernels_new()) != NULL;
    if (good) {
        const lobe_cell_options options = {NULL, t->kernels, NULL, 0, {0, 0, 1}, 0, 1, 0};
        t->options = options;
    }
    return filled(t, good, threads);
}

void lobe_training_free(lobe_training *t)
{
    for (int c = 0; t && c < LOBE_TRAINING_CELLS; c++)
        lobe_cell_free(t->cell[c]);
    if (t) {
        lobe_orientations_free(t->orientations);
        lobe_sphere_kernels_free(t->kernels);
    }
    free(t);
}
