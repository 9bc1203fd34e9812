#include "cells.h"
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include "../fit/truth_cache.h"
#include "truth_sphere.h"

enum { ALPHAS = 7, HALF_ANGLES = 7, VIEWS = 6 };

static const double pi = 3.14159265358979323846;
static const double alphas[2][ALPHAS] = {{.05, .1, .2, .35, .5, .7, 1}, {.06, .08, .15, .27, .42, .6, .85}};
static const double half_angles[2][HALF_ANGLES] = {{1, 2.5, 5, 10, 20, 30, 45}, {1.5, 3.5, 7, 14, 24, 36, 42}};
static const double views[2][VIEWS] = {{0, 30, 45, 60, 75, 85}, {10, 22, 38, 52, 78, 83}};

/* The generator of the exploration that README.md tells about, so that its numbers can be had again. */
static double unit(uint64_t *state)
{
    *state = *state * 6364136223846793005ull + 1442695040888963407ull;
    return (double)(*state >> 11) / 9007199254740992.0;
}

/* n_dot_l and azimuth into row. */
static void place(double *row, double alpha, bool uniform, uint64_t *state)
{
    const double sigma = row[4], v = row[1], s = sqrt(1 - v * v), spread = fmin(pi / 2, sigma + 3 * alpha);
    for (;;) {
        const double u0 = unit(state), u1 = unit(state), u2 = unit(state), t = spread * u0, turn = 2 * pi * u1;
        const double z = v * cos(t) + s * sin(t) * cos(turn);
        if (uniform) {
            row[2] = (1 + sin(sigma)) * u1 - sin(sigma);
            row[3] = pi * u2;
            return;
        }
        if (z >= -.98 * sin(sigma)) {
            row[2] = fmin(z, 1);
            row[3] = fabs(atan2(sin(t) * sin(turn), -s * cos(t) + v * sin(t) * cos(turn)));
            return;
        }
    }
}

static void rows_of(const double *in, double *out, size_t n, double f0)
{
    size_t i;
    for (i = 0; i < n; i++, in += 5) {
        const lobe_sphere_scene s = {in[0] * in[0], in[1], in[2], in[3], in[4], f0};
        out[i] = lobe_truth_sphere_stretched(&s, 1e-6);
    }
}
static void truth_rows(const double *in, double *out, size_t n) { rows_of(in, out, n, 1); }
static void dark_rows(const double *in, double *out, size_t n) { rows_of(in, out, n, 0); }

double lobe_sphere_cell_view(const lobe_sphere_cells *cells, int cell) { return views[cells->held][cell % VIEWS]; }

/* At another tolerance than the case's own truth, so under another name. */
static const lobe_case kept = {.name = "sphere_light_cells", .input_count = 5, .output_count = 1, .truth = truth_rows};
static const lobe_case kept_dark = {
    .name = "sphere_light_dark", .input_count = 5, .output_count = 1, .truth = dark_rows};

bool lobe_sphere_cells_make(lobe_sphere_cells *cells, bool held, bool mixed, const lobe_sweep_options *options)
{
    uint64_t state = held ? 99 : 7;
    int i;
    cells->held = held;
    cells->mixed = mixed;
    cells->dark = NULL;
    cells->in = malloc(5 * LOBE_SPHERE_COUNT * sizeof *cells->in);
    cells->truth = malloc(LOBE_SPHERE_COUNT * sizeof *cells->truth);
    if (!cells->in || !cells->truth)
        return false;
    for (i = 0; i < LOBE_SPHERE_COUNT; i++) {
        const int cell = i / LOBE_SPHERE_POSITIONS, position = i % LOBE_SPHERE_POSITIONS;
        const double alpha = alphas[held][cell / VIEWS / HALF_ANGLES];
        double *row = cells->in + 5 * i;
        row[0] = sqrt(alpha);
        row[1] = cos(views[held][cell % VIEWS] * pi / 180);
        row[4] = half_angles[held][cell / VIEWS % HALF_ANGLES] * pi / 180;
        place(row, alpha, !mixed || position >= LOBE_SPHERE_POSITIONS / 2, &state);
    }
    lobe_truth_cached(&kept, cells->in, cells->truth, LOBE_SPHERE_COUNT, options);
    return true;
}

bool lobe_sphere_cells_add_dark(lobe_sphere_cells *cells, const lobe_sweep_options *options)
{
    cells->dark = malloc(LOBE_SPHERE_COUNT * sizeof *cells->dark);
    if (cells->dark)
        lobe_truth_cached(&kept_dark, cells->in, cells->dark, LOBE_SPHERE_COUNT, options);
    return cells->dark != NULL;
}

void lobe_sphere_cells_free(lobe_sphere_cells *cells)
{
    free(cells->in);
    free(cells->truth);
    free(cells->dark);
    cells->in = cells->truth = cells->dark = NULL;
}
