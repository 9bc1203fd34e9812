#define LOBE_DOUBLE 1
#include "table.h"
#include <math.h>
#include "../../models/env_lobes_table.h"
#include "kernels.h"

enum { SIDE = LOBE_ENV_TABLE_SIDE };

/* The root of .3 alpha, the least t of the closed forms (models/env_lobes.h), over the roughness. */
#define NARROWEST 0.55
/* In q30 an angle is below 2. */
#define FARTHEST 1.9

lobe_env_table_point lobe_env_table_point_of(double alpha, double n_dot_v)
{
    const double r = sqrt(alpha);
    const lobe_env_point shared = lobe_env_point_of(r, n_dot_v);
    const lobe_table_uv at = lobe_split_sum_table_texel(r, n_dot_v, SIDE - 1);
    const int row = (int)fmin(at.v, SIDE - 2), column = (int)fmin(at.u, SIDE - 2);
    const lobe_env_table_parts part = lobe_env_table_parts_of(at.v - row, at.u - column);
    const lobe_env_table_point p = {
        alpha, n_dot_v, r, shared.theta, shared.reach, SIDE * row + column, {part.p00, part.p01, part.p10, part.p11}};
    return p;
}

void lobe_env_table_place(double row, double column, double *alpha, double *n_dot_v)
{
    const double x = row / (SIDE - 1), y = column / (SIDE - 1), r = 2 * x / (1.5 + sqrt(2.25 - 2 * x));
    *alpha = r * r;
    *n_dot_v = 0.25 * y / (1.25 - y);
}

int lobe_env_table_numbers(int taps) { return 3 * taps - 1; }

void lobe_env_table_taps(const lobe_env_table_point *point, const double *table, int taps, lobe_cell_tap *out,
                         double *growth)
{
    const int numbers = lobe_env_table_numbers(taps);
    const double *above = table + point->node * numbers, *below = above + SIDE * numbers;
    double z[LOBE_ENV_TABLE_NUMBERS], rest = 1;
    for (int i = 0; i < numbers; i++)
        z[i] = point->part[0] * above[i] + point->part[1] * above[numbers + i] + point->part[2] * below[i] +
               point->part[3] * below[numbers + i];
    for (int i = 0; i < taps; i++) {
        const double width = fmin(LOBE_ENV_TABLE_WIDEST, point->roughness * z[3 * i + 1]), alpha = width * width;
        out[i].angle = point->theta + point->reach * z[3 * i];
        out[i].log_t = log(lobe_prefilter_t_of_alpha(alpha));
        out[i].weight = i < taps - 1 ? z[3 * i + 2] : rest;
        rest -= out[i].weight;
        if (growth)
            growth[i] = width < LOBE_ENV_TABLE_WIDEST ? 2 / (z[3 * i + 1] * (1 - alpha * alpha)) : 0;
    }
}

void lobe_env_table_start(const double *p, int taps, double *table)
{
    const int numbers = lobe_env_table_numbers(taps);
    for (int node = 0; node < LOBE_ENV_TABLE_NODES; node++) {
        double alpha, n_dot_v, *out = table + node * numbers;
        lobe_cell_tap tap[LOBE_CELL_TAPS];
        lobe_fan_point point;
        lobe_env_table_place(node / SIDE, node % SIDE, &alpha, &n_dot_v);
        /* A little inside, where a shift can be had from an angle. */
        point = lobe_fan_point_of(fmax(1e-8, alpha), fmin(1 - 1e-6, n_dot_v));
        lobe_fan_taps(&point, p, taps, tap, NULL);
        for (int i = 0; i < taps; i++) {
            out[3 * i] = (tap[i].angle - point.theta) / point.reach;
            out[3 * i + 1] = sqrt(lobe_prefilter_alpha_of_t(exp(tap[i].log_t)) / point.alpha);
            if (i < taps - 1)
                out[3 * i + 2] = tap[i].weight;
        }
    }
}

double lobe_env_table_unit(int kind) { return kind == 0 ? 0x1p-11 : kind == 1 ? 0x1p-13 : 0x1p-12; }

void lobe_env_table_bounds(int kind, int node, double *least, double *most)
{
    const double unit = lobe_env_table_unit(kind);
    double alpha, n_dot_v, reach;
    lobe_env_table_place(node / SIDE, node % SIDE, &alpha, &n_dot_v);
    reach = fmax(1e-9, alpha * sqrt(1 - n_dot_v * n_dot_v));
    *least = kind == 1 ? NARROWEST : -0x1p15 * unit;
    *most = 0x1p15 * unit - unit;
    if (kind == 0) {
        *least = fmax(*least, (-FARTHEST - acos(n_dot_v)) / reach);
        *most = fmin(*most, (FARTHEST - acos(n_dot_v)) / reach);
    }
    if (kind == 1)
        *most = fmin(*most, LOBE_ENV_TABLE_WIDEST / sqrt(fmax(1e-9, alpha)));
}
