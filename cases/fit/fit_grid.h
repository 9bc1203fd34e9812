/* The points that a model of roughness and NdotV is fitted on, with their truth. */
#ifndef LOBE_FIT_GRID_H
#define LOBE_FIT_GRID_H
#include <stdbool.h>
#include "../case.h"
#include "sweep.h"

/* side^2 points over [lo, 1]^2, denser toward every edge and toward low roughness and grazing views. */
typedef struct lobe_fit_grid {
    size_t count;
    double *at;    /* rows of roughness and NdotV */
    double *truth; /* rows of the case's outputs */
} lobe_fit_grid;

/* False after a line on stderr. */
bool lobe_fit_grid_make(lobe_fit_grid *g, int side, double lo, const lobe_case *c, const lobe_sweep_options *sweep);
void lobe_fit_grid_free(lobe_fit_grid *g);

#endif
