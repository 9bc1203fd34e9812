#define LOBE_DOUBLE 1
#include "adaptive_contender.h"
#include <math.h>
#include <stddef.h>
#include "../../models/env_lobes_adaptive.h"
#include "kernels.h"

enum { TAPS = 6 };

static int adaptive(const void *ctx, double alpha, double n_dot_v, lobe_cell_tap *taps)
{
    const lobe_env_fan6 fan = lobe_env_adaptive_fan(sqrt(alpha), n_dot_v, 1);
    const lobe_env_tap all[TAPS] = {fan.t0, fan.t1, fan.t2, fan.t3, fan.t4, fan.t5};
    const int count = (int)lobe_env_adaptive_count(sqrt(alpha), n_dot_v);
    (void)ctx;
    for (int i = 0; i < count; i++) {
        const lobe_cell_tap tap = {all[i].angle, log(lobe_prefilter_t_of_alpha(all[i].width * all[i].width)),
                                   all[i].weight};
        taps[i] = tap;
    }
    return count;
}

const lobe_judge_model lobe_adaptive_contender = {"adaptive", adaptive, NULL, NULL};

double lobe_adaptive_contender_mean(int side)
{
    double count = 0;
    for (int i = 0; i < side * side; i++) {
        const lobe_env_fan6 fan = lobe_env_adaptive_fan((i / side + 0.5) / side, (i % side + 0.5) / side, 1);
        const double weight[TAPS] = {fan.t0.weight, fan.t1.weight, fan.t2.weight,
                                     fan.t3.weight, fan.t4.weight, fan.t5.weight};
        for (int k = 0; k < TAPS; k++)
            count += weight[k] != 0;
    }
    return count / (side * side);
}
