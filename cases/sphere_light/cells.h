/* What the forms are judged on: 294 cells (alpha x half angle x view) of 200 light positions each, with the truth. Fit
 * and held-out cells share no alpha, no half angle and no view. Two ways to place the light: uniform is even over the
 * sphere above -sin(half angle), so that some lights go through the horizon; mixed has the other half within half
 * angle + 3 alpha of the mirror direction, so that the peak is always sampled. */
#ifndef LOBE_SPHERE_LIGHT_CELLS_H
#define LOBE_SPHERE_LIGHT_CELLS_H
#include <stdbool.h>
#include "../fit/sweep.h"

enum { LOBE_SPHERE_CELLS = 294, LOBE_SPHERE_POSITIONS = 200, LOBE_SPHERE_COUNT = 294 * 200 };

typedef struct lobe_sphere_cells {
    bool held, mixed;
    double *in;    /* rows of roughness, n_dot_v, n_dot_l, azimuth, half angle */
    double *truth; /* to 2e-6 */
    double *dark;  /* the same under Schlick with F0 = 0, where lobe_sphere_cells_add_dark was called */
} lobe_sphere_cells;

/* The view of a cell, in degrees. */
double lobe_sphere_cell_view(const lobe_sphere_cells *cells, int cell);

/* false: no memory. The truth takes some ten seconds on one processor, and is kept in build/truth. */
bool lobe_sphere_cells_make(lobe_sphere_cells *cells, bool held, bool mixed, const lobe_sweep_options *options);

/* The truth under Schlick with F0 = 0, at the same price; that of any F0 is f0 truth + (1 - f0) dark. false: no memory.
 */
bool lobe_sphere_cells_add_dark(lobe_sphere_cells *cells, const lobe_sweep_options *options);

void lobe_sphere_cells_free(lobe_sphere_cells *cells);

#endif
