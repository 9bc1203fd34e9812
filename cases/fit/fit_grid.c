#include "fit_grid.h"
#include <stdio.h>
#include <stdlib.h>

static double spread(double x, double lo, double dense)
{
    const double smooth = x * x * (3 - 2 * x), y = 0.5 * (x + smooth);
    return lo + (1 - lo) * y * (1 - dense + dense * y);
}

double lobe_fit_roughness(int i, int side, double lo) { return spread(i / (side - 1.0), lo, 0.65); }

double lobe_fit_n_dot_v(int i, int side, double lo) { return spread(i / (side - 1.0), lo, 0.8); }

bool lobe_fit_grid_make(lobe_fit_grid *g, int side, double lo, const lobe_case *c, const lobe_sweep_options *sweep)
{
    lobe_sweep_options options = *sweep;
    int i, k;
    g->count = (size_t)side * (size_t)side;
    g->at = malloc(2 * g->count * sizeof *g->at);
    g->truth = malloc((size_t)c->output_count * g->count * sizeof *g->truth);
    if (!g->at || !g->truth) {
        fputs("lobefit: fit: not enough memory\n", stderr);
        return false;
    }
    for (i = 0; i < side; i++) {
        for (k = 0; k < side; k++) {
            double *row = g->at + 2 * (i * side + k);
            row[0] = lobe_fit_roughness(i, side, lo);
            row[1] = lobe_fit_n_dot_v(k, side, lo);
        }
    }
    options.label = "truth";
    lobe_sweep(c->truth, g->at, 2, g->truth, c->output_count, g->count, &options);
    return true;
}

void lobe_fit_grid_free(lobe_fit_grid *g)
{
    free(g->at);
    free(g->truth);
    g->at = g->truth = NULL;
}
