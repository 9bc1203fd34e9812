#define LOBE_DOUBLE 1
#include "fan.h"
#include <math.h>
#include "../../models/env_lobes.h"

lobe_fan_point lobe_fan_point_of(double alpha, double n_dot_v)
{
    const lobe_env_point k = lobe_env_point_of(sqrt(alpha), n_dot_v);
    const lobe_fan_point p = {
        alpha, n_dot_v, k.theta, k.reach, {1, k.f1, k.f2, k.f3, k.f4, k.f5, k.f6, k.f7, k.f8, k.f9, k.f10, k.f11},
    };
    return p;
}

int lobe_fan_count(int taps) { return 36 * taps - 12; }

int lobe_fan_first(int tap, int quantity) { return 12 * (3 * tap + quantity); }

static double sum(const lobe_fan_point *point, const double *c)
{
    double s = 0;
    for (int i = 0; i < LOBE_FAN_TERMS; i++)
        s += c[i] * point->term[i];
    return s;
}

void lobe_fan_taps(const lobe_fan_point *point, const double *p, int taps, lobe_cell_tap *out, double *growth)
{
    double rest = 1;
    for (int i = 0; i < taps; i++) {
        const double power = exp2(fmin(8, sum(point, p + lobe_fan_first(i, 1))));
        out[i].angle = point->theta + point->reach * sum(point, p + lobe_fan_first(i, 0));
        out[i].log_t = log(point->alpha * (0.3 + power));
        out[i].weight = i < taps - 1 ? sum(point, p + lobe_fan_first(i, 2)) : rest;
        rest -= out[i].weight;
        if (growth)
            growth[i] = power / (0.3 + power) * 0.69314718055994531;
    }
}

void lobe_fan_free_taps(const lobe_fan_point *point, const double *p, int taps, lobe_cell_tap *out, double *growth)
{
    lobe_fan_taps(point, p, taps, out, growth);
    out[taps - 1].weight = sum(point, p + lobe_fan_first(taps - 1, 2));
}
