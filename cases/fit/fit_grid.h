/* The points that a model of roughness and NdotV is fitted on, with their truth. */
#ifndef LOBE_FIT_GRID_H
#define LOBE_FIT_GRID_H
#include <stdbool.h>
#include "../case.h"
#include "sweep.h"

/* The i-th of `side` places in [lo, 1], denser toward both ends, and more so toward lo. */
double lobe_fit_roughness(int i, int side, double lo);
double lobe_fit_n_dot_v(int i, int side, double lo);

/* side^2 such points. */
typedef struct lobe_fit_grid {
    size_t count;
    double *at;    /* rows of roughness and NdotV */
    double *truth; /* rows of the case's outputs */
} lobe_fit_grid;

/* False after a line on stderr. */
bool lobe_fit_grid_make(lobe_fit_grid *g, int side, double lo, const lobe_case *c, const lobe_sweep_options *sweep);
void lobe_fit_grid_free(lobe_fit_grid *g);

#endif
