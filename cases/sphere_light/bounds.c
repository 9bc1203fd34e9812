#include "bounds.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../fit/atomic_file.h"
#include "../fit/bound_header.h"
#include "../fit/emit.h"
#include "../fit/fit_command.h"
#include "../fit/interrupt.h"
#include "columns.h"
#include "held.h"
#include "measure.h"
#include "points.h"
#include "shipped.h"
#include "tiers.h"

static void put(FILE *f, const lobe_sphere_shipped *s, bool with_format, const char *suffix, double x)
{
    lobe_put_bound(f, "sphere_light", s->tier, with_format ? s->format : NULL, suffix, x);
}

static void put_measured(FILE *f, const lobe_sphere_shipped *s, const lobe_measured *m, const char *where)
{
    fprintf(f, "/* %s, %s, %s: max %.6e at\n *   %.9g %.9g %.9g %.9g %.9g, rms %.6e */\n", s->tier, s->format, where,
            m->max, m->at[0], m->at[1], m->at[2], m->at[3], m->at[4], m->rms);
}

/* On held-out cells, of uniform and of mixed positions; the macro is the worse. */
static void put_cells(FILE *f, const lobe_sphere_shipped *s, const lobe_sphere_held *held)
{
    lobe_sphere_figures set[2], worst;
    int k;
    lobe_sphere_held_judge(held, s->call, set);
    worst = lobe_sphere_figures_worse(&set[0], &set[1]);
    for (k = 0; k < 2; k++)
        fprintf(f,
                "/* %s, %s, held-out cells, %s: all %.4f, view <= 60 %.4f, view >= 75 %.4f,\n"
                " *   worst cell %.4f, energy %+.4f, over a punctual light where sine < alpha / 2 %.4f */\n",
                s->tier, s->format, k ? "mixed" : "uniform", set[k].all, set[k].view60, set[k].view75, set[k].worst,
                set[k].energy, set[k].excess);
    put(f, s, true, "CELLS", lobe_rounded_up(worst.all));
    put(f, s, true, "CELLS_VIEW60", lobe_rounded_up(worst.view60));
    put(f, s, true, "CELLS_VIEW75", lobe_rounded_up(worst.view75));
    fprintf(f, "/* %s, %s, held-out cells, energy over even positions: worst cell %+.4f */\n", s->tier, s->format,
            worst.integral);
    put(f, s, true, "CELLS_ENERGY", lobe_rounded_up(fmax(fabs(worst.integral), fabs(set[1].energy))));
    put(f, s, true, "CELLS_ENERGY_SAMPLED", lobe_rounded_up(fabs(worst.energy)));
    put(f, s, true, "CELLS_EXCESS", lobe_rounded_up(worst.excess));
}

static bool put_shipped(FILE *f, const lobe_sphere_shipped *s, const lobe_region regions[2],
                        const lobe_sphere_held *held)
{
    const lobe_measured in = lobe_measure(s->call, &regions[0]), out = lobe_measure(s->call, &regions[1]);
    if (lobe_interrupt_requested()) {
        fputs("lobefit: bounds sphere_light: interrupted; the old bounds stand\n", stderr);
        return false;
    }
    if (strcmp(s->format, "f32") == 0) {
        lobe_op_count count;
        if (lobe_emit_count_sphere(s->tier, &count) != 0)
            return false;
        put(f, s, false, "OPS", count.fused);
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
            "/* Generated, not edited: build/lobefit bounds sphere_light\n"
            " * What ships, measured against the truth (%s;\n"
            " * its own error %s). MAX and RMS are of the absolute error of the radiance of a light\n"
            " * of radiance 1. Domain: roughness [%.9g, 1], n_dot_v [%.9g, 1], n_dot_l [-1, 1], sine (0, %.9g]:\n"
            " * a Latin hypercube of %d rows, each second one near the mirror direction, the vectors, and a walk\n"
            " * uphill from the %d largest errors; RMS over the hypercube. BELOW_MAX: of half as many where roughness, "
            "down\n"
            " * to %.9g, where the truth ends, n_dot_v, down to %.9g, or sine, up to 1, is outside.\n"
            " * CELLS: relative L2 error on held-out cells (cases/sphere_light/cells.h), root of the mean square,\n"
            " * the worse of two sets of positions; ENERGY of the worst cell, over 1000 even positions and\n"
            " * over the mixed ones, SAMPLED over 200 uniform ones, where a single one can be all of the light. OPS: "
            "beyond a punctual light.\n"
            " * Witnesses are roughness, n_dot_v, n_dot_l, tangent2, sine. Macros are rounded up. */\n",
            self->brdf, self->accuracy, LOBE_SPHERE_ROUGHNESS_LO, LOBE_SPHERE_N_DOT_V_LO, LOBE_SPHERE_SINE_HI,
            LOBE_SPHERE_JUDGED, lobe_sphere_radiance.starts, LOBE_SPHERE_ROUGHNESS_LEAST, LOBE_SPHERE_N_DOT_V_LEAST);
}

static bool write_all(const lobe_case *self, const lobe_fit_request *request)
{
    lobe_region regions[2] = {{.rows = NULL}};
    lobe_sphere_held held = {.ready = false};
    lobe_atomic_file file;
    char path[4200];
    int i;
    bool good = lobe_regions_make(regions, &lobe_sphere_radiance, &request->sweep) &&
                lobe_sphere_held_make(&held, &request->sweep);
    snprintf(path, sizeof path, "%s/sphere_light_bounds.h", request->coeffs);
    if (good && (good = lobe_atomic_open(&file, path))) {
        put_head(file.stream, self);
        for (i = 0; good && lobe_sphere_shipped_at(i); i++)
            good = put_shipped(file.stream, lobe_sphere_shipped_at(i), regions, &held);
        if (good)
            good = lobe_atomic_commit(&file);
        else
            lobe_atomic_abandon(&file);
    }
    lobe_sphere_held_free(&held);
    lobe_regions_free(regions);
    return good;
}

int lobe_sphere_bounds(const lobe_case *self, int argc, char **argv)
{
    static const lobe_fit_tier all[] = {{"all", write_all}};
    return lobe_fit_command(self, all, 1, argc, argv);
}
