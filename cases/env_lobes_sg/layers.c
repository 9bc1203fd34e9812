#define LOBE_DOUBLE 1
#define LOBE_FIT 1
#include "layers.h"
#include <math.h>
#include <string.h>
#include "../../models/env_lobes_sg.h"

int lobe_sg_quantities(int count) { return count == 1 ? 2 : count == 2 ? 5 : 8; }

void lobe_sg_features(double alpha, double n_dot_v, double *features)
{
    const lobe_env_point p = lobe_env_point_of(sqrt(alpha), n_dot_v);
    const double f[LOBE_SG_FEATURES] = {1, p.f1, p.f2, p.f3, p.f4, p.f5, p.f6, p.f7, p.f8, p.f9, p.f10, p.f11};
    memcpy(features, f, sizeof f);
}

void lobe_sg_lobes_of(double alpha, double n_dot_v, const double *quantity, int count, double energy, lobe_sg *lobes)
{
    const lobe_env_point p = lobe_env_point_of(sqrt(alpha), n_dot_v);
    double q[LOBE_SG_QUANTITIES] = {0}, sum = 0;
    lobe_env_sg_fan fan;
    int i;
    memcpy(q, quantity, sizeof *q * (size_t)lobe_sg_quantities(count));
    fan = lobe_env_sg_fan_of(p, q[LOBE_SG_SHIFT], q[LOBE_SG_LEVEL], q[LOBE_SG_SPREAD], q[LOBE_SG_TILT], q[LOBE_SG_LEAN],
                             q[LOBE_SG_RIM], q[LOBE_SG_TAPER], q[LOBE_SG_FLARE]);
    for (i = 0; i < count; i++) {
        const double d = count > 1 ? (2.0 * i - (count - 1)) / (count - 1) : 0;
        const lobe_env_tap tap = lobe_env_sg_tap_of(fan, p.a, d);
        lobes[i].angle = tap.angle;
        lobes[i].sharpness = tap.width;
        lobes[i].weight = tap.weight;
        sum += tap.weight;
    }
    for (i = 0; i < count; i++)
        lobes[i].weight = energy * (lobes[i].weight * (1 + count * fan.rim) / sum - fan.rim);
}

void lobe_sg_lobes_at(double alpha, double n_dot_v, const double *c, int count, double energy, lobe_sg *lobes)
{
    double features[LOBE_SG_FEATURES], q[LOBE_SG_QUANTITIES];
    int i, k;
    lobe_sg_features(alpha, n_dot_v, features);
    for (k = 0; k < lobe_sg_quantities(count); k++) {
        q[k] = 0;
        for (i = 0; i < LOBE_SG_FEATURES; i++)
            q[k] += c[k * LOBE_SG_FEATURES + i] * features[i];
    }
    lobe_sg_lobes_of(alpha, n_dot_v, q, count, energy, lobes);
}
