/* The metric of the capsule light: the relative L2 error of a cell over its positions, then the root mean square over
 * the cells. */
#ifndef LOBE_CAPSULE_LIGHT_JUDGE_H
#define LOBE_CAPSULE_LIGHT_JUDGE_H
#include "cells.h"

typedef struct lobe_capsule_score {
    double all, view60, view75; /* all cells; view <= 60 degrees; >= 75 */
    double worst;
    double energy; /* of largest magnitude: sum of the form over sum of the truth in a cell, less 1 */
} lobe_capsule_score;

/* call: of a row of the cells. */
void lobe_capsule_judge(double (*call)(const double *row), const lobe_capsule_cells *cells, lobe_capsule_score *score);

/* The same of radiances that are known, one a position. */
void lobe_capsule_judge_values(const double *values, const lobe_capsule_cells *cells, lobe_capsule_score *score);

#endif
