/* What the forms are judged on: 225 cells (alpha x radius x half length x view) of 60 capsules each, with the truth.
 * Fit and held-out cells share no alpha, radius, length or view. The segment's middle is at the distance 1; every
 * second one anywhere above -.1, the others near the mirror direction; the segment lies in any direction. None is
 * wholly set, no line passes nearer than 1.5 radii, or .2, to the point. */
#ifndef LOBE_CAPSULE_LIGHT_CELLS_H
#define LOBE_CAPSULE_LIGHT_CELLS_H
#include <stdbool.h>
#include "../fit/sweep.h"

enum { LOBE_CAPSULE_CELLS = 225, LOBE_CAPSULE_POSITIONS = 60, LOBE_CAPSULE_COUNT = 225 * 60, LOBE_CAPSULE_COLUMNS = 9 };

typedef struct lobe_capsule_cells {
    bool held;
    double *in;    /* rows of roughness, n_dot_v, middle, half, radius */
    double *truth; /* to 1e-6 */
} lobe_capsule_cells;

/* The view of a cell, in degrees. */
double lobe_capsule_cell_view(const lobe_capsule_cells *cells, int cell);

/* false: no memory. The truth takes some ten seconds on one processor. */
bool lobe_capsule_cells_make(lobe_capsule_cells *cells, bool held, const lobe_sweep_options *options);
void lobe_capsule_cells_free(lobe_capsule_cells *cells);

#endif
