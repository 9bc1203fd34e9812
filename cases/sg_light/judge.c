#include "judge.h"
#include <math.h>
#include <stdlib.h>

void lobe_sg_judge(const lobe_sg_candidate *candidate, const lobe_sg_cells *cells, lobe_sg_score *score)
{
    static const lobe_sg_score nothing;
    double *values = malloc(LOBE_SG_COUNT * sizeof *values);
    int i;
    *score = nothing;
    score->all = score->smooth = NAN; /* where there is no memory */
    if (!values)
        return;
    for (i = 0; i < LOBE_SG_COUNT; i++)
        values[i] = candidate->call(cells->in + 5 * i);
    lobe_sg_judge_values(values, cells, score);
    free(values);
}

void lobe_sg_judge_values(const double *values, const lobe_sg_cells *cells, lobe_sg_score *score)
{
    double all = 0, smooth = 0;
    int cell, i, count = 0;
    score->worst = score->energy = 0;
    for (cell = 0; cell < LOBE_SG_CELLS; cell++) {
        double error = 0, truth = 0, sum = 0, true_sum = 0, square, energy;
        for (i = cell * LOBE_SG_POSITIONS; i < (cell + 1) * LOBE_SG_POSITIONS; i++) {
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
        if (lobe_sg_cell_smooth(cells, cell)) {
            smooth += square;
            count++;
        }
        score->worst = fmax(score->worst, score->cell[cell]);
        if (fabs(energy) > fabs(score->energy))
            score->energy = energy;
    }
    score->all = sqrt(all / LOBE_SG_CELLS);
    score->smooth = sqrt(smooth / count);
}
