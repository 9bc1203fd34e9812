#include "measure.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "random.h"
#include "truth_cache.h"

typedef double called(const double *row);

static double error_at(called *call, lobe_truth_fn fn, const double *row)
{
    double truth;
    fn(row, &truth, 1);
    return fabs(call(row) - truth);
}

static bool counts(const lobe_quantity *q, const double *row)
{
    double radiance = q->least;
    if (q->least > 0)
        q->lit->truth(row, &radiance, 1);
    return radiance >= q->least;
}

/* Uphill, along the axes and in random directions, in steps that shrink where none gains: the rows may have missed the
 * top, and it is often on a ridge. */
static void climb(called *call, const lobe_region *r, double *row, double *error)
{
    const lobe_quantity *q = r->quantity;
    const int columns = q->judged.input_count;
    lobe_random random;
    double step = .02;
    int way, k, halvings = 0;
    lobe_random_seed(&random, 11, 0);
    while (halvings < q->halvings) {
        bool gained = false;
        for (way = 0; way < q->ways; way++) {
            double direction[LOBE_CASE_COLUMNS] = {0}, next[LOBE_CASE_COLUMNS], e;
            for (k = 0; way >= 2 * columns && k < columns; k++)
                direction[k] = 2 * lobe_random_unit(&random) - 1;
            if (way < 2 * columns)
                direction[way / 2] = way & 1 ? 1 : -1;
            if (!q->step(row, direction, step, r->beyond, next) || !counts(q, next))
                continue;
            e = error_at(call, q->judged.truth, next);
            if (e > *error * (1 + q->gain)) {
                *error = e;
                memcpy(row, next, sizeof *row * (size_t)columns);
                gained = true;
            }
        }
        if (!gained) {
            step *= .5;
            halvings++;
        }
    }
}

lobe_measured lobe_measure(called *call, const lobe_region *r)
{
    const lobe_quantity *q = r->quantity;
    const size_t columns = (size_t)q->judged.input_count;
    lobe_measured m = {0};
    double top[LOBE_MEASURE_STARTS] = {0}, squares = 0;
    size_t where[LOBE_MEASURE_STARTS] = {0}, i;
    int k, least;
    for (i = 0; i < r->count; i++) {
        const double e = fabs(call(r->rows + columns * i) - r->truth[i]);
        if (i < r->judged)
            squares += e * e;
        for (least = 0, k = 1; k < q->starts; k++)
            least = top[k] < top[least] ? k : least;
        if (e > top[least]) {
            top[least] = e;
            where[least] = i;
        }
    }
    m.rms = sqrt(squares / (double)r->judged);
    for (k = 0; k < q->starts; k++) {
        double row[LOBE_CASE_COLUMNS];
        memcpy(row, r->rows + columns * where[k], columns * sizeof *row);
        if (!r->beyond || !q->still)
            climb(call, r, row, &top[k]);
        if (q->truth)
            top[k] = error_at(call, q->truth, row);
        if (top[k] > m.max) {
            m.max = top[k];
            memcpy(m.at, row, columns * sizeof *row);
        }
    }
    return m;
}

/* The rows whose light gives enough, in their order; 0 where there is no memory. */
static size_t kept(const lobe_quantity *q, double *rows, size_t count, const lobe_sweep_options *options)
{
    const size_t columns = (size_t)q->judged.input_count;
    double *radiance;
    size_t i, n = 0;
    if (!(q->least > 0))
        return count;
    radiance = malloc(count * sizeof *radiance);
    if (radiance)
        lobe_truth_cached(q->lit, rows, radiance, count, options);
    for (i = 0; radiance && i < count; i++)
        if (radiance[i] >= q->least)
            memmove(rows + columns * n++, rows + columns * i, columns * sizeof *rows);
    free(radiance);
    return n;
}

static bool make(lobe_region *r, bool beyond, const lobe_quantity *q, const lobe_sweep_options *options)
{
    const lobe_vector_set *set = q->vectors;
    const size_t columns = (size_t)q->judged.input_count, hypercube = q->rows[beyond];
    r->quantity = q;
    r->beyond = beyond;
    r->rows = malloc(columns * (hypercube + set->rows) * sizeof *r->rows);
    r->truth = malloc((hypercube + set->rows) * sizeof *r->truth);
    if (!r->rows || !r->truth) {
        fputs("lobefit: bounds: not enough memory\n", stderr);
        return false;
    }
    q->hypercube(beyond, r->rows, hypercube);
    r->judged = kept(q, r->rows, hypercube, options);
    r->count = r->judged + set->points(0, beyond, set->seed, r->rows + columns * r->judged, set->rows);
    lobe_truth_cached(&q->judged, r->rows, r->truth, r->count, options);
    return true;
}

bool lobe_regions_make(lobe_region regions[2], const lobe_quantity *quantity, const lobe_sweep_options *options)
{
    regions[0].rows = regions[0].truth = regions[1].rows = regions[1].truth = NULL;
    return make(&regions[0], false, quantity, options) && make(&regions[1], true, quantity, options);
}

void lobe_regions_free(lobe_region regions[2])
{
    int i;
    for (i = 0; i < 2; i++) {
        free(regions[i].rows);
        free(regions[i].truth);
        regions[i].rows = regions[i].truth = NULL;
    }
}
