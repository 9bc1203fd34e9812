#include "orientations.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../fit/parallel.h"
#include "../fit/random.h"
#include "kernels.h"
#include "spline.h"

enum { ANGLES = LOBE_ORIENTATION_ANGLES, WIDTHS = LOBE_ORIENTATION_WIDTHS, TOGETHER = LOBE_HARMONICS_TOGETHER };

static const double angle_step = (LOBE_ORIENTATION_ANGLE_HI - LOBE_ORIENTATION_ANGLE_LO) / (ANGLES - 1);

typedef struct job {
    lobe_orientations *o;
    lobe_harmonics *harmonics; /* of each environment */
    int each;
    double (*factor)[LOBE_ENV_BANDS]; /* of each width */
} job;

/* A turn drawn uniformly: the normal, the direction in the plane, their cross product. */
static void draw_axes(lobe_random *r, double axes[9])
{
    double *n = axes, *b = axes + 3, *c = axes + 6, along = 0, length;
    for (int i = 0; i < 2; i++) {
        const double z = 2 * lobe_random_unit(r) - 1, turn = 2 * LOBE_PI * lobe_random_unit(r), sine = sqrt(1 - z * z);
        axes[3 * i] = sine * cos(turn);
        axes[3 * i + 1] = sine * sin(turn);
        axes[3 * i + 2] = z;
    }
    for (int k = 0; k < 3; k++)
        along += n[k] * b[k];
    for (int k = 0; k < 3; k++)
        b[k] -= along * n[k];
    length = sqrt(b[0] * b[0] + b[1] * b[1] + b[2] * b[2]);
    for (int k = 0; k < 3; k++)
        b[k] /= length;
    for (int k = 0; k < 3; k++)
        c[k] = n[(k + 1) % 3] * b[(k + 2) % 3] - n[(k + 2) % 3] * b[(k + 1) % 3];
}

/* Columns of the table, 8 angles of one sample at a time: entry = sample * groups + group. */
static void fill_taps(void *ctx, const double *params, size_t count, double *values)
{
    const job *j = ctx;
    const int groups = ANGLES / TOGETHER;
    static _Thread_local double bands[LOBE_ENV_BANDS][TOGETHER];
    for (size_t p = 0; p < count; p++) {
        const int entry = (int)params[p], sample = entry / groups, first = entry % groups * TOGETHER;
        const double *axes = j->o->axes[sample];
        double d[TOGETHER][3];
        for (int i = 0; i < TOGETHER; i++) {
            const double angle = LOBE_ORIENTATION_ANGLE_LO + angle_step * (first + i);
            for (int k = 0; k < 3; k++)
                d[i][k] = cos(angle) * axes[k] + sin(angle) * axes[3 + k];
        }
        lobe_harmonics_bands_at(&j->harmonics[sample / j->each], d, bands);
        for (int w = 0; w < WIDTHS; w++) {
            double sum[TOGETHER] = {0};
            for (int l = 0; l < LOBE_ENV_BANDS; l++)
                for (int i = 0; i < TOGETHER; i++)
                    sum[i] += j->factor[w][l] * bands[l][i];
            for (int i = 0; i < TOGETHER; i++)
                j->o->tap[((size_t)(1 + first + i) * (WIDTHS + 2) + (size_t)(1 + w)) * (size_t)j->o->count +
                          (size_t)sample] = (float)sum[i];
        }
        values[p] = 1;
    }
}

/* Values to spline coefficients, in both variables. */
static void make_splines(lobe_orientations *o)
{
    double line[ANGLES + 2];
    const size_t n = (size_t)o->count, row = n * (WIDTHS + 2);
    for (size_t s = 0; s < n; s++) {
        for (int a = 0; a < ANGLES; a++) {
            float *at = o->tap + (size_t)(1 + a) * row + s;
            for (int w = 0; w < WIDTHS; w++)
                line[1 + w] = (double)at[(size_t)(1 + w) * n];
            lobe_spline_prepare(line, WIDTHS, 1, 0);
            for (int w = 0; w < WIDTHS + 2; w++)
                at[(size_t)w * n] = (float)line[w];
        }
        for (int w = 0; w < WIDTHS + 2; w++) {
            float *at = o->tap + (size_t)w * n + s;
            for (int a = 0; a < ANGLES; a++)
                line[1 + a] = (double)at[(size_t)(1 + a) * row];
            lobe_spline_prepare(line, ANGLES, 1, 0);
            for (int a = 0; a < ANGLES + 2; a++)
                at[(size_t)a * row] = (float)line[a];
        }
    }
}

static void fill_cubes(void *ctx, const double *params, size_t count, double *values)
{
    const job *j = ctx;
    for (size_t p = 0; p < count; p++) {
        const int e = (int)params[p];
        values[p] = lobe_blurred_cubes_of(&j->harmonics[e], &j->o->cubes[e]);
    }
}

static bool run(job *j, lobe_batch_fn f, int entries, int threads)
{
    lobe_parallel parallel = {f, j, 1, 1, (size_t)threads};
    bool good = true;
    double *in = calloc(2 * (size_t)entries, sizeof *in);
    if (!in)
        return false;
    for (int i = 0; i < entries; i++)
        in[i] = i;
    lobe_parallel_eval(&parallel, in, (size_t)entries, in + entries);
    for (int i = 0; i < entries; i++)
        good = good && in[entries + i] != 0;
    free(in);
    return good;
}

static bool prepare(job *j, const lobe_environment *maps)
{
    double blur[LOBE_ENV_BANDS];
    for (int l = 0; l < LOBE_ENV_BANDS; l++)
        blur[l] = exp(-0.5 * LOBE_BLUR_FINEST * LOBE_BLUR_FINEST * l * (l + 1));
    for (int i = 0; i < j->o->environments; i++) {
        if (!lobe_harmonics_of(&maps[i], -1, &j->harmonics[i]))
            return false;
        lobe_harmonics_scale(&j->harmonics[i], blur);
    }
    for (int w = 0; w < WIDTHS; w++)
        lobe_prefilter_bands(LOBE_ORIENTATION_T_LO *
                                 pow(LOBE_ORIENTATION_T_HI / LOBE_ORIENTATION_T_LO, w / (WIDTHS - 1.0)),
                             LOBE_ENV_BANDS, j->factor[w]);
    return true;
}

lobe_orientations *lobe_orientations_new(const lobe_environment *maps, int map_count, int each, unsigned seed,
                                         int threads)
{
    const size_t count = (size_t)map_count * (size_t)each;
    lobe_orientations *o = calloc(1, sizeof *o);
    job j = {o, calloc((size_t)map_count, sizeof *j.harmonics), each, malloc(WIDTHS * sizeof *j.factor)};
    lobe_random r;
    bool good = o && j.harmonics && j.factor;
    if (good) {
        o->count = (int)count;
        o->environments = map_count;
        o->axes = malloc(count * sizeof *o->axes);
        o->cubes = calloc((size_t)map_count, sizeof *o->cubes);
        o->tap = malloc(sizeof *o->tap * count * (ANGLES + 2) * (WIDTHS + 2));
        good = o->axes && o->cubes && o->tap && prepare(&j, maps);
    }
    if (good) {
        lobe_random_seed(&r, seed, 55);
        for (size_t i = 0; i < count; i++)
            draw_axes(&r, o->axes[i]);
        good = run(&j, fill_taps, (int)count * (ANGLES / TOGETHER), threads) && run(&j, fill_cubes, map_count, threads);
    }
    if (good)
        make_splines(o);
    for (int i = 0; j.harmonics && i < map_count; i++)
        lobe_harmonics_free(&j.harmonics[i]);
    free(j.harmonics);
    free(j.factor);
    if (good)
        return o;
    lobe_orientations_free(o);
    return NULL;
}

void lobe_orientations_free(lobe_orientations *o)
{
    for (int i = 0; o && o->cubes && i < o->environments; i++)
        lobe_blurred_cubes_free(&o->cubes[i]);
    if (o) {
        free(o->cubes);
        free(o->axes);
        free(o->tap);
    }
    free(o);
}

void lobe_orientations_integrate(const lobe_orientations *o, const double *nodes, int count, double *out)
{
    const int each = o->count / o->environments;
    for (int s = 0; s < o->count; s++) {
        const double *n = o->axes[s], *b = n + 3, *c = n + 6;
        const lobe_blurred_cubes *cubes = &o->cubes[s / each];
        double sum = 0;
        for (int i = 0; i < count; i++) {
            const double *q = nodes + 5 * i;
            double p[3], m[3];
            /* the view is on the side of +x, so b, which the mirror direction leans to, is -x */
            for (int k = 0; k < 3; k++) {
                const double middle = q[2] * n[k] - q[0] * b[k], across = q[1] * c[k];
                p[k] = middle + across;
                m[k] = middle - across;
            }
            sum += 0.5 * q[3] * (lobe_blurred_cubes_at(cubes, p, q[4]) + lobe_blurred_cubes_at(cubes, m, q[4]));
        }
        out[s] = sum;
    }
}

void lobe_orientations_tap(const lobe_orientations *o, double angle, double t, double *out, double *by_angle,
                           double *by_log_t)
{
    const double scale = (WIDTHS - 1) / log(LOBE_ORIENTATION_T_HI / LOBE_ORIENTATION_T_LO);
    const lobe_spline_weights a = lobe_spline_at(ANGLES, (angle - LOBE_ORIENTATION_ANGLE_LO) / angle_step);
    const lobe_spline_weights w = lobe_spline_at(WIDTHS, log(t / LOBE_ORIENTATION_T_LO) * scale);
    const size_t n = (size_t)o->count;
    memset(out, 0, sizeof *out * n);
    if (by_angle) {
        memset(by_angle, 0, sizeof *by_angle * n);
        memset(by_log_t, 0, sizeof *by_log_t * n);
    }
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            const float *at = o->tap + ((size_t)(a.first + i) * (WIDTHS + 2) + (size_t)(w.first + j)) * n;
            const double value = a.value[i] * w.value[j], slope = a.slope[i] * w.value[j] / angle_step,
                         wider = a.value[i] * w.slope[j] * scale;
            for (size_t s = 0; s < n; s++)
                out[s] += value * (double)at[s];
            for (size_t s = 0; by_angle && s < n; s++) {
                by_angle[s] += slope * (double)at[s];
                by_log_t[s] += wider * (double)at[s];
            }
        }
}
