#include "bounds.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../split_sum/shipped.h"
#include "atomic_file.h"
#include "coefficients.h"
#include "emit.h"
#include "fit_command.h"
#include "judge_points.h"
#include "truth_cache.h"

enum { MEASURES = 3, TABLE_OPERATIONS = 26 };

/* One side of the domain's edge: points and what is true there. */
typedef struct region {
    lobe_judge_points p;
    double *truth; /* scale, bias */
} region;

typedef struct measured {
    double max[MEASURES], at[MEASURES][2], rms[MEASURES];
    double top; /* the largest of max, after a walk uphill from where it is; for energy, of E alone */
} measured;

/* |error| of scale, bias and E; or of E and of the white furnace, through 1/E and through E. */
static void errors(const lobe_shipped *s, const double *at, const double *truth, double *error)
{
    const double e = truth[0] + truth[1];
    double out[3];
    s->call(at, out);
    error[2] = 0;
    if (s->measures == 3) {
        error[0] = fabs(out[0] - truth[0]);
        error[1] = fabs(out[1] - truth[1]);
        error[2] = fabs(out[2] - e);
    } else {
        error[0] = fabs(out[0] - e);
        error[1] = fmax(fabs(e * out[1] - 1), fabs(e / out[0] - 1));
    }
}

/* Where measure m is largest near its witness: the grid may have missed the top by half a step. */
static void climb(const lobe_case *c, const lobe_shipped *s, double lo, double hi, int m, measured *out)
{
    double step[2] = {0.0005 * out->at[m][0] + 0.0002, 0.0005 * out->at[m][1] + 0.0002};
    int i, turn;
    for (turn = 0; turn < 12; turn++) {
        int better = 0;
        for (i = 0; i < 4; i++) {
            double at[2] = {out->at[m][0], out->at[m][1]}, truth[2], error[MEASURES];
            const int axis = i / 2;
            at[axis] = lobe_judge_exact(at[axis] + (i & 1 ? step[axis] : -step[axis]));
            if (at[axis] < lo || at[axis] > 1 || (hi < 1 && at[0] >= hi && at[1] >= hi))
                continue;
            c->truth(at, truth, 1);
            errors(s, at, truth, error);
            if (error[m] > out->max[m]) {
                out->max[m] = error[m];
                memcpy(out->at[m], at, sizeof at);
                better = 1;
            }
        }
        if (!better) {
            step[0] *= 0.5;
            step[1] *= 0.5;
        }
    }
}

static measured measure(const lobe_case *c, const lobe_shipped *s, const region *r, int below)
{
    measured out;
    double sum[MEASURES] = {0};
    size_t i;
    int m;
    memset(&out, 0, sizeof out);
    for (i = 0; i < r->p.count; i++) {
        double error[MEASURES];
        errors(s, r->p.at + 2 * i, r->truth + 2 * i, error);
        for (m = 0; m < MEASURES; m++) {
            if (i < r->p.uniform)
                sum[m] += error[m] * error[m];
            if (error[m] > out.max[m]) {
                out.max[m] = error[m];
                memcpy(out.at[m], r->p.at + 2 * i, sizeof out.at[m]);
            }
        }
    }
    for (m = 0; m < MEASURES; m++) {
        out.rms[m] = r->p.uniform ? sqrt(sum[m] / (double)r->p.uniform) : 0;
        if (out.max[m] > 0)
            climb(c, s, below ? LOBE_JUDGE_LEAST : LOBE_JUDGE_LO, below ? LOBE_JUDGE_LO : 1, m, &out);
        if (m < s->measures)
            out.top = fmax(out.top, out.max[m]);
    }
    return out;
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

static void put_macro(FILE *f, const lobe_shipped *s, const char *suffix, int with_format, double x)
{
    fputs("#define LOBE_", f);
    lobe_put_upper(f, s->model);
    fputc('_', f);
    lobe_put_upper(f, s->tier);
    if (with_format) {
        fputc('_', f);
        lobe_put_upper(f, s->format);
    }
    fprintf(f, "_%s %.3g\n", suffix, x);
}

static void put_measures(FILE *f, const lobe_shipped *s, const measured *in, const char *where)
{
    static const char *const dfg[] = {"scale", "bias", "E"}, *const energy[] = {"E", "furnace"};
    const int count = s->measures == 3 ? 3 : 2;
    int m;
    fprintf(f, "/* %s, %s, %s:", s->tier, s->format, where);
    for (m = 0; m < count; m++) {
        fprintf(f, "%s\n *   %-7s max %.6e at %.9g %.9g", m ? ";" : "", (count == 3 ? dfg : energy)[m], in->max[m],
                in->at[m][0], in->at[m][1]);
        if (in->rms[m] > 0)
            fprintf(f, ", rms %.6e", in->rms[m]);
    }
    fputs(" */\n", f);
}

/* Operations as the kernel's own text counts them; a table's stand in models/split_sum_table.h. */
static bool put_operations(FILE *f, const lobe_shipped *s)
{
    lobe_op_count count = {TABLE_OPERATIONS, TABLE_OPERATIONS};
    if (strncmp(s->tier, "table", 5) != 0 && lobe_emit_count(s->model, s->tier, &count) != 0)
        return false;
    put_macro(f, s, "OPS", 0, count.fused);
    if (s->measures == 1) /* 1/E comes before the division */
        put_macro(f, s, "INVERSE_OPS", 0, count.fused - 4);
    put_macro(f, s, "DOMAIN_LO", 0, LOBE_JUDGE_LO);
    return true;
}

static bool put_shipped(FILE *f, const lobe_case *c, const lobe_shipped *s, const region *inside, const region *below)
{
    const measured in = measure(c, s, inside, 0), out = measure(c, s, below, 1);
    double rms = 0;
    int m;
    if (strcmp(s->format, "f32") == 0 && !put_operations(f, s))
        return false;
    for (m = 0; m < s->measures; m++)
        rms = fmax(rms, in.rms[m]);
    put_measures(f, s, &in, "[.02, 1]");
    put_measures(f, s, &out, "below, down to .001");
    put_macro(f, s, "MAX", 1, rounded_up(in.top));
    put_macro(f, s, "RMS", 1, rounded_up(rms));
    put_macro(f, s, "BELOW_MAX", 1, rounded_up(out.top));
    if (s->measures == 1) {
        put_macro(f, s, "FURNACE", 1, rounded_up(in.max[1]));
        put_macro(f, s, "BELOW_FURNACE", 1, rounded_up(out.max[1]));
    }
    return true;
}

static bool region_make(region *r, lobe_judge_points p, const lobe_case *c, const lobe_sweep_options *options)
{
    r->p = p;
    r->truth = p.at ? malloc(2 * p.count * sizeof *r->truth) : NULL;
    if (!r->truth) {
        fputs("lobefit: bounds: not enough memory\n", stderr);
        return false;
    }
    lobe_truth_cached(c, p.at, r->truth, p.count, options);
    return true;
}

static bool write_bounds(const lobe_case *self, const lobe_case *c, const lobe_fit_request *request)
{
    region inside = {{NULL, 0, 0}, NULL}, below = {{NULL, 0, 0}, NULL};
    lobe_atomic_file file;
    char path[4200];
    bool good = region_make(&inside, lobe_judge_inside(c), c, &request->sweep) &&
                region_make(&below, lobe_judge_below(c), c, &request->sweep);
    snprintf(path, sizeof path, "%s/%s_bounds.h", request->coeffs, self->name);
    if (good && (good = lobe_atomic_open(&file, path))) {
        fprintf(
            file.stream,
            "/* Generated, not edited: build/lobefit bounds %s\n"
            " * What ships, measured against the truth (%s; its own error %s).\n"
            " * [.02, 1]: a grid of 1024 x 1024, 2^17 random points denser toward low roughness and grazing views,\n"
            " * the vectors, and a walk uphill from each maximum; rms over the grid. Witnesses are roughness and\n"
            " * n_dot_v. Macros are rounded up: MAX over all outputs and their sum E, RMS the largest of theirs. */\n",
            self->name, self->brdf, self->accuracy);
        for (int i = 0; good && lobe_shipped_at(i); i++)
            if (strcmp(lobe_shipped_at(i)->model, self->name) == 0)
                good = put_shipped(file.stream, c, lobe_shipped_at(i), &inside, &below);
        if (good)
            good = lobe_atomic_commit(&file);
        else
            lobe_atomic_abandon(&file);
    }
    free(inside.p.at);
    free(inside.truth);
    free(below.p.at);
    free(below.truth);
    return good;
}

static bool write_all(const lobe_case *self, const lobe_fit_request *request)
{
    /* E is the sum of the split sum's terms, and their truth is kept. */
    return write_bounds(self, strcmp(self->name, "energy") == 0 ? lobe_case_find("split_sum") : self, request);
}

int lobe_bounds_command(const lobe_case *self, int argc, char **argv)
{
    static const lobe_fit_tier all[] = {{"all", write_all}};
    int i, found = 0;
    for (i = 0; lobe_shipped_at(i); i++)
        found += strcmp(lobe_shipped_at(i)->model, self->name) == 0;
    if (!found) {
        fprintf(stderr, "lobefit: bounds: nothing of %s ships yet\n", self->name);
        return 2;
    }
    return lobe_fit_command(self, all, 1, argc, argv);
}
