/* Fits tables of fans of taps to a training set. */
#ifndef LOBE_ENV_TABLE_FIT_H
#define LOBE_ENV_TABLE_FIT_H
#include "../fit/progress.h"
#include "../fit/status.h"
#include "table_training.h"

typedef struct lobe_env_table_fit {
    const lobe_env_table_training *training;
    int threads;
    double stiffness; /* of the differences between what neighbours move by */
    lobe_progress_line line;
} lobe_env_table_fit;

/* Levenberg-Marquardt from the table; at most `budget` linearisations. What neighbouring nodes move apart by costs
 * something, so that a tap of one stays the same tap in the next, and nodes that no point sees follow the others. Held
 * to lobe_env_table_bounds. The value is the objective alone. The same bytes for any number of threads. */
lobe_fit_result lobe_env_table_improve(lobe_env_table_fit *fit, int taps, int budget, double *table);

/* Root mean squares of the parts over the training points where alpha is at least .04. */
void lobe_env_table_score(const lobe_env_table_fit *fit, int taps, const double *table, double error[LOBE_CELL_PARTS]);

#endif
