/* What ships of Schlick inside a sphere light: the error of s, and what a reflectance adds to the error of a tier. */
#include <math.h>
#include <stdlib.h>
#include "../../models/lobe.h"
#include "../fit/atomic_file.h"
#include "../fit/bound_header.h"
#include "../fit/emit.h"
#include "../fit/fit_command.h"
#include "../fit/interrupt.h"
#include "columns.h"
#include "held.h"
#include "judge.h"
#include "measure.h"
#include "points.h"
#include "schlick_case.h"

static lobe_sphere_f32 f32_of(const double row[5])
{
    return lobe_sphere_of_f32((float)row[1], (float)row[2], (float)row[3], (float)row[4]);
}

static int32_t q30(double x) { return (int32_t)floor(x * 1073741824.0 + .5); }

static lobe_sphere_q30 q30_of(const double row[5])
{
    const lobe_sphere_q30 light = {q30(row[1]), q30(row[2]), q30(row[3]), q30(row[4])};
    return light;
}

static double low_f32(const double row[5]) { return (double)lobe_sphere_light_schlick_f32((float)row[0], f32_of(row)); }
static double high_f32(const double row[5])
{
    return (double)lobe_sphere_light_high_lit_f32((float)row[0], f32_of(row)).schlick;
}
static double low_q30(const double row[5])
{
    return lobe_sphere_light_schlick_q30(q30(row[0]), q30_of(row)) / 1073741824.0;
}
static double high_q30(const double row[5])
{
    return lobe_sphere_light_high_lit_q30(q30(row[0]), q30_of(row)).schlick / 1073741824.0;
}
static const struct {
    const char *tier, *format;
    double (*call)(const double row[5]);
} forms[] = {{"low", "f32", low_f32}, {"low", "q30", low_q30}, {"high", "f32", high_f32}, {"high", "q30", high_q30}};

static double radiance_low(const double row[5])
{
    return (double)lobe_sphere_light_low_f32((float)row[0], f32_of(row));
}
static double radiance_medium(const double row[5])
{
    return (double)lobe_sphere_light_medium_f32((float)row[0], f32_of(row));
}
static double radiance_high(const double row[5])
{
    return (double)lobe_sphere_light_high_lit_f32((float)row[0], f32_of(row)).radiance;
}
static const struct {
    const char *name;
    double (*radiance)(const double row[5]), (*schlick)(const double row[5]);
} tiers[] = {{"low", radiance_low, low_f32}, {"medium", radiance_medium, low_f32}, {"high", radiance_high, high_f32}};

static const lobe_case lit = {
    .name = "sphere_light_lit", .input_count = 5, .output_count = 1, .truth = lobe_truth_sphere_columns_fast};

static const lobe_quantity schlick = {.judged = {.name = "sphere_light_schlick_judged",
                                                 .input_count = 5,
                                                 .output_count = 1,
                                                 .truth = lobe_truth_sphere_schlick_columns_fast},
                                      .truth = lobe_truth_sphere_schlick_columns,
                                      .vectors = &lobe_sphere_schlick_vectors,
                                      .hypercube = lobe_sphere_judged,
                                      .rows = {LOBE_SPHERE_JUDGED, LOBE_SPHERE_JUDGED / 2},
                                      .step = lobe_sphere_step,
                                      .starts = 4,
                                      .halvings = 12,
                                      .ways = 24,
                                      .gain = 1e-3,
                                      .lit = &lit,
                                      .least = LOBE_SPHERE_SCHLICK_LEAST};

static void put(FILE *f, const char *tier, const char *format, const char *suffix, double x)
{
    lobe_put_bound(f, "sphere_light_schlick", tier, format, suffix, x);
}

static bool put_forms(FILE *f, const lobe_region regions[2])
{
    size_t i;
    for (i = 0; i < sizeof forms / sizeof forms[0]; i++) {
        const lobe_measured in = lobe_measure(forms[i].call, &regions[0]);
        const lobe_measured out = lobe_measure(forms[i].call, &regions[1]);
        lobe_op_count count;
        if (lobe_interrupt_requested()) {
            fputs("lobefit: bounds sphere_light_schlick: interrupted; the old bounds stand\n", stderr);
            return false;
        }
        if (forms[i].call == low_f32 || forms[i].call == high_f32) {
            if (lobe_emit_count_sphere_schlick(forms[i].tier, &count) != 0)
                return false;
            put(f, forms[i].tier, NULL, "OPS", count.fused);
        }
        fprintf(
            f, "/* %s, %s, in the domain: max %.6e at\n *   %.9g %.9g %.9g %.9g %.9g, rms %.6e; beyond it %.6e */\n",
            forms[i].tier, forms[i].format, in.max, in.at[0], in.at[1], in.at[2], in.at[3], in.at[4], in.rms, out.max);
        put(f, forms[i].tier, forms[i].format, "MAX", lobe_rounded_up(in.max));
        put(f, forms[i].tier, forms[i].format, "RMS", lobe_rounded_up(in.rms));
        put(f, forms[i].tier, forms[i].format, "BELOW_MAX", lobe_rounded_up(out.max));
    }
    return true;
}

enum { F0S = 5 };
static const double f0s[F0S] = {.5, .2, .1, .04, .02};

/* What every f0 adds to a tier's error over all cells; the macros are the worse of both sets of positions. */
static bool put_added(FILE *f, const lobe_sphere_held *held, size_t tier)
{
    double *y = malloc(2 * LOBE_SPHERE_COUNT * sizeof *y), worst[F0S];
    lobe_sphere_score *score = malloc(2 * sizeof *score);
    int set, i, k;
    if (!y || !score)
        fputs("lobefit: bounds: not enough memory\n", stderr);
    for (set = 0; y && score && set < 2; set++) {
        for (i = 0; i < LOBE_SPHERE_COUNT; i++) {
            y[i] = tiers[tier].radiance(held->columns[set] + 5 * i);
            y[LOBE_SPHERE_COUNT + i] = tiers[tier].schlick(held->columns[set] + 5 * i);
        }
        lobe_sphere_judge_values(y, &held->cells[set], &score[0]);
        fprintf(f, "/* %s, %s: %.4f at F0 = 1", tiers[tier].name, set ? "mixed" : "uniform", score[0].all);
        for (k = 0; k < F0S; k++) {
            lobe_sphere_judge_lit(y, y + LOBE_SPHERE_COUNT, f0s[k], &held->cells[set], &score[1]);
            fprintf(f, ", %+.4f at %g", score[1].all - score[0].all, f0s[k]);
            worst[k] = fmax(set ? worst[k] : 0, score[1].all - score[0].all);
        }
        fputs(" */\n", f);
    }
    for (k = 0; y && score && k < F0S; k++) {
        char suffix[40];
        snprintf(suffix, sizeof suffix, "ADDS_%02d", (int)(100 * f0s[k] + .5));
        put(f, tiers[tier].name, "F32", suffix, lobe_rounded_up(worst[k]));
    }
    free(score);
    free(y);
    return y && score;
}

static bool write_all(const lobe_case *self, const lobe_fit_request *request)
{
    lobe_region regions[2] = {{.rows = NULL}};
    lobe_sphere_held held = {.ready = false};
    lobe_atomic_file file;
    char path[4200];
    size_t i;
    bool good = lobe_regions_make(regions, &schlick, &request->sweep) &&
                lobe_sphere_held_make(&held, &request->sweep) &&
                lobe_sphere_cells_add_dark(&held.cells[0], &request->sweep) &&
                lobe_sphere_cells_add_dark(&held.cells[1], &request->sweep);
    snprintf(path, sizeof path, "%s/sphere_light_schlick_bounds.h", request->coeffs);
    if (good && (good = lobe_atomic_open(&file, path))) {
        fprintf(
            file.stream,
            "/* Generated, not edited: build/lobefit bounds sphere_light_schlick\n"
            " * What ships, measured against the truth (%s;\n"
            " * its own error %s). MAX and RMS are of s, absolute, where the light gives at least %g: as\n"
            " * in sphere_light_bounds.h over its hypercube, the vectors and a walk uphill; BELOW_MAX outside of the\n"
            " * domain. OPS: low from scratch, high beyond its radiance. ADDS: what F0 = .5, .2, .1, .04, .02 adds to\n"
            " * the relative L2 error over the held-out cells, in f32, low and medium with the s of low, high with\n"
            " * its own; 0 where it takes away. Macros are rounded up. */\n",
            self->brdf, self->accuracy, LOBE_SPHERE_SCHLICK_LEAST);
        good = put_forms(file.stream, regions);
        for (i = 0; good && i < sizeof tiers / sizeof tiers[0]; i++)
            good = put_added(file.stream, &held, i);
        if (good)
            good = lobe_atomic_commit(&file);
        else
            lobe_atomic_abandon(&file);
    }
    lobe_sphere_held_free(&held);
    lobe_regions_free(regions);
    return good;
}

int lobe_sphere_schlick_bounds(const lobe_case *self, int argc, char **argv)
{
    static const lobe_fit_tier all[] = {{"all", write_all}};
    return lobe_fit_command(self, all, 1, argc, argv);
}
