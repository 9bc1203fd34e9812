/* `lobefit bounds sg_diffuse`: what ships, and the inner product beside it, measured against the truth over more points
 * than the fit has seen, into models/coeffs/sg_diffuse_bounds.h. */
#include <math.h>
#include <stdlib.h>
#include "../../models/lobe.h"
#include "../fit/atomic_file.h"
#include "../fit/bound_header.h"
#include "../fit/fit_command.h"
#include "../fit/truth_cache.h"
#include "diffuse_case.h"
#include "operations.h"

enum { WIDTHS = 97, HEIGHTS = 161, ROWS = WIDTHS * HEIGHTS, WIDER = 16, BEYOND = WIDER * HEIGHTS };

static int32_t q30(double x) { return (int32_t)floor(x * 1073741824.0 + 0.5); }

static double high_f32(double c, double w) { return (double)lobe_sg_diffuse_high_f32((float)c, (float)w); }
static double high_q30(double c, double w)
{
    const lobe_scaled_q30 y = lobe_sg_diffuse_high_q30(q30(c), q30(w));
    return ldexp(y.mantissa, y.exponent - 30);
}
static double inner_f32(double c, double w) { return (double)lobe_sg_diffuse_inner_f32((float)c, (float)w); }

static const struct shipped {
    const char *tier, *format;
    double (*call)(double n_dot_l, double versine);
} shipped[] = {{"high", "f32", high_f32}, {"high", "q30", high_q30}, {"inner", "f32", inner_f32}};

typedef struct grid {
    double in[2 * ROWS], truth[ROWS];
    double in_beyond[2 * BEYOND], truth_beyond[BEYOND]; /* wider lights than the domain has */
} grid;

/* Even in the logarithm of the sharpness and in the height; multiples of 2^-24. A row a width ends overhead. */
static void fill(grid *g, const lobe_sweep_options *options)
{
    static const lobe_case kept = {
        .name = "sg_diffuse_judged", .input_count = 2, .output_count = 1, .truth = lobe_truth_sg_diffuse_rows};
    int i, k;
    for (i = 0; i < WIDTHS; i++)
        for (k = 0; k < HEIGHTS; k++) {
            double *row = g->in + 2 * (HEIGHTS * i + k);
            row[0] = floor((2.0 * k / (HEIGHTS - 1) - 1) * 16777216) / 16777216;
            row[1] = floor(pow(LOBE_SG_DIFFUSE_VERSINE_LO, (double)i / (WIDTHS - 1)) * 16777216) / 16777216;
        }
    lobe_truth_cached(&kept, g->in, g->truth, ROWS, options);
    for (i = 0; i < WIDER; i++)
        for (k = 0; k < HEIGHTS; k++) {
            double *row = g->in_beyond + 2 * (HEIGHTS * i + k);
            row[0] = g->in[2 * k];
            row[1] = 1 + (i + 1.0) / WIDER - 0x1p-24;
        }
    lobe_truth_cached(&kept, g->in_beyond, g->truth_beyond, BEYOND, options);
}

static void put_measured(FILE *f, const struct shipped *s, const grid *g)
{
    double most = 0, part = 0, squares = 0, parts = 0, beyond = 0;
    int i, at = 0, of = 0;
    for (i = 0; i < ROWS; i++) {
        const double off = fabs(s->call(g->in[2 * i], g->in[2 * i + 1]) - g->truth[i]);
        const double overhead = off / g->truth[i / HEIGHTS * HEIGHTS + HEIGHTS - 1];
        squares += off * off;
        parts += overhead * overhead;
        if (off > most) {
            most = off;
            at = i;
        }
        if (overhead > part) {
            part = overhead;
            of = i;
        }
    }
    for (i = 0; i < BEYOND; i++)
        beyond = fmax(beyond, fabs(s->call(g->in_beyond[2 * i], g->in_beyond[2 * i + 1]) - g->truth_beyond[i]));
    fprintf(f, "/* %s, %s: max %.6e at %.9g %.9g, rms %.6e;\n", s->tier, s->format, most, g->in[2 * at],
            g->in[2 * at + 1], sqrt(squares / ROWS));
    fprintf(f, " *   of the light overhead: max %.6e at %.9g %.9g, rms %.6e */\n", part, g->in[2 * of],
            g->in[2 * of + 1], sqrt(parts / ROWS));
    lobe_put_bound(f, "sg_diffuse", s->tier, s->format, "MAX", lobe_rounded_up(most));
    lobe_put_bound(f, "sg_diffuse", s->tier, s->format, "RMS", lobe_rounded_up(sqrt(squares / ROWS)));
    lobe_put_bound(f, "sg_diffuse", s->tier, s->format, "BEYOND_MAX", lobe_rounded_up(beyond));
    lobe_put_bound(f, "sg_diffuse", s->tier, s->format, "OF_OVERHEAD", lobe_rounded_up(part));
    lobe_put_bound(f, "sg_diffuse", s->tier, s->format, "OF_OVERHEAD_RMS", lobe_rounded_up(sqrt(parts / ROWS)));
}

static bool write_all(const lobe_case *self, const lobe_fit_request *request)
{
    grid *g = malloc(sizeof *g);
    lobe_atomic_file file;
    char path[4200];
    size_t i;
    snprintf(path, sizeof path, "%s/sg_diffuse_bounds.h", request->coeffs);
    if (!g || !lobe_atomic_open(&file, path)) {
        free(g);
        return false;
    }
    fill(g, &request->sweep);
    fprintf(file.stream,
            "/* Generated, not edited: build/lobefit bounds sg_diffuse\n"
            " * What ships, measured against the truth (its own error %s) on %d versines\n"
            " * from %.9g to 1 and %d heights. MAX and RMS are absolute, BEYOND_MAX for versines from 1 to 2,\n"
            " * OF_OVERHEAD is in parts of what the light gives overhead. Witnesses are n_dot_l and versine. Macros are\n"
            " * rounded up. */\n",
            self->accuracy, WIDTHS, LOBE_SG_DIFFUSE_VERSINE_LO, HEIGHTS);
    for (i = 0; i < sizeof shipped / sizeof shipped[0]; i++) {
        if (shipped[i].format[0] == 'f')
            lobe_put_bound(file.stream, "sg_diffuse", shipped[i].tier, NULL, "OPS",
                           lobe_sg_diffuse_operations(shipped[i].tier));
        put_measured(file.stream, &shipped[i], g);
    }
    free(g);
    return lobe_atomic_commit(&file);
}

int lobe_sg_diffuse_bounds(const lobe_case *self, int argc, char **argv)
{
    static const lobe_fit_tier all[] = {{"all", write_all}};
    return lobe_fit_command(self, all, 1, argc, argv);
}
