/* What env_lobes is fitted on: environments that need no file, a grid of (alpha, n_dot_v), and the weights of the parts
 * of the objective (cell.h). */
#ifndef LOBE_ENV_TRAINING_H
#define LOBE_ENV_TRAINING_H
#include "cell.h"

enum { LOBE_TRAINING_ALPHAS = 10, LOBE_TRAINING_VIEWS = 10, LOBE_TRAINING_CELLS = 100, LOBE_TRAINING_MAPS = 9 };

typedef struct lobe_training {
    lobe_cell_options options;
    lobe_orientations *orientations;
    lobe_sphere_kernels *kernels;
    lobe_env_spectrum spectra[LOBE_TRAINING_MAPS];
    double alpha[LOBE_TRAINING_CELLS], n_dot_v[LOBE_TRAINING_CELLS], weight[LOBE_TRAINING_CELLS]; /* weights sum to 1 */
    lobe_cell *cell[LOBE_TRAINING_CELLS];
} lobe_training;

/* Of the shape alone: neither environments nor samples. NULL where there is no memory. */
lobe_training *lobe_training_of_shape(int threads);

/* The weight of what is held against all orientations; that of sampled ones is 1. NULL where there is no memory. */
lobe_training *lobe_training_new(double spectra, int threads);
void lobe_training_free(lobe_training *t);

/* The environments alone, at sampled orientations, with their spectra: those of the training set, or others of the same
 * kinds, whose seeds are `later`, under 90, by that much. NULL where there is no memory. */
lobe_orientations *lobe_training_light(unsigned later, lobe_env_spectrum spectra[LOBE_TRAINING_MAPS], int threads);

#endif
