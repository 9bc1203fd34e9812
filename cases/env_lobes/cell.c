#include "cell.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../fit/random.h"
#include "kernels.h"
#include "visible_normals.h"

enum { CANDIDATES = 360, ROWS = LOBE_CELL_ROWS };

struct lobe_cell {
    double alpha, n_dot_v;
    const lobe_cell_options *options;
    lobe_sphere_norm *norm;
    int samples, all; /* values: samples, then those of the norm */
    double *plain;    /* of the response */
    double *bottom;   /* what a sample is divided by */
    double *scale;    /* what every value is multiplied with */
    double *target;   /* plain, scaled */
    double *basis;    /* ROWS of as many, orthonormal */
};

static double dot(const double *a, const double *b, int n)
{
    double part[4] = {0};
    int i = 0;
    for (; i + 4 <= n; i += 4)
        for (int k = 0; k < 4; k++)
            part[k] += a[i + k] * b[i + k];
    for (; i < n; i++)
        part[0] += a[i] * b[i];
    return (part[0] + part[1]) + (part[2] + part[3]);
}

/* One tap of weight 1. */
static void spread(const lobe_cell *c, double angle, double log_t, double *out, double *by_angle, double *by_log_t)
{
    const double t = exp(log_t);
    if (c->samples)
        lobe_orientations_tap(c->options->orientations, angle, t, out, by_angle, by_log_t);
    lobe_sphere_norm_tap(c->norm, angle, t, out + c->samples, by_angle ? by_angle + c->samples : NULL,
                         by_log_t ? by_log_t + c->samples : NULL);
    for (int i = 0; i < c->all; i++)
        out[i] *= c->scale[i];
    for (int i = 0; by_angle && i < c->all; i++) {
        by_angle[i] *= c->scale[i];
        by_log_t[i] *= c->scale[i];
    }
}

/* Radiance in every sample; of a node its solid angle becomes the level that it looks at. */
static void integrate(const lobe_cell *c, double *nodes, int count, double *out)
{
    for (int i = 0; i < count; i++)
        nodes[5 * i + 4] = lobe_blurred_cubes_level(nodes[5 * i + 4]);
    lobe_orientations_integrate(c->options->orientations, nodes, count, out);
}

/* The response in every sample, over its albedo; then what is dark is divided by a part of the mean. */
static void prepare_samples(lobe_cell *c, double *nodes)
{
    const lobe_orientations *o = c->options->orientations;
    const int count = lobe_visible_nodes(c->alpha, c->n_dot_v, c->options->order, nodes),
              each = o->count / o->environments;
    double albedo = 0;
    for (int i = 0; i < count; i++)
        albedo += nodes[5 * i + 3];
    for (int i = 0; i < count; i++)
        nodes[5 * i + 3] /= albedo;
    integrate(c, nodes, count, c->plain);
    for (int e = 0; e < o->environments; e++) {
        double mean = 0;
        for (int i = e * each; i < (e + 1) * each; i++)
            mean += c->plain[i] / each;
        for (int i = e * each; i < (e + 1) * each; i++)
            c->bottom[i] = fmax(c->plain[i], c->options->dark * mean);
    }
}

static void weigh(lobe_cell *c)
{
    for (int i = 0; i < c->all; i++) {
        const int at = i - c->samples;
        if (at < 0)
            c->scale[i] = sqrt(c->options->share[LOBE_CELL_SAMPLES] / c->samples) / c->bottom[i];
        else
            c->scale[i] = sqrt(c->options->share[at < LOBE_SPHERE_POINTS ? LOBE_CELL_SPECTRA : LOBE_CELL_SHAPE]);
        c->target[i] = c->plain[i] * c->scale[i];
    }
}

/* The response and what taps span, the largest remainder first (pivoted Gram-Schmidt). v: CANDIDATES vectors. */
static void make_basis(lobe_cell *c, double *v)
{
    const double mirror = acos(c->n_dot_v), middle = log(lobe_prefilter_t_of_alpha(fmin(0.9, c->alpha)));
    const int n = c->all;
    lobe_random r;
    lobe_random_seed(&r, 77, 0);
    memcpy(v, c->target, sizeof *v * (size_t)n);
    for (int i = 1; i < CANDIDATES; i++) {
        const double shift = (lobe_random_unit(&r) - 0.5) * (lobe_random_unit(&r) < 0.5 ? 1 : 0.3);
        spread(c, mirror + fmin(3, 6 * c->alpha) * shift, middle + 3.6 * lobe_random_unit(&r) - 1.9, v + i * n, NULL,
               NULL);
    }
    for (int b = 0; b < ROWS; b++) {
        double most = -1, norm, *to = c->basis + b * n;
        int best = 0;
        for (int i = 0; i < (b ? CANDIDATES : 1); i++) {
            const double square = dot(v + i * n, v + i * n, n);
            if (square > most) {
                most = square;
                best = i;
            }
        }
        norm = 1 / sqrt(fmax(most, 1e-300));
        for (int j = 0; j < n; j++)
            to[j] = v[best * n + j] * norm;
        for (int i = 0; i < CANDIDATES; i++) {
            const double part = dot(v + i * n, to, n);
            for (int j = 0; j < n; j++)
                v[i * n + j] -= part * to[j];
        }
    }
}

lobe_cell *lobe_cell_new(double alpha, double n_dot_v, const lobe_cell_options *options)
{
    lobe_cell *c = calloc(1, sizeof *c);
    const size_t samples = options->orientations ? (size_t)options->orientations->count : 0,
                 all = samples + LOBE_SPHERE_VALUES;
    double *room = malloc(sizeof *room * (5 * (size_t)options->order * (size_t)options->order + all * CANDIDATES));
    if (c) {
        c->alpha = alpha;
        c->n_dot_v = n_dot_v;
        c->options = options;
        c->samples = (int)samples;
        c->all = (int)all;
        c->plain = malloc(sizeof(double) * all * (4 + ROWS));
        c->norm = lobe_sphere_norm_new(alpha, n_dot_v, options->kernels, options->spectra, options->spectrum_count);
    }
    if (!c || !room || !c->plain || !c->norm) {
        free(room);
        lobe_cell_free(c);
        return NULL;
    }
    c->bottom = c->plain + all;
    c->scale = c->bottom + all;
    c->target = c->scale + all;
    c->basis = c->target + all;
    if (samples)
        prepare_samples(c, room);
    memcpy(c->plain + c->samples, lobe_sphere_norm_target(c->norm), sizeof(double) * LOBE_SPHERE_VALUES);
    weigh(c);
    if (!options->judge)
        make_basis(c, room);
    free(room);
    return c;
}

bool lobe_cell_weigh(lobe_cell *cell, const lobe_cell_options *options)
{
    double *room = malloc(sizeof *room * (size_t)cell->all * CANDIDATES);
    if (!room)
        return false;
    cell->options = options;
    weigh(cell);
    make_basis(cell, room);
    free(room);
    return true;
}

void lobe_cell_free(lobe_cell *cell)
{
    if (cell) {
        free(cell->plain);
        lobe_sphere_norm_free(cell->norm);
    }
    free(cell);
}

size_t lobe_cell_scratch(const lobe_cell *cell) { return 4 * (size_t)cell->all; }

void lobe_cell_residuals(const lobe_cell *cell, const lobe_cell_tap *taps, int count, double *scratch, double *rows,
                         double *slopes)
{
    const int n = cell->all;
    double *rest = scratch, *value = rest + n, *by_angle = value + n, *by_log_t = by_angle + n;
    memcpy(rest, cell->target, sizeof *rest * (size_t)n);
    for (int i = 0; i < count; i++) {
        spread(cell, taps[i].angle, taps[i].log_t, value, slopes ? by_angle : NULL, slopes ? by_log_t : NULL);
        for (int j = 0; j < n; j++)
            rest[j] -= taps[i].weight * value[j];
        for (int b = 0; slopes && b < ROWS; b++) {
            const double *basis = cell->basis + b * n;
            slopes[(3 * i + 0) * ROWS + b] = -taps[i].weight * dot(by_angle, basis, n);
            slopes[(3 * i + 1) * ROWS + b] = -taps[i].weight * dot(by_log_t, basis, n);
            slopes[(3 * i + 2) * ROWS + b] = -dot(value, basis, n);
        }
    }
    for (int b = 0; b < ROWS; b++)
        rows[b] = dot(rest, cell->basis + b * n, n);
}

void lobe_cell_errors(const lobe_cell *cell, const lobe_cell_tap *taps, int count, double *scratch,
                      double error[LOBE_CELL_PARTS])
{
    const int n = cell->all;
    double *rest = scratch, *value = rest + n;
    memcpy(rest, cell->target, sizeof *rest * (size_t)n);
    for (int i = 0; i < count; i++) {
        spread(cell, taps[i].angle, taps[i].log_t, value, NULL, NULL);
        for (int j = 0; j < n; j++)
            rest[j] -= taps[i].weight * value[j];
    }
    for (int k = 0; k < LOBE_CELL_PARTS; k++) {
        const int first = k == 0 ? 0 : cell->samples + (k - 1) * LOBE_SPHERE_POINTS;
        const int end = k == 0 ? cell->samples : first + LOBE_SPHERE_POINTS;
        error[k] = dot(rest + first, rest + first, end - first) / cell->options->share[k];
    }
}

/* Of `count` values from `first` on. */
static double node_error(const lobe_cell *cell, int first, int count, double *value, lobe_cell_part part)
{
    for (int i = 0; i < count; i++)
        value[i] = cell->target[first + i] - cell->scale[first + i] * value[i];
    return dot(value, value, count) / cell->options->share[part];
}

double lobe_cell_samples_error(const lobe_cell *cell, double *nodes, int count, double *scratch)
{
    integrate(cell, nodes, count, scratch);
    return node_error(cell, 0, cell->samples, scratch, LOBE_CELL_SAMPLES);
}

double lobe_cell_spectra_error(const lobe_cell *cell, const double *nodes, int count, double *scratch)
{
    lobe_sphere_norm_nodes(cell->norm, nodes, count, scratch);
    return node_error(cell, cell->samples, LOBE_SPHERE_POINTS, scratch, LOBE_CELL_SPECTRA);
}
