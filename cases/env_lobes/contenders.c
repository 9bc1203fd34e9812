#define LOBE_DOUBLE 1
#include "contenders.h"
#include <math.h>
#include <stddef.h>
#include "../../models/env_lobes1.h"
#include "../../models/env_lobes2.h"
#include "../../models/env_lobes4.h"
#include "../../models/env_lobes8.h"
#include "kernels.h"

static lobe_cell_tap of_kernel(lobe_env_tap tap)
{
    const double alpha = tap.width * tap.width;
    const lobe_cell_tap out = {tap.angle, log(lobe_prefilter_t_of_alpha(alpha)), tap.weight};
    return out;
}

/* One tap as wide as the surface is rough, part of the way from the normal to the mirror direction. */
static int one_tap(double along, double alpha, double n_dot_v, lobe_cell_tap *tap)
{
    tap->angle = atan2(along * sqrt(1 - n_dot_v * n_dot_v), along * n_dot_v + 1 - along);
    tap->log_t = log(lobe_prefilter_t_of_alpha(alpha));
    tap->weight = 1;
    return 1;
}

static int split_sum(const void *ctx, double alpha, double n_dot_v, lobe_cell_tap *taps)
{
    (void)ctx;
    return one_tap(1, alpha, n_dot_v, taps);
}

static int dominant_direction(const void *ctx, double alpha, double n_dot_v, lobe_cell_tap *taps)
{
    const double smooth = 1 - alpha;
    (void)ctx;
    return one_tap(smooth * (sqrt(smooth) + alpha), alpha, n_dot_v, taps);
}

static int lobes1(const void *ctx, double alpha, double n_dot_v, lobe_cell_tap *taps)
{
    (void)ctx;
    taps[0] = of_kernel(lobe_env_lobes_lobes1(sqrt(alpha), n_dot_v, 1));
    return 1;
}

static int lobes2(const void *ctx, double alpha, double n_dot_v, lobe_cell_tap *taps)
{
    const lobe_env_fan2 fan = lobe_env_lobes_lobes2(sqrt(alpha), n_dot_v, 1);
    (void)ctx;
    taps[0] = of_kernel(fan.t0);
    taps[1] = of_kernel(fan.t1);
    return 2;
}

static int lobes4(const void *ctx, double alpha, double n_dot_v, lobe_cell_tap *taps)
{
    const lobe_env_fan4 fan = lobe_env_lobes_lobes4(sqrt(alpha), n_dot_v, 1);
    const lobe_env_tap tap[4] = {fan.t0, fan.t1, fan.t2, fan.t3};
    (void)ctx;
    for (int i = 0; i < 4; i++)
        taps[i] = of_kernel(tap[i]);
    return 4;
}

static int lobes8(const void *ctx, double alpha, double n_dot_v, lobe_cell_tap *taps)
{
    const lobe_env_fan8 fan = lobe_env_lobes_lobes8(sqrt(alpha), n_dot_v, 1);
    const lobe_env_tap tap[8] = {fan.t0, fan.t1, fan.t2, fan.t3, fan.t4, fan.t5, fan.t6, fan.t7};
    (void)ctx;
    for (int i = 0; i < 8; i++)
        taps[i] = of_kernel(tap[i]);
    return 8;
}

const lobe_judge_model lobe_contender[LOBE_CONTENDERS] = {
    {"split sum", split_sum, NULL, NULL}, {"dominant direction", dominant_direction, NULL, NULL},
    {"lobes1", lobes1, NULL, NULL},       {"lobes2", lobes2, NULL, NULL},
    {"lobes4", lobes4, NULL, NULL},       {"lobes8", lobes8, NULL, NULL},
};
