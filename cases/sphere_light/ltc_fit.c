#include "ltc_fit.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../fit/atomic_file.h"
#include "../fit/nelder_mead.h"
#include "../split_sum/truth_split_sum.h"
#include "ltc.h"

/* As the published fit does it: the lobe f and the transformed cosine g are compared at directions drawn from both,
 * the sum of |f - g|^power over the sum of the two densities. Here the draws are the midpoints of a grid, and half the
 * azimuths are left out, since both are even in y. */
enum { RADII = 32, AZIMUTHS = 16, DRAWS = RADII * AZIMUTHS };

/* What is searched: the map [x 0 z][m11 0 m13; 0 m22 0; 0 0 1] with z at an angle from the normal. */
enum { ANGLE, LOG_M11, LOG_M22, M13, PARAMETERS };

static const double pi = 3.14159265358979323846;
static int power_of_fit = 3;

typedef struct lobe {
    double alpha, v[3], albedo;
    double direction[DRAWS][3], f[DRAWS], density[DRAWS]; /* drawn from the visible normals */
    double mean_angle;
} lobe;

/* f = D V l.z, and the density of its draws D G1 / (4 v.z). */
static double lobe_at(const lobe *of, const double l[3], double *density)
{
    const double a2 = of->alpha * of->alpha, vz = of->v[2], root_v = sqrt(a2 + (1 - a2) * vz * vz);
    double h[3], length, d, t, root_l;
    h[0] = of->v[0] + l[0];
    h[1] = of->v[1] + l[1];
    h[2] = of->v[2] + l[2];
    length = h[0] * h[0] + h[1] * h[1] + h[2] * h[2];
    t = (h[0] * h[0] + h[1] * h[1] + a2 * h[2] * h[2]) / length;
    d = h[2] > 0 ? a2 / (pi * t * t) : 0;
    *density = d / (2 * (vz + root_v));
    if (l[2] <= 0)
        return 0;
    root_l = sqrt(a2 + (1 - a2) * l[2] * l[2]);
    return .5 * d * l[2] / (l[2] * root_v + vz * root_l);
}

/* Heitz 2018: a visible normal from a point of the unit disc. */
static void draw(const lobe *of, double radius, double azimuth, double l[3])
{
    const double a = of->alpha, stretch = sqrt(a * a * of->v[0] * of->v[0] + of->v[2] * of->v[2]);
    const double vx = a * of->v[0] / stretch, vz = of->v[2] / stretch, s = .5 * (1 + vz);
    const double y = radius * sin(azimuth), side = sqrt(1 - y * y);
    const double x = (1 - s) * side + s * radius * cos(azimuth); /* radius cos is along the lean of the view */
    const double up = sqrt(fmax(0, 1 - x * x - y * y));
    double h[3], length, vh;
    h[0] = a * (up * vx - x * vz);
    h[1] = a * y;
    h[2] = fmax(1e-9, up * vz + x * vx);
    length = sqrt(h[0] * h[0] + h[1] * h[1] + h[2] * h[2]);
    vh = (h[0] * of->v[0] + h[2] * of->v[2]) / length;
    l[0] = 2 * vh * h[0] / length - of->v[0];
    l[1] = 2 * vh * h[1] / length;
    l[2] = 2 * vh * h[2] / length - of->v[2];
}

static double radius_of(int i) { return sqrt((i + .5) / RADII); }
static double azimuth_of(int j) { return pi * (j + .5) / AZIMUTHS; }

static void lobe_of(lobe *of, double roughness, double n_dot_v)
{
    const double at[2] = {roughness, n_dot_v};
    double both[2], x = 0, z = 0;
    int i, j, k = 0;
    of->alpha = roughness * roughness;
    of->v[0] = sqrt(1 - n_dot_v * n_dot_v);
    of->v[1] = 0;
    of->v[2] = n_dot_v;
    lobe_truth_split_sum_rows(at, both, 1);
    of->albedo = both[0] + both[1];
    for (i = 0; i < RADII; i++) {
        for (j = 0; j < AZIMUTHS; j++, k++) {
            draw(of, radius_of(i), azimuth_of(j), of->direction[k]);
            of->f[k] = lobe_at(of, of->direction[k], &of->density[k]);
            x += of->f[k] / of->density[k] * of->direction[k][0];
            z += of->f[k] / of->density[k] * of->direction[k][2];
        }
    }
    of->mean_angle = atan2(x, z);
}

/* The map by rows, and its inverse. */
typedef struct map {
    double m11, m13, m22, m31, m33, det;
} map;

static map map_of(const double p[PARAMETERS])
{
    const double c = cos(p[ANGLE]), s = sin(p[ANGLE]), m11 = exp(p[LOG_M11]), m13 = p[M13];
    map m;
    /* columns of the frame: (c, 0, -s), y, (s, 0, c) */
    m.m11 = c * m11;
    m.m13 = c * m13 + s;
    m.m31 = -s * m11;
    m.m33 = -s * m13 + c;
    m.m22 = exp(p[LOG_M22]);
    m.det = m11; /* of the map in the plane y = 0 */
    return m;
}

/* The cosine's density in the direction l, after the map. */
static double cosine_at(const map *m, const double l[3])
{
    const double x = (m->m33 * l[0] - m->m13 * l[2]) / m->det, y = l[1] / m->m22;
    const double z = (m->m11 * l[2] - m->m31 * l[0]) / m->det, n = x * x + y * y + z * z;
    return z > 0 ? z / (pi * n * n * fabs(m->det * m->m22)) : 0;
}

static double difference(double f, double g, double weight)
{
    const double d = fabs(f - g);
    return (power_of_fit == 3 ? d * d * d : d * d) / weight;
}

static double error_of(const lobe *of, const map *m)
{
    double sum = 0, g, f, density;
    int i, j, k = 0;
    for (i = 0; i < RADII; i++) {
        for (j = 0; j < AZIMUTHS; j++, k++) {
            const double r = radius_of(i), x = r * cos(azimuth_of(j)), y = r * sin(azimuth_of(j));
            const double z = sqrt(1 - r * r);
            double l[3], length;
            g = cosine_at(m, of->direction[k]);
            sum += difference(of->f[k], of->albedo * g, of->density[k] + g);
            l[0] = m->m11 * x + m->m13 * z;
            l[1] = m->m22 * y;
            l[2] = m->m31 * x + m->m33 * z;
            length = sqrt(l[0] * l[0] + l[1] * l[1] + l[2] * l[2]);
            l[0] /= length;
            l[1] /= length;
            l[2] /= length;
            g = cosine_at(m, l);
            f = lobe_at(of, l, &density);
            if (g > 0)
                sum += difference(f, of->albedo * g, density + g);
        }
    }
    return sum / DRAWS;
}

static void errors(void *context, const double *parameters, size_t count, double *values)
{
    size_t i;
    for (i = 0; i < count; i++) {
        const map m = map_of(parameters + PARAMETERS * i);
        values[i] = error_of(context, &m);
    }
}

/* At normal incidence the lobe is round: one width. */
static void round_errors(void *context, const double *parameters, size_t count, double *values)
{
    size_t i;
    for (i = 0; i < count; i++) {
        double p[PARAMETERS] = {0, 0, 0, 0};
        map m;
        p[LOG_M11] = p[LOG_M22] = parameters[i];
        m = map_of(p);
        values[i] = error_of(context, &m);
    }
}

static lobe_nm_options search_options(void)
{
    lobe_nm_options o = lobe_nm_default();
    o.size = .05;
    o.restarts = 0;
    o.value_tolerance = 1e-5;
    o.size_tolerance = 1e-3; /* finer changes no digit of the judgement */
    o.budget = 1200;
    return o;
}

static void fit_round(const lobe *of, double p[PARAMETERS])
{
    const lobe_objective objective = {.f = round_errors, .ctx = (void *)of, .dim = 1};
    const lobe_nm_options options = search_options();
    double width = p[LOG_M11];
    lobe_nelder_mead(&objective, &options, &width);
    p[ANGLE] = p[M13] = 0;
    p[LOG_M11] = p[LOG_M22] = width;
}

/* From the neighbour's map, and from it with its axis at the lobe's mean direction. */
static void fit_cell(const lobe *of, double p[PARAMETERS])
{
    const lobe_objective objective = {.f = errors, .ctx = (void *)of, .dim = PARAMETERS};
    const lobe_nm_options options = search_options();
    double other[PARAMETERS];
    lobe_fit_result a, b;
    memcpy(other, p, sizeof other);
    other[ANGLE] = of->mean_angle;
    a = lobe_nelder_mead(&objective, &options, p);
    b = lobe_nelder_mead(&objective, &options, other);
    if (b.value < a.value)
        memcpy(p, other, sizeof other);
}

static double roughness_of(int i)
{
    return LOBE_LTC_ROUGHNESS_LO + (1 - LOBE_LTC_ROUGHNESS_LO) * i / (LOBE_LTC_SIDE - 1);
}

/* No lower than the truth's domain. */
static double view_of(int j)
{
    const double x = (double)j / (LOBE_LTC_SIDE - 1);
    return fmax(1 - x * x, .001);
}

static void store(const double p[PARAMETERS], double albedo, double cell[LOBE_LTC_VALUES])
{
    const map m = map_of(p);
    const double scale = m.m22 / m.det; /* the inverse has 1 at its middle */
    cell[LOBE_LTC_INV11] = scale * m.m33;
    cell[LOBE_LTC_INV13] = -scale * m.m13;
    cell[LOBE_LTC_INV31] = -scale * m.m31;
    cell[LOBE_LTC_INV33] = scale * m.m11;
    cell[LOBE_LTC_ALBEDO] = albedo;
}

/* A lobe_sweep_fn: in the roughness and the width at normal incidence, out a row of cells. */
static void fit_row(const double *in, double *out, size_t n)
{
    lobe of; /* 30 kB of stack */
    size_t i;
    int j;
    for (i = 0; i < n; i++, in += 2) {
        double p[PARAMETERS] = {0, in[1], in[1], 0};
        for (j = 0; j < LOBE_LTC_SIDE; j++, out += LOBE_LTC_VALUES) {
            lobe_of(&of, in[0], view_of(j));
            if (j > 0)
                fit_cell(&of, p);
            store(p, of.albedo, out);
        }
    }
}

lobe_ltc_fit_options lobe_ltc_fit_default(void)
{
    lobe_ltc_fit_options o;
    o.power = 3;
    o.sweep = lobe_sweep_options_default();
    o.sweep.label = "cells";
    return o;
}

static bool write_table(const double *cells, const char *path)
{
    lobe_atomic_file file;
    int i;
    if (!lobe_atomic_open(&file, path))
        return false;
    fprintf(
        file.stream,
        "/* Linearly transformed cosines of D V n.l, GGX with height-correlated Smith, alpha = roughness^2, F = 1.\n"
        " * Generated: lobefit search sphere_light --ltc FILE (make ltc); do not edit.\n"
        " * Rows: %d roughnesses from %g to 1, in each %d of sqrt(1 - n.v) from 0 to 1; bilinear between.\n"
        " * Columns: the inverse map [inv11 0 inv13; 0 1 0; inv31 0 inv33], then the albedo.\n"
        " * Fit: least |difference|^%d over the directions (Nelder-Mead, ltc_fit.c); the amplitude is the albedo.\n"
        " * Bytes: %d. */\n"
        "#ifndef LOBE_SPHERE_LIGHT_LTC_TABLE_H\n#define LOBE_SPHERE_LIGHT_LTC_TABLE_H\n#include \"ltc.h\"\n"
        "/* clang-format off */\n"
        "static const float lobe_ltc_table_cells[LOBE_LTC_NUMBERS] = {\n",
        LOBE_LTC_SIDE, LOBE_LTC_ROUGHNESS_LO, LOBE_LTC_SIDE, power_of_fit, 4 * LOBE_LTC_NUMBERS);
    for (i = 0; i < LOBE_LTC_NUMBERS; i += LOBE_LTC_VALUES)
        /* #: always with a point, so that an f can follow */
        fprintf(file.stream, "%#.9gf,%#.9gf,%#.9gf,%#.9gf,%#.9gf,\n", cells[i], cells[i + 1], cells[i + 2],
                cells[i + 3], cells[i + 4]);
    fputs("};\n/* clang-format on */\n#endif\n", file.stream);
    return lobe_atomic_commit(&file);
}

bool lobe_ltc_fit(const lobe_ltc_fit_options *options, const char *path)
{
    double rows[2 * LOBE_LTC_SIDE], p[PARAMETERS] = {0, 0, 0, 0};
    double *cells = malloc(LOBE_LTC_NUMBERS * sizeof *cells);
    lobe *of = malloc(sizeof *of);
    bool good = cells && of;
    int i;
    power_of_fit = options->power;
    if (!good)
        fputs("lobefit: search: not enough memory\n", stderr);
    for (i = LOBE_LTC_SIDE - 1; good && i >= 0; i--) {
        lobe_of(of, roughness_of(i), 1);
        fit_round(of, p);
        rows[2 * i] = roughness_of(i);
        rows[2 * i + 1] = p[LOG_M11];
    }
    if (good) {
        lobe_sweep(fit_row, rows, 2, cells, LOBE_LTC_SIDE * LOBE_LTC_VALUES, LOBE_LTC_SIDE, &options->sweep);
        good = write_table(cells, path);
    }
    free(cells);
    free(of);
    return good;
}
