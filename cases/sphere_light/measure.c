#include "measure.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../fit/random.h"
#include "../fit/truth_cache.h"
#include "columns.h"
#include "points.h"
#include "tiers.h"

const lobe_sphere_quantity lobe_sphere_radiance = {.judged = {.name = "sphere_light_judged",
                                                              .input_count = 5,
                                                              .output_count = 1,
                                                              .truth = lobe_truth_sphere_columns_fast},
                                                   .truth = lobe_truth_sphere_columns,
                                                   .vectors = &lobe_sphere_vectors};

enum { STARTS = LOBE_SPHERE_STARTS, HALVINGS = 12, WAYS = 24 };

static const double edge = 3e-8; /* half a unit of the rows, so that an edge rounds into the domain */

typedef double called(const double row[5]);

static double error_at(called *call, lobe_truth_fn fn, const double row[5])
{
    double truth;
    fn(row, &truth, 1);
    return fabs(call(row) - truth);
}

static bool counts(const lobe_sphere_quantity *quantity, const double row[5])
{
    double radiance = 1;
    if (quantity->least > 0)
        lobe_truth_sphere_columns_fast(row, &radiance, 1);
    return radiance >= quantity->least;
}

/* From a row along a direction of roughness, view, light, azimuth, sine. A step over the domain's edge ends on it.
 * false: that is no light, or not of this region. */
static bool step_from(const double row[5], const double direction[5], double step, bool beyond, double next[5])
{
    double at[5] = {row[0], row[1], row[2], lobe_sphere_azimuth(row), row[4]};
    int k;
    for (k = 0; k < 5; k++)
        at[k] += step * direction[k];
    at[0] = fmax(at[0], beyond ? LOBE_SPHERE_ROUGHNESS_LEAST : LOBE_SPHERE_ROUGHNESS_LO);
    at[1] = fmax(at[1], beyond ? LOBE_SPHERE_N_DOT_V_LEAST : LOBE_SPHERE_N_DOT_V_LO);
    at[4] = fmin(fmax(at[4], LOBE_SPHERE_SINE_LEAST), beyond ? 1 : LOBE_SPHERE_SINE_HI);
    if (!lobe_sphere_place(next, at[0] + edge, at[1] + edge, at[2], at[3], beyond ? at[4] : at[4] - edge))
        return false;
    return lobe_sphere_inside(next) == !beyond && lobe_sphere_taken(next);
}

/* Uphill, along the axes and in random directions, in steps that shrink where none gains: the rows may have missed the
 * top, and it is often on a ridge. */
static void climb(called *call, const lobe_sphere_region *r, double row[5], double *error)
{
    lobe_random random;
    double step = .02;
    int way, k, halvings = 0;
    lobe_random_seed(&random, 11, 0);
    while (halvings < HALVINGS) {
        bool gained = false;
        for (way = 0; way < WAYS; way++) {
            double direction[5] = {0, 0, 0, 0, 0}, next[5], e;
            for (k = 0; way >= 10 && k < 5; k++)
                direction[k] = 2 * lobe_random_unit(&random) - 1;
            if (way < 10)
                direction[way / 2] = way & 1 ? 1 : -1;
            if (!step_from(row, direction, step, r->beyond, next) || !counts(r->quantity, next))
                continue;
            e = error_at(call, r->quantity->judged.truth, next);
            if (e > *error * (1 + r->quantity->gain)) {
                *error = e;
                memcpy(row, next, sizeof next);
                gained = true;
            }
        }
        if (!gained) {
            step *= .5;
            halvings++;
        }
    }
}

lobe_sphere_measured lobe_sphere_measure(called *call, const lobe_sphere_region *r)
{
    lobe_sphere_measured m = {0};
    double top[STARTS] = {0}, squares = 0;
    size_t where[STARTS] = {0}, i;
    int k, least;
    for (i = 0; i < r->count; i++) {
        const double e = fabs(call(r->rows + 5 * i) - r->truth[i]);
        if (i < r->judged)
            squares += e * e;
        for (least = 0, k = 1; k < STARTS; k++)
            least = top[k] < top[least] ? k : least;
        if (e > top[least]) {
            top[least] = e;
            where[least] = i;
        }
    }
    m.rms = sqrt(squares / (double)r->judged);
    for (k = 0; k < STARTS; k++) {
        double row[5];
        memcpy(row, r->rows + 5 * where[k], sizeof row);
        climb(call, r, row, &top[k]);
        top[k] = error_at(call, r->quantity->truth, row);
        if (top[k] > m.max) {
            m.max = top[k];
            memcpy(m.at, row, sizeof row);
        }
    }
    return m;
}

/* The rows whose light gives enough, in their order; 0 where there is no memory. */
static size_t kept(const lobe_sphere_quantity *quantity, double *rows, size_t count, const lobe_sweep_options *options)
{
    static const lobe_case lit = {
        .name = "sphere_light_lit", .input_count = 5, .output_count = 1, .truth = lobe_truth_sphere_columns_fast};
    double *radiance = malloc(count * sizeof *radiance);
    size_t i, n = 0;
    if (!(quantity->least > 0)) {
        free(radiance);
        return count;
    }
    if (radiance)
        lobe_truth_cached(&lit, rows, radiance, count, options);
    for (i = 0; radiance && i < count; i++)
        if (radiance[i] >= quantity->least)
            memmove(rows + 5 * n++, rows + 5 * i, 5 * sizeof *rows);
    free(radiance);
    return n;
}

bool lobe_sphere_region_make(lobe_sphere_region *r, bool beyond, const lobe_sphere_quantity *quantity,
                             const lobe_sweep_options *options)
{
    const lobe_vector_set *set = quantity->vectors;
    const size_t hypercube = beyond ? LOBE_SPHERE_JUDGED / 2 : LOBE_SPHERE_JUDGED;
    r->quantity = quantity;
    r->beyond = beyond;
    r->rows = malloc(5 * (hypercube + set->rows) * sizeof *r->rows);
    r->truth = malloc((hypercube + set->rows) * sizeof *r->truth);
    if (!r->rows || !r->truth) {
        fputs("lobefit: bounds: not enough memory\n", stderr);
        return false;
    }
    lobe_sphere_judged(beyond, r->rows, hypercube);
    r->judged = kept(quantity, r->rows, hypercube, options);
    r->count = r->judged + set->points(0, beyond, set->seed, r->rows + 5 * r->judged, set->rows);
    lobe_truth_cached(&quantity->judged, r->rows, r->truth, r->count, options);
    return true;
}

void lobe_sphere_region_free(lobe_sphere_region *r)
{
    free(r->rows);
    free(r->truth);
    r->rows = r->truth = NULL;
}

double lobe_sphere_rounded_up(double x)
{
    char text[40];
    double unit;
    if (!(x > 0))
        return 0;
    unit = pow(10, floor(log10(x)) - 2);
    snprintf(text, sizeof text, "%.2e", ceil(x / unit * (1 - 1e-12)) * unit);
    return atof(text);
}
