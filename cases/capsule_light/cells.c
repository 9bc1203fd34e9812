#include "cells.h"
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include "truth_capsule.h"

enum { ALPHAS = 5, RADII = 3, LENGTHS = 3, VIEWS = 5 };

static const double pi = 3.14159265358979323846;
static const double alphas[2][ALPHAS] = {{.05, .15, .35, .6, 1}, {.07, .1, .25, .45, .8}};
static const double radii[2][RADII] = {{1.5, 5, 15}, {2.5, 8, 12}}; /* degrees */
static const double halves[2][LENGTHS] = {{.1, .4, 1}, {.2, .6, .8}};
static const double views[2][VIEWS] = {{0, 35, 60, 75, 85}, {20, 45, 55, 78, 83}};

/* The generator of the exploration that sphere_light/README.md tells about, so that its numbers can be had again. */
static double unit(uint64_t *state)
{
    *state = *state * 6364136223846793005ull + 1442695040888963407ull;
    return (double)(*state >> 11) / 9007199254740992.0;
}

static void direction(double out[3], double z, double turn)
{
    const double s = sqrt(1 - z * z);
    out[0] = s * cos(turn);
    out[1] = s * sin(turn);
    out[2] = z;
}

/* Middle and half into row, whose other columns are there. */
static void place(double *row, double length, bool anywhere, uint64_t *state)
{
    const double alpha = row[0] * row[0], v = row[1], s = sqrt(1 - v * v), radius = row[8];
    double *m = row + 2, *e = row + 5;
    for (;;) {
        double z, turn, along, line;
        int k;
        if (anywhere) {
            z = -.1 + 1.1 * unit(state);
            turn = 2 * pi * unit(state);
            direction(m, fmin(z, 1), turn);
        } else {
            const double t = fmin(1.2, asin(radius) + 2 * alpha + .5 * length) * unit(state);
            turn = 2 * pi * unit(state);
            m[0] = -s * cos(t) + v * sin(t) * cos(turn);
            m[1] = sin(t) * sin(turn);
            m[2] = v * cos(t) + s * sin(t) * cos(turn);
        }
        z = 2 * unit(state) - 1;
        turn = 2 * pi * unit(state);
        direction(e, z, turn);
        for (k = 0; k < 3; k++)
            e[k] *= length;
        along = (e[0] * m[0] + e[1] * m[1] + e[2] * m[2]) / length;
        line = sqrt(1 - along * along);
        if (line >= 1.5 * radius && line >= .2 && m[2] + fabs(e[2]) >= 0)
            return;
    }
}

static void truth_rows(const double *in, double *out, size_t n)
{
    size_t i;
    for (i = 0; i < n; i++, in += 9) {
        const lobe_capsule_scene s = {in[0] * in[0], in[1], 1, {in[2], in[3], in[4]}, {in[5], in[6], in[7]}, in[8]};
        out[i] = lobe_truth_capsule(&s, 1e-6);
    }
}

double lobe_capsule_cell_view(const lobe_capsule_cells *cells, int cell) { return views[cells->held][cell % VIEWS]; }

bool lobe_capsule_cells_make(lobe_capsule_cells *cells, bool held, const lobe_sweep_options *options)
{
    uint64_t state = held ? 77 : 3;
    int i;
    cells->held = held;
    cells->in = malloc(LOBE_CAPSULE_COLUMNS * LOBE_CAPSULE_COUNT * sizeof *cells->in);
    cells->truth = malloc(LOBE_CAPSULE_COUNT * sizeof *cells->truth);
    if (!cells->in || !cells->truth)
        return false;
    for (i = 0; i < LOBE_CAPSULE_COUNT; i++) {
        const int cell = i / LOBE_CAPSULE_POSITIONS;
        double *row = cells->in + LOBE_CAPSULE_COLUMNS * i;
        row[0] = sqrt(alphas[held][cell / VIEWS / LENGTHS / RADII]);
        row[1] = cos(views[held][cell % VIEWS] * pi / 180);
        row[8] = sin(radii[held][cell / VIEWS / LENGTHS % RADII] * pi / 180);
        place(row, halves[held][cell / VIEWS % LENGTHS], i & 1, &state);
    }
    lobe_sweep(truth_rows, cells->in, LOBE_CAPSULE_COLUMNS, cells->truth, 1, LOBE_CAPSULE_COUNT, options);
    return true;
}

void lobe_capsule_cells_free(lobe_capsule_cells *cells)
{
    free(cells->in);
    free(cells->truth);
    cells->in = cells->truth = NULL;
}
