#include "bounds.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../fit/atomic_file.h"
#include "../fit/coefficients.h"
#include "../fit/fit_command.h"
#include "../fit/interrupt.h"
#include "../fit/random.h"
#include "../fit/truth_cache.h"
#include "columns.h"
#include "../sphere_light/columns.h"
#include "held.h"
#include "operations.h"
#include "points.h"
#include "shipped.h"
#include "tiers.h"

enum { STARTS = 2, HALVINGS = 10, WAYS = 18 };

static const double edge = 3e-8; /* half a unit of the rows, so that an edge rounds into the domain */

/* One side of the domain's edge: rows, and what is true there. */
typedef struct region {
    double *rows, *truth;
    size_t judged, count; /* of the hypercube; with the vectors */
    bool beyond;
} region;

typedef struct measured {
    double max, at[5], rms;
} measured;

static double error_at(const lobe_sg_shipped *s, lobe_truth_fn fn, const double row[5])
{
    double truth;
    fn(row, &truth, 1);
    return fabs(s->call(row) - truth);
}

/* From a row along a direction of roughness, view, axis, azimuth, versine. A step over the domain's edge ends on it.
 * false: that is no light, or not of this region. */
static bool step_from(const double row[5], const double direction[5], double step, bool beyond, double next[5])
{
    double at[5] = {row[0], row[1], row[2], lobe_sphere_azimuth(row), row[4]};
    int k;
    for (k = 0; k < 5; k++)
        at[k] += step * direction[k];
    at[0] = fmax(at[0], beyond ? LOBE_SG_ROUGHNESS_LEAST : LOBE_SG_ROUGHNESS_LO);
    at[1] = fmax(at[1], beyond ? LOBE_SG_N_DOT_V_LEAST : LOBE_SG_N_DOT_V_LO);
    at[4] = fmin(fmax(at[4], beyond ? LOBE_SG_VERSINE_LEAST : LOBE_SG_VERSINE_LO), beyond ? 1 : LOBE_SG_VERSINE_HI);
    if (!lobe_sphere_place(next, at[0] + edge, at[1] + edge, at[2], at[3], at[4]))
        return false;
    return lobe_sg_inside(next) == !beyond && lobe_sg_taken(next);
}

/* Uphill, along the axes and in random directions, in steps that shrink where none gains: the rows may have missed the
 * top, and it is often on a ridge. */
static void climb(const lobe_sg_shipped *s, const region *r, double row[5], double *error)
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
            if (!step_from(row, direction, step, r->beyond, next))
                continue;
            e = error_at(s, lobe_truth_sg_columns_fast, next);
            if (e > *error) {
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

static measured measure(const lobe_sg_shipped *s, const region *r)
{
    measured m = {0};
    double top[STARTS] = {0}, squares = 0;
    size_t where[STARTS] = {0}, i;
    int k, least;
    for (i = 0; i < r->count; i++) {
        const double e = fabs(s->call(r->rows + 5 * i) - r->truth[i]);
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
        climb(s, r, row, &top[k]);
        top[k] = error_at(s, lobe_truth_sg_columns, row);
        if (top[k] > m.max) {
            m.max = top[k];
            memcpy(m.at, row, sizeof row);
        }
    }
    return m;
}

static bool region_make(region *r, bool beyond, const lobe_sweep_options *options)
{
    static const lobe_case fast = {
        .name = "sg_light_judged", .input_count = 5, .output_count = 1, .truth = lobe_truth_sg_columns_fast};
    const lobe_vector_set *set = &lobe_sg_vectors;
    r->beyond = beyond;
    r->judged = beyond ? LOBE_SG_JUDGED / 4 : LOBE_SG_JUDGED;
    r->rows = malloc(5 * (r->judged + LOBE_SG_VECTORS) * sizeof *r->rows);
    r->truth = malloc((r->judged + LOBE_SG_VECTORS) * sizeof *r->truth);
    if (!r->rows || !r->truth) {
        fputs("lobefit: bounds: not enough memory\n", stderr);
        return false;
    }
    lobe_sg_judged(beyond, r->rows, r->judged);
    r->count = r->judged + set->points(0, beyond, set->seed, r->rows + 5 * r->judged, LOBE_SG_VECTORS);
    lobe_truth_cached(&fast, r->rows, r->truth, r->count, options);
    return true;
}

/* Three significant digits, never less than x. */
static double rounded_up(double x)
{
    char text[40];
    double unit;
    if (!(x > 0))
        return 0;
    unit = pow(10, floor(log10(x)) - 2);
    snprintf(text, sizeof text, "%.2e", ceil(x / unit * (1 - 1e-12)) * unit);
    return atof(text);
}

static void put(FILE *f, const lobe_sg_shipped *s, bool with_format, const char *suffix, double x)
{
    fputs("#define LOBE_SG_LIGHT_", f);
    lobe_put_upper(f, s->tier);
    if (with_format) {
        fputc('_', f);
        lobe_put_upper(f, s->format);
    }
    fprintf(f, "_%s %.3g\n", suffix, x);
}

static void put_measured(FILE *f, const lobe_sg_shipped *s, const measured *m, const char *where)
{
    fprintf(f, "/* %s, %s, %s: max %.6e at\n *   %.9g %.9g %.9g %.9g %.9g, rms %.6e */\n", s->tier, s->format, where,
            m->max, m->at[0], m->at[1], m->at[2], m->at[3], m->at[4], m->rms);
}

/* On held-out cells, of uniform and of mixed positions; the macro is the worse. */
static void put_cells(FILE *f, const lobe_sg_shipped *s, const lobe_sg_held *held)
{
    lobe_sg_figures set[2], worst;
    int k;
    lobe_sg_held_judge(held, s->call, set);
    worst = lobe_sg_figures_worse(&set[0], &set[1]);
    for (k = 0; k < 2; k++)
        fprintf(f, "/* %s, %s, held-out cells, %s: all %.4f, smooth %.4f, worst cell %.4f, energy %+.4f */\n", s->tier,
                s->format, k ? "mixed" : "uniform", set[k].all, set[k].smooth, set[k].worst, set[k].energy);
    put(f, s, true, "CELLS", rounded_up(worst.all));
    put(f, s, true, "CELLS_SMOOTH", rounded_up(worst.smooth));
}

static bool put_shipped(FILE *f, const lobe_sg_shipped *s, const region regions[2], const lobe_sg_held *held)
{
    const measured in = measure(s, &regions[0]), out = measure(s, &regions[1]);
    if (lobe_interrupt_requested()) {
        fputs("lobefit: bounds sg_light: interrupted; the old bounds stand\n", stderr);
        return false;
    }
    if (strcmp(s->format, "f32") == 0) {
        const int operations = lobe_sg_operations(s->tier);
        if (operations < 0)
            return false;
        put(f, s, false, "OPS", operations);
    }
    put_measured(f, s, &in, "in the domain");
    put_measured(f, s, &out, "beyond it");
    put(f, s, true, "MAX", rounded_up(in.max));
    put(f, s, true, "RMS", rounded_up(in.rms));
    put(f, s, true, "BELOW_MAX", rounded_up(out.max));
    put_cells(f, s, held);
    return true;
}

static void put_head(FILE *f, const lobe_case *self)
{
    fprintf(
        f,
        "/* Generated, not edited: build/lobefit bounds sg_light\n"
        " * What ships, measured against the truth (%s;\n"
        " * its own error %s). MAX and RMS are of the absolute error of the radiance of a light\n"
        " * of amplitude 1. Domain: roughness [%.9g, 1], n_dot_v [%.9g, 1], n_dot_l [-1, 1], versine [%.9g, %.9g]:\n"
        " * a Latin hypercube of %d rows, each second one near the mirror direction, the vectors, and a walk\n"
        " * uphill from the %d largest errors; RMS over the hypercube. BELOW_MAX: of a quarter as many where "
        "roughness, "
        "down\n"
        " * to %.9g, n_dot_v, down to %.9g, or versine, from %.9g to 1, is outside.\n"
        " * CELLS: relative L2 error on held-out cells (cases/sg_light/cells.h), root of the mean square,\n"
        " * the worse of two sets of positions; SMOOTH where alpha <= .25 and n_dot_v >= .4. OPS: beyond a punctual\n"
        " * light. Witnesses are roughness, n_dot_v, n_dot_l, tangent2, versine. Macros are rounded up. */\n",
        self->brdf, self->accuracy, LOBE_SG_ROUGHNESS_LO, LOBE_SG_N_DOT_V_LO, LOBE_SG_VERSINE_LO, LOBE_SG_VERSINE_HI,
        LOBE_SG_JUDGED, STARTS, LOBE_SG_ROUGHNESS_LEAST, LOBE_SG_N_DOT_V_LEAST, LOBE_SG_VERSINE_LEAST);
}

static bool write_all(const lobe_case *self, const lobe_fit_request *request)
{
    region regions[2] = {{.rows = NULL}};
    lobe_sg_held held = {.ready = false};
    lobe_atomic_file file;
    char path[4200];
    int i;
    bool good = region_make(&regions[0], false, &request->sweep) && region_make(&regions[1], true, &request->sweep) &&
                lobe_sg_held_make(&held, &request->sweep);
    snprintf(path, sizeof path, "%s/sg_light_bounds.h", request->coeffs);
    if (good && (good = lobe_atomic_open(&file, path))) {
        put_head(file.stream, self);
        for (i = 0; good && lobe_sg_shipped_at(i); i++)
            good = put_shipped(file.stream, lobe_sg_shipped_at(i), regions, &held);
        if (good)
            good = lobe_atomic_commit(&file);
        else
            lobe_atomic_abandon(&file);
    }
    lobe_sg_held_free(&held);
    for (i = 0; i < 2; i++) {
        free(regions[i].rows);
        free(regions[i].truth);
    }
    return good;
}

int lobe_sg_bounds(const lobe_case *self, int argc, char **argv)
{
    static const lobe_fit_tier all[] = {{"all", write_all}};
    return lobe_fit_command(self, all, 1, argc, argv);
}
