#include "bounds.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../fit/atomic_file.h"
#include "../fit/coefficients.h"
#include "../fit/fit_command.h"
#include "../fit/truth_cache.h"
#include "judge.h"
#include "operations.h"
#include "points.h"
#include "shipped.h"
#include "tiers.h"
#include "truth_capsule.h"

enum { STARTS = 4, HALVINGS = 8, COLUMNS = 9 };

/* One side of the domain's edge: rows, and what is true there. */
typedef struct region {
    double *rows, *truth;
    size_t judged, count; /* of the hypercube; with the vectors */
    bool beyond;
} region;

typedef struct measured {
    double max, at[COLUMNS], rms;
} measured;

static void fast_rows(const double *in, double *out, size_t n)
{
    size_t i;
    for (i = 0; i < n; i++, in += COLUMNS) {
        const lobe_capsule_scene s = {in[0] * in[0], in[1], 1, {in[2], in[3], in[4]}, {in[5], in[6], in[7]}, in[8]};
        out[i] = lobe_truth_capsule(&s, 1e-5);
    }
}

static double error_at(const lobe_capsule_shipped *s, const double *row)
{
    double truth;
    fast_rows(row, &truth, 1);
    return fabs(s->call(row) - truth);
}

/* Uphill from a row, in steps that shrink where none gains: the rows may have missed the top. */
static void climb(const lobe_capsule_shipped *s, const region *r, double row[COLUMNS], double *error)
{
    double step = .02;
    int axis, halvings = 0;
    while (halvings < HALVINGS) {
        bool gained = false;
        for (axis = 0; axis < 2 * COLUMNS; axis++) {
            double next[COLUMNS], e;
            memcpy(next, row, sizeof next);
            next[axis / 2] += axis & 1 ? step : -step;
            if (!lobe_capsule_settle(next, r->beyond) || (e = error_at(s, next)) <= *error)
                continue;
            *error = e;
            memcpy(row, next, sizeof next);
            gained = true;
        }
        if (!gained) {
            step *= .5;
            halvings++;
        }
    }
}

static measured measure(const lobe_capsule_shipped *s, const region *r)
{
    measured m = {0};
    double top[STARTS] = {0}, squares = 0;
    size_t where[STARTS] = {0}, i;
    int k, least;
    for (i = 0; i < r->count; i++) {
        const double e = fabs(s->call(r->rows + COLUMNS * i) - r->truth[i]);
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
        double row[COLUMNS];
        memcpy(row, r->rows + COLUMNS * where[k], sizeof row);
        if (!r->beyond) /* there the errors reach 1 as they are */
            climb(s, r, row, &top[k]);
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
        .name = "capsule_light_judged", .input_count = COLUMNS, .output_count = 1, .truth = fast_rows};
    const lobe_vector_set *set = &lobe_capsule_vectors;
    r->beyond = beyond;
    r->judged = beyond ? LOBE_CAPSULE_JUDGED / 2 : LOBE_CAPSULE_JUDGED;
    r->rows = malloc(COLUMNS * (r->judged + LOBE_CAPSULE_VECTORS) * sizeof *r->rows);
    r->truth = malloc((r->judged + LOBE_CAPSULE_VECTORS) * sizeof *r->truth);
    if (!r->rows || !r->truth) {
        fputs("lobefit: bounds: not enough memory\n", stderr);
        return false;
    }
    lobe_capsule_judged(beyond, r->rows, r->judged);
    r->count = r->judged + set->points(0, beyond, set->seed, r->rows + COLUMNS * r->judged, LOBE_CAPSULE_VECTORS);
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

static void put(FILE *f, const lobe_capsule_shipped *s, bool with_format, const char *suffix, double x)
{
    fputs("#define LOBE_CAPSULE_LIGHT_", f);
    lobe_put_upper(f, s->tier);
    if (with_format) {
        fputc('_', f);
        lobe_put_upper(f, s->format);
    }
    fprintf(f, "_%s %.3g\n", suffix, x);
}

static void put_measured(FILE *f, const lobe_capsule_shipped *s, const measured *m, const char *where)
{
    int k;
    fprintf(f, "/* %s, %s, %s: max %.6e at\n *  ", s->tier, s->format, where, m->max);
    for (k = 0; k < COLUMNS; k++)
        fprintf(f, " %.9g", m->at[k]);
    fprintf(f, ", rms %.6e */\n", m->rms);
}

static void put_cells(FILE *f, const lobe_capsule_shipped *s, const lobe_capsule_cells *held)
{
    lobe_capsule_score score;
    lobe_capsule_judge(s->call, held, &score);
    fprintf(f,
            "/* %s, %s, held-out cells: all %.4f, view <= 60 %.4f, view >= 75 %.4f, worst cell %.4f,\n"
            " *   energy %+.4f */\n",
            s->tier, s->format, score.all, score.view60, score.view75, score.worst, score.energy);
    put(f, s, true, "CELLS", rounded_up(score.all));
    put(f, s, true, "CELLS_VIEW60", rounded_up(score.view60));
    put(f, s, true, "CELLS_VIEW75", rounded_up(score.view75));
    put(f, s, true, "CELLS_ENERGY", rounded_up(fabs(score.energy)));
}

static bool put_shipped(FILE *f, const lobe_capsule_shipped *s, const region regions[2], const lobe_capsule_cells *held)
{
    const measured in = measure(s, &regions[0]), out = measure(s, &regions[1]);
    if (strcmp(s->format, "f32") == 0) {
#if defined(LOBE_WITH_EMIT)
        put(f, s, false, "OPS", lobe_capsule_operations(s->tier));
#else
        fputs("lobefit: bounds: operations are counted by a program in C++, which this build has not\n", stderr);
        return false;
#endif
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
    fprintf(f,
            "/* Generated, not edited: build/lobefit bounds capsule_light\n"
            " * What ships, measured against the truth (%s;\n"
            " * to 1e-5 here). MAX and RMS are of the absolute error of the radiance of a light of radiance 1.\n"
            " * Domain: %s:\n"
            " * a Latin hypercube of %d rows, each second one near the mirror direction, the vectors, and a walk\n"
            " * uphill from the %d largest errors; RMS over the hypercube. BELOW_MAX: of half as many and no walk,\n"
            " * %s.\n"
            " * CELLS: relative L2 error on held-out cells (cases/capsule_light/cells.h), root of the mean square;\n"
            " * ENERGY of the worst cell. OPS: beyond a punctual light.\n"
            " * Witnesses are rows of %s. Macros are rounded up. */\n",
            self->brdf, lobe_capsule_vectors.domain, LOBE_CAPSULE_JUDGED, STARTS, lobe_capsule_vectors.beyond,
            "roughness, n_dot_v, middle, arm, radius");
}

static bool write_all(const lobe_case *self, const lobe_fit_request *request)
{
    region regions[2] = {{.rows = NULL}};
    lobe_capsule_cells held = {.in = NULL};
    lobe_atomic_file file;
    char path[4200];
    int i;
    bool good = region_make(&regions[0], false, &request->sweep) && region_make(&regions[1], true, &request->sweep);
    if (good && !(good = lobe_capsule_cells_make(&held, true, &request->sweep)))
        fputs("lobefit: bounds: not enough memory\n", stderr);
    snprintf(path, sizeof path, "%s/capsule_light_bounds.h", request->coeffs);
    if (good && (good = lobe_atomic_open(&file, path))) {
        put_head(file.stream, self);
        for (i = 0; good && lobe_capsule_shipped_at(i); i++)
            good = put_shipped(file.stream, lobe_capsule_shipped_at(i), regions, &held);
        if (good)
            good = lobe_atomic_commit(&file);
        else
            lobe_atomic_abandon(&file);
    }
    lobe_capsule_cells_free(&held);
    for (i = 0; i < 2; i++) {
        free(regions[i].rows);
        free(regions[i].truth);
    }
    return good;
}

int lobe_capsule_bounds(const lobe_case *self, int argc, char **argv)
{
    static const lobe_fit_tier all[] = {{"all", write_all}};
    return lobe_fit_command(self, all, 1, argc, argv);
}
