/* What the forms are judged on: 216 cells (alpha x sharpness x view) of 120 positions of the axis each, with the truth.
 * Fit and held-out cells share no alpha, no sharpness and no view. Two ways to place the axis: uniform is even over the
 * sphere above 1.5 widths of the Gaussian under the horizon, so that some lights go through it; mixed has the other
 * half within two widths + 3 alpha of the mirror direction, so that the peak is always sampled. A width is 1 / sqrt(s).
 */
#ifndef LOBE_SG_LIGHT_CELLS_H
#define LOBE_SG_LIGHT_CELLS_H
#include <stdbool.h>
#include "../fit/sweep.h"

enum { LOBE_SG_CELLS = 216, LOBE_SG_POSITIONS = 120, LOBE_SG_COUNT = 216 * 120 };

typedef struct lobe_sg_cells {
    bool held, mixed;
    double *in;    /* rows of roughness, n_dot_v, n_dot_l, azimuth, sharpness */
    double *truth; /* to 1e-6 */
} lobe_sg_cells;

/* alpha <= .25 and n_dot_v >= .4: where the published forms say that they work. */
bool lobe_sg_cell_smooth(const lobe_sg_cells *cells, int cell);

/* false: no memory. The truth takes some fifteen seconds on one processor, and is kept in build/truth. */
bool lobe_sg_cells_make(lobe_sg_cells *cells, bool held, bool mixed, const lobe_sweep_options *options);
void lobe_sg_cells_free(lobe_sg_cells *cells);

#endif
