/* Fits fans of 1, 2, 4 and 8 taps to a training set. */
#ifndef LOBE_ENV_FAN_FIT_H
#define LOBE_ENV_FAN_FIT_H
#include <stdbool.h>
#include "../fit/status.h"
#include "../fit/progress.h"
#include "fan.h"
#include "training.h"

typedef struct lobe_fan_fit {
    const lobe_training *training;
    int threads;
    lobe_progress_line line;
    bool free_energy; /* weights need not sum to 1: p has LOBE_FAN_TERMS more (fan.h); improve alone knows of it */
} lobe_fan_fit;

/* Levenberg-Marquardt from p; at most `budget` evaluations. The value is the objective. */
lobe_fit_result lobe_fan_improve(lobe_fan_fit *fit, int taps, int budget, double *p);

/* From starts of its own and, where half is not NULL, from a fit of half as many taps, each split in two: short runs
 * from all, long ones from the best two. p: the best. */
lobe_fit_result lobe_fan_search(lobe_fan_fit *fit, int taps, const double *half, double *p);

/* Root mean squares of the parts over the training set where alpha is at least .04. */
void lobe_fan_score(const lobe_fan_fit *fit, int taps, const double *p, double error[LOBE_CELL_PARTS]);

#endif
