#include "fan.h"
#include <math.h>

static double place(int i, int count) { return count > 1 ? (2.0 * i - (count - 1)) / (count - 1) : 0; }

static void normalise(lobe_sg *lobes, int count, double energy)
{
    double sum = 0;
    int i;
    for (i = 0; i < count; i++)
        sum += lobes[i].weight;
    for (i = 0; i < count; i++)
        lobes[i].weight *= energy / sum;
}

void lobe_sg_fan_lobes(const lobe_sg_fan *fan, int count, double energy, lobe_sg *lobes)
{
    int i;
    for (i = 0; i < count; i++) {
        const double d = place(i, count);
        lobes[i].angle = fan->centre + fan->spread * d;
        lobes[i].sharpness = fan->flare == 0 ? fan->sharpness : fan->sharpness * exp(-fan->flare * d * d);
        /* fabs: with a taper below 0 the outmost is the largest; either way no exponential overflows */
        lobes[i].weight = exp(fan->tilt * d - fan->taper * d * d - fabs(fan->tilt) + fmin(0, fan->taper));
    }
    normalise(lobes, count, energy);
}

void lobe_sg_weigh_printed(lobe_sg *lobes, int count, double energy)
{
    const double spread = 0.5 * (lobes[count - 1].angle - lobes[0].angle);
    int i;
    for (i = 0; i < count; i++) {
        const double number = i - 0.5 * (count - 1), square = number * number;
        lobes[i].weight = exp(-spread / 3 * square * square);
    }
    normalise(lobes, count, energy);
}

void lobe_sg_fan_printed(const lobe_sg_fan *fan, int count, double energy, lobe_sg *lobes)
{
    int i;
    for (i = 0; i < count; i++) {
        lobes[i].angle = fan->centre + fan->spread * place(i, count);
        lobes[i].sharpness = fan->sharpness;
    }
    lobe_sg_weigh_printed(lobes, count, energy);
}

lobe_sg_fan lobe_sg_fan_start(double alpha, double n_dot_v)
{
    const lobe_sg_fan fan = {.centre = acos(n_dot_v),
                             .spread = fmin(0.3, alpha),
                             .sharpness = 0.5 / (alpha * alpha * fmax(n_dot_v, 0.15)),
                             .taper = 1.5};
    return fan;
}
