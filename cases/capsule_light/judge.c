#include "judge.h"
#include <math.h>

enum { POSITIONS = LOBE_CAPSULE_POSITIONS };

void lobe_capsule_judge_values(const double *values, const lobe_capsule_cells *cells, lobe_capsule_score *score)
{
    double all = 0, view60 = 0, view75 = 0;
    int cell, i, count60 = 0, count75 = 0;
    score->worst = score->energy = 0;
    for (cell = 0; cell < LOBE_CAPSULE_CELLS; cell++) {
        const double view = lobe_capsule_cell_view(cells, cell);
        double error = 0, truth = 0, sum = 0, true_sum = 0, square, energy;
        for (i = cell * POSITIONS; i < (cell + 1) * POSITIONS; i++) {
            const double y = values[i], t = cells->truth[i];
            error += (y - t) * (y - t);
            truth += t * t;
            sum += y;
            true_sum += t;
        }
        square = error / truth;
        energy = sum / true_sum - 1;
        all += square;
        if (view <= 60) {
            view60 += square;
            count60++;
        } else if (view >= 75) {
            view75 += square;
            count75++;
        }
        score->worst = fmax(score->worst, sqrt(square));
        if (fabs(energy) > fabs(score->energy))
            score->energy = energy;
    }
    score->all = sqrt(all / LOBE_CAPSULE_CELLS);
    score->view60 = sqrt(view60 / count60);
    score->view75 = sqrt(view75 / count75);
}

void lobe_capsule_judge(double (*call)(const double *row), const lobe_capsule_cells *cells, lobe_capsule_score *score)
{
    double values[LOBE_CAPSULE_COUNT];
    int i;
    for (i = 0; i < LOBE_CAPSULE_COUNT; i++)
        values[i] = call(cells->in + LOBE_CAPSULE_COLUMNS * i);
    lobe_capsule_judge_values(values, cells, score);
}
