/* What tables are fitted on: the environments of the training set and as many more of their kinds, in turn, at points
 * between the nodes as well as near them. A table has so many numbers that it would learn the orientations of one set
 * by heart. */
#ifndef LOBE_ENV_TABLE_TRAINING_H
#define LOBE_ENV_TABLE_TRAINING_H
#include <stdbool.h>
#include "table.h"
#include "training.h"

enum { LOBE_ENV_TABLE_GRID = 20, LOBE_ENV_TABLE_CELLS = LOBE_ENV_TABLE_GRID * LOBE_ENV_TABLE_GRID };

typedef struct lobe_env_table_training {
    lobe_env_table_point point[LOBE_ENV_TABLE_CELLS];
    double weight[LOBE_ENV_TABLE_CELLS]; /* sum to 1 */
    lobe_cell *cell[LOBE_ENV_TABLE_CELLS];
    double part;                  /* the weight of what is held against all orientations */
    lobe_cell_options options[2]; /* of every other cell */
    lobe_orientations *orientations[2];
    lobe_env_spectrum spectra[2][LOBE_TRAINING_MAPS];
    lobe_sphere_kernels *kernels;
} lobe_env_table_training;

/* Without cells. NULL where there is no memory. */
lobe_env_table_training *lobe_env_table_training_new(int threads);
void lobe_env_table_training_free(lobe_env_table_training *t);

/* Cells with this weight for what is held against all orientations, that of sampled ones being 1. False where there is
 * no memory. */
bool lobe_env_table_training_weigh(lobe_env_table_training *t, double part, int threads);

#endif
