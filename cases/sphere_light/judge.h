/* The metric of the sphere light: the relative L2 error of a cell over its positions, then the root mean square over
 * the cells. */
#ifndef LOBE_SPHERE_LIGHT_JUDGE_H
#define LOBE_SPHERE_LIGHT_JUDGE_H
#include "candidates.h"
#include "cells.h"

typedef struct lobe_sphere_score {
    double cell[LOBE_SPHERE_CELLS];
    double all, view60, view75; /* all cells; view <= 60 degrees; >= 75 */
    double worst;
    double energy; /* of largest magnitude: sum of the form over sum of the truth in a cell, less 1 */
} lobe_sphere_score;

void lobe_sphere_judge(const lobe_sphere_candidate *candidate, const lobe_sphere_cells *cells,
                       lobe_sphere_score *score);

/* The same of values that are there already, a row of the cells each. */
void lobe_sphere_judge_values(const double *values, const lobe_sphere_cells *cells, lobe_sphere_score *score);

/* The same under Schlick with reflectance f0, of radiance and schlick apart; the cells have their dark truth. All is
 * NAN where there is no memory. */
void lobe_sphere_judge_lit(const double *radiance, const double *schlick, double f0, const lobe_sphere_cells *cells,
                           lobe_sphere_score *score);

/* How much worse than base in a cell with sin(half angle) / alpha < 1/2, at most; not below 0. */
double lobe_sphere_excess(const lobe_sphere_score *score, const lobe_sphere_score *base,
                          const lobe_sphere_cells *cells);

#endif
