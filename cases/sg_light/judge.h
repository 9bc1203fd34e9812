/* The metric of the spherical Gaussian light: the relative L2 error of a cell over its positions, then the root mean
 * square over the cells. */
#ifndef LOBE_SG_LIGHT_JUDGE_H
#define LOBE_SG_LIGHT_JUDGE_H
#include "candidates.h"
#include "cells.h"

typedef struct lobe_sg_score {
    double cell[LOBE_SG_CELLS];
    double all, smooth; /* all cells; those of lobe_sg_cell_smooth */
    double worst;
    double energy; /* of largest magnitude: sum of the form over sum of the truth in a cell, less 1 */
} lobe_sg_score;

void lobe_sg_judge(const lobe_sg_candidate *candidate, const lobe_sg_cells *cells, lobe_sg_score *score);

/* The same of values that are there already, a row of the cells each. */
void lobe_sg_judge_values(const double *values, const lobe_sg_cells *cells, lobe_sg_score *score);

#endif
