/* What a fan of taps loses at one (alpha, n_dot_v), as residuals whose squares add up to three weighted parts, each a
 * mean relative square error:
 *   samples   radiance in sampled orientations of the training environments, each relative to its own truth
 *   spectra   radiance under all orientations of the same environments, relative to its root mean square
 *   shape     the lobe itself
 * All is projected on what fans of taps can reach, which leaves few rows. */
#ifndef LOBE_ENV_CELL_H
#define LOBE_ENV_CELL_H
#include <stdbool.h>
#include "orientations.h"
#include "sphere_norm.h"

enum { LOBE_CELL_ROWS = 88, LOBE_CELL_TAPS = 8 };
typedef enum lobe_cell_part { LOBE_CELL_SAMPLES, LOBE_CELL_SPECTRA, LOBE_CELL_SHAPE, LOBE_CELL_PARTS } lobe_cell_part;

/* What a kernel gives, with weights that sum to 1, and with ln t (kernels.h) for the width. */
typedef struct lobe_cell_tap {
    double angle, log_t, weight;
} lobe_cell_tap;

typedef struct lobe_cell_options {
    const lobe_orientations *orientations; /* NULL: no samples */
    const lobe_sphere_kernels *kernels;
    const lobe_env_spectrum *spectra;
    int spectrum_count;            /* 0: no spectra */
    double share[LOBE_CELL_PARTS]; /* weights of the parts; of what is left out, 0 */
    double dark; /* a truth below this part of the mean over its environment counts as if it were it */
    int order;   /* of the nodes for the truth, visible_normals.h */
    int judge;   /* not 0: errors alone are asked for, no residuals, which spares the projection */
} lobe_cell_options;

typedef struct lobe_cell lobe_cell;

/* options stay in use. NULL where there is no memory. */
lobe_cell *lobe_cell_new(double alpha, double n_dot_v, const lobe_cell_options *options);
void lobe_cell_free(lobe_cell *cell);

/* As if made anew with options that differ in nothing but the weights of the parts, in a sixth of the time. False where
 * there is no memory: the cell is as it was. */
bool lobe_cell_weigh(lobe_cell *cell, const lobe_cell_options *options);

/* rows: LOBE_CELL_ROWS residuals. slopes, unless NULL: 3 count columns of as many, by angle, ln t and weight of each
 * tap in turn. scratch: lobe_cell_scratch doubles. */
size_t lobe_cell_scratch(const lobe_cell *cell);
void lobe_cell_residuals(const lobe_cell *cell, const lobe_cell_tap *taps, int count, double *scratch, double *rows,
                         double *slopes);

/* The parts without their weights, before projection. */
void lobe_cell_errors(const lobe_cell *cell, const lobe_cell_tap *taps, int count, double *scratch,
                      double error[LOBE_CELL_PARTS]);

/* Two of them for any lobe by a quadrature of it, rows as of lobe_visible_nodes, whose last column the first writes to.
 */
double lobe_cell_samples_error(const lobe_cell *cell, double *nodes, int count, double *scratch);
double lobe_cell_spectra_error(const lobe_cell *cell, const double *nodes, int count, double *scratch);

#endif
