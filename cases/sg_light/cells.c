#include "cells.h"
#include <math.h>
#include <stdlib.h>
#include "../fit/random.h"
#include "../fit/truth_cache.h"
#include "truth_sg.h"

enum { ALPHAS = 6, SHARPNESSES = 6, VIEWS = 6 };

static const double pi = 3.14159265358979323846;
static const double alphas[2][ALPHAS] = {{.05, .1, .2, .4, .7, 1}, {.06, .14, .25, .5, .6, .85}};
static const double sharpnesses[2][SHARPNESSES] = {{4, 16, 64, 256, 1024, 4096}, {5, 10, 32, 128, 512, 2896}};
static const double views[2][VIEWS] = {{.05, .15, .3, .5, .75, 1}, {.07, .11, .22, .42, .62, .9}};

static double sharpness_of(const lobe_sg_cells *cells, int cell)
{
    return sharpnesses[cells->held][cell / VIEWS % SHARPNESSES];
}
static double alpha_of(const lobe_sg_cells *cells, int cell) { return alphas[cells->held][cell / VIEWS / SHARPNESSES]; }
static double view_of(const lobe_sg_cells *cells, int cell) { return views[cells->held][cell % VIEWS]; }

bool lobe_sg_cell_smooth(const lobe_sg_cells *cells, int cell)
{
    return alpha_of(cells, cell) <= .25 && view_of(cells, cell) >= .4;
}

/* n_dot_l and azimuth into row. */
static void place(double *row, double alpha, bool uniform, lobe_random *random)
{
    const double width = 1 / sqrt(row[4]), v = row[1], s = sqrt(1 - v * v), low = -fmin(1, 1.5 * width);
    const double spread = fmin(pi / 2, 2 * width + 3 * alpha);
    for (;;) {
        const double u0 = lobe_random_unit(random), u1 = lobe_random_unit(random);
        const double t = spread * u0, turn = 2 * pi * u1, z = v * cos(t) + s * sin(t) * cos(turn);
        if (uniform) {
            row[2] = low + (1 - low) * u0;
            row[3] = pi * u1;
            return;
        }
        if (z >= low) {
            row[2] = fmin(z, 1);
            row[3] = fabs(atan2(sin(t) * sin(turn), -s * cos(t) + v * sin(t) * cos(turn)));
            return;
        }
    }
}

static void truth_rows(const double *in, double *out, size_t n)
{
    size_t i;
    for (i = 0; i < n; i++, in += 5) {
        const lobe_sg_scene s = {in[0] * in[0], in[1], in[2], in[3], in[4]};
        out[i] = lobe_truth_sg_axis(&s, 1e-6);
    }
}

/* At another tolerance than the case's own truth, so under another name. */
static const lobe_case kept = {.name = "sg_light_cells", .input_count = 5, .output_count = 1, .truth = truth_rows};

bool lobe_sg_cells_make(lobe_sg_cells *cells, bool held, bool mixed, const lobe_sweep_options *options)
{
    lobe_random random;
    int i;
    lobe_random_seed(&random, held ? 99 : 7, mixed);
    cells->held = held;
    cells->mixed = mixed;
    cells->in = malloc(5 * LOBE_SG_COUNT * sizeof *cells->in);
    cells->truth = malloc(LOBE_SG_COUNT * sizeof *cells->truth);
    if (!cells->in || !cells->truth)
        return false;
    for (i = 0; i < LOBE_SG_COUNT; i++) {
        const int cell = i / LOBE_SG_POSITIONS, position = i % LOBE_SG_POSITIONS;
        const double alpha = alpha_of(cells, cell);
        double *row = cells->in + 5 * i;
        row[0] = sqrt(alpha);
        row[1] = view_of(cells, cell);
        row[4] = sharpness_of(cells, cell);
        place(row, alpha, !mixed || position >= LOBE_SG_POSITIONS / 2, &random);
    }
    lobe_truth_cached(&kept, cells->in, cells->truth, LOBE_SG_COUNT, options);
    return true;
}

void lobe_sg_cells_free(lobe_sg_cells *cells)
{
    free(cells->in);
    free(cells->truth);
    cells->in = cells->truth = NULL;
}
