#include "judge.h"
#include <math.h>
#include <stdlib.h>

void lobe_sphere_judge(const lobe_sphere_candidate *candidate, const lobe_sphere_cells *cells, lobe_sphere_score *score)
{
    static const lobe_sphere_score nothing;
    double *values = malloc(LOBE_SPHERE_COUNT * sizeof *values);
    int i;
    *score = nothing;
    score->all = score->view60 = score->view75 = NAN; /* where there is no memory */
    if (!values)
        return;
    for (i = 0; i < LOBE_SPHERE_COUNT; i++)
        values[i] = candidate->call(cells->in + 5 * i);
    lobe_sphere_judge_values(values, cells, score);
    free(values);
}

void lobe_sphere_judge_values(const double *values, const lobe_sphere_cells *cells, lobe_sphere_score *score)
{
    double all = 0, view60 = 0, view75 = 0;
    int cell, i, count60 = 0, count75 = 0;
    score->worst = score->energy = 0;
    for (cell = 0; cell < LOBE_SPHERE_CELLS; cell++) {
        const double view = lobe_sphere_cell_view(cells, cell);
        double error = 0, truth = 0, sum = 0, true_sum = 0, square, energy;
        for (i = cell * LOBE_SPHERE_POSITIONS; i < (cell + 1) * LOBE_SPHERE_POSITIONS; i++) {
            const double y = values[i], t = cells->truth[i];
            error += (y - t) * (y - t);
            truth += t * t;
            sum += y;
            true_sum += t;
        }
        square = error / truth;
        energy = sum / true_sum - 1;
        score->cell[cell] = sqrt(square);
        all += square;
        if (view <= 60) {
            view60 += square;
            count60++;
        } else if (view >= 75) {
            view75 += square;
            count75++;
        }
        score->worst = fmax(score->worst, score->cell[cell]);
        if (fabs(energy) > fabs(score->energy))
            score->energy = energy;
    }
    score->all = sqrt(all / LOBE_SPHERE_CELLS);
    score->view60 = sqrt(view60 / count60);
    score->view75 = sqrt(view75 / count75);
}

void lobe_sphere_judge_lit(const double *radiance, const double *schlick, double f0, const lobe_sphere_cells *cells,
                           lobe_sphere_score *score)
{
    lobe_sphere_cells dimmed = *cells;
    double *values = malloc(2 * LOBE_SPHERE_COUNT * sizeof *values);
    int i;
    if (!values) {
        score->all = score->view60 = score->view75 = NAN;
        return;
    }
    dimmed.truth = values + LOBE_SPHERE_COUNT;
    for (i = 0; i < LOBE_SPHERE_COUNT; i++) {
        values[i] = radiance[i] * (f0 + (1 - f0) * schlick[i]);
        dimmed.truth[i] = f0 * cells->truth[i] + (1 - f0) * cells->dark[i];
    }
    lobe_sphere_judge_values(values, &dimmed, score);
    free(values);
}

double lobe_sphere_excess(const lobe_sphere_score *score, const lobe_sphere_score *base, const lobe_sphere_cells *cells)
{
    double excess = 0;
    int cell;
    for (cell = 0; cell < LOBE_SPHERE_CELLS; cell++) {
        const double *row = cells->in + 5 * cell * LOBE_SPHERE_POSITIONS;
        if (sin(row[4]) < .5 * row[0] * row[0])
            excess = fmax(excess, score->cell[cell] - base->cell[cell]);
    }
    return excess;
}
