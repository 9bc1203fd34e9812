#include "bounds.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../fit/atomic_file.h"
#include "../fit/bound_header.h"
#include "../fit/fit_command.h"
#include "../fit/interrupt.h"
#include "../fit/measure.h"
#include "columns.h"
#include "../sphere_light/columns.h"
#include "held.h"
#include "operations.h"
#include "points.h"
#include "shipped.h"
#include "tiers.h"

static const double edge = 3e-8; /* half a unit of the rows, so that an edge rounds into the domain */

/* Directions are of roughness, view, axis, azimuth, versine. A step over the domain's edge ends on it. */
static bool step_from(const double *row, const double *direction, double step, bool beyond, double *next)
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

static const lobe_quantity radiance = {
    .judged = {.name = "sg_light_judged", .input_count = 5, .output_count = 1, .truth = lobe_truth_sg_columns_fast},
    .truth = lobe_truth_sg_columns,
    .vectors = &lobe_sg_vectors,
    .hypercube = lobe_sg_judged,
    .rows = {LOBE_SG_JUDGED, LOBE_SG_JUDGED / 4},
    .step = step_from,
    .starts = 2,
    .halvings = 10,
    .ways = 18};

static void put(FILE *f, const lobe_sg_shipped *s, bool with_format, const char *suffix, double x)
{
    lobe_put_bound(f, "sg_light", s->tier, with_format ? s->format : NULL, suffix, x);
}

static void put_measured(FILE *f, const lobe_sg_shipped *s, const lobe_measured *m, const char *where)
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
    put(f, s, true, "CELLS", lobe_rounded_up(worst.all));
    put(f, s, true, "CELLS_SMOOTH", lobe_rounded_up(worst.smooth));
}

static bool put_shipped(FILE *f, const lobe_sg_shipped *s, const lobe_region regions[2], const lobe_sg_held *held)
{
    const lobe_measured in = lobe_measure(s->call, &regions[0]), out = lobe_measure(s->call, &regions[1]);
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
    put(f, s, true, "MAX", lobe_rounded_up(in.max));
    put(f, s, true, "RMS", lobe_rounded_up(in.rms));
    put(f, s, true, "BELOW_MAX", lobe_rounded_up(out.max));
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
        LOBE_SG_JUDGED, radiance.starts, LOBE_SG_ROUGHNESS_LEAST, LOBE_SG_N_DOT_V_LEAST, LOBE_SG_VERSINE_LEAST);
}

static bool write_all(const lobe_case *self, const lobe_fit_request *request)
{
    lobe_region regions[2] = {{.rows = NULL}};
    lobe_sg_held held = {.ready = false};
    lobe_atomic_file file;
    char path[4200];
    int i;
    bool good = lobe_regions_make(regions, &radiance, &request->sweep) && lobe_sg_held_make(&held, &request->sweep);
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
    lobe_regions_free(regions);
    return good;
}

int lobe_sg_bounds(const lobe_case *self, int argc, char **argv)
{
    static const lobe_fit_tier all[] = {{"all", write_all}};
    return lobe_fit_command(self, all, 1, argc, argv);
}
