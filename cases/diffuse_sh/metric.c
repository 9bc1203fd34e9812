#include "metric.h"
#include <math.h>
#include "closed_form.h"

enum { SIDE = 33 };

lobe_diffuse_score lobe_diffuse_judge(lobe_diffuse_model model)
{
    lobe_diffuse_score score = {0, 0, 0, 0};
    double wrong = 0, total = 0, furnace = 0;
    int i, k;
    for (i = 0; i < SIDE * SIDE; i++) {
        const double r = (i / SIDE) / (SIDE - 1.0), v = (i % SIDE) / (SIDE - 1.0);
        double c[9], e[9], miss = 0, all = 0;
        lobe_diffuse_closed_form(r, v, e);
        model(r, v, c);
        for (k = 0; k < 9; k++) {
            miss += (c[k] - e[k]) * (c[k] - e[k]);
            all += e[k] * e[k];
        }
        wrong += miss;
        total += all;
        score.light_max = fmax(score.light_max, sqrt(miss / all));
        furnace += (c[0] / e[0] - 1) * (c[0] / e[0] - 1);
        score.furnace_max = fmax(score.furnace_max, fabs(c[0] / e[0] - 1));
    }
    score.light = sqrt(wrong / total);
    score.furnace_rms = sqrt(furnace / (SIDE * SIDE));
    return score;
}
