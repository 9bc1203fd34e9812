#include "bounds.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../fit/atomic_file.h"
#include "../fit/bound_header.h"
#include "../fit/fit_command.h"
#include "../fit/measure.h"
#include "judge.h"
#include "operations.h"
#include "points.h"
#include "shipped.h"
#include "tiers.h"
#include "truth_capsule.h"

enum { COLUMNS = 9 };

static void fast_rows(const double *in, double *out, size_t n)
{
    size_t i;
    for (i = 0; i < n; i++, in += COLUMNS) {
        const lobe_capsule_scene s = {in[0] * in[0], in[1], 1, {in[2], in[3], in[4]}, {in[5], in[6], in[7]}, in[8]};
        out[i] = lobe_truth_capsule(&s, 1e-5);
    }
}

static bool step_from(const double *row, const double *direction, double step, bool beyond, double *next)
{
    int k;
    for (k = 0; k < COLUMNS; k++)
        next[k] = row[k] + step * direction[k];
    return lobe_capsule_settle(next, beyond);
}

static const lobe_quantity radiance = {
    .judged = {.name = "capsule_light_judged", .input_count = COLUMNS, .output_count = 1, .truth = fast_rows},
    .vectors = &lobe_capsule_vectors,
    .hypercube = lobe_capsule_judged,
    .rows = {LOBE_CAPSULE_JUDGED, LOBE_CAPSULE_JUDGED / 2},
    .step = step_from,
    .starts = 4,
    .halvings = 8,
    .ways = 2 * COLUMNS,
    .still = true};

static void put(FILE *f, const lobe_capsule_shipped *s, bool with_format, const char *suffix, double x)
{
    lobe_put_bound(f, "capsule_light", s->tier, with_format ? s->format : NULL, suffix, x);
}

static void put_measured(FILE *f, const lobe_capsule_shipped *s, const lobe_measured *m, const char *where)
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
    put(f, s, true, "CELLS", lobe_rounded_up(score.all));
    put(f, s, true, "CELLS_VIEW60", lobe_rounded_up(score.view60));
    put(f, s, true, "CELLS_VIEW75", lobe_rounded_up(score.view75));
    put(f, s, true, "CELLS_ENERGY", lobe_rounded_up(fabs(score.energy)));
}

static bool put_shipped(FILE *f, const lobe_capsule_shipped *s, const lobe_region regions[2],
                        const lobe_capsule_cells *held)
{
    const lobe_measured in = lobe_measure(s->call, &regions[0]), out = lobe_measure(s->call, &regions[1]);
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
    put(f, s, true, "MAX", lobe_rounded_up(in.max));
    put(f, s, true, "RMS", lobe_rounded_up(in.rms));
    put(f, s, true, "BELOW_MAX", lobe_rounded_up(out.max));
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
            self->brdf, lobe_capsule_vectors.domain, LOBE_CAPSULE_JUDGED, radiance.starts, lobe_capsule_vectors.beyond,
            "roughness, n_dot_v, middle, arm, radius");
}

static bool write_all(const lobe_case *self, const lobe_fit_request *request)
{
    lobe_region regions[2] = {{.rows = NULL}};
    lobe_capsule_cells held = {.in = NULL};
    lobe_atomic_file file;
    char path[4200];
    int i;
    bool good = lobe_regions_make(regions, &radiance, &request->sweep);
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
    lobe_regions_free(regions);
    return good;
}

int lobe_capsule_bounds(const lobe_case *self, int argc, char **argv)
{
    static const lobe_fit_tier all[] = {{"all", write_all}};
    return lobe_fit_command(self, all, 1, argc, argv);
}
