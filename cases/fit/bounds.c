#include "bounds.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "atomic_file.h"
#include "bound_header.h"
#include "emit.h"
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

/* A table's stand in models/split_sum_table.h. */
static int operations_of(const lobe_shipped *s)
{
    lobe_op_count count = {TABLE_OPERATIONS, TABLE_OPERATIONS};
    return strncmp(s->tier, "table", 5) == 0 || lobe_emit_count(s->model, s->tier, &count) == 0 ? count.fused : -1;
}

static bool put_operations(FILE *f, const lobe_bounded *what, const lobe_shipped *s)
{
    const int operations = what->operations(s);
    if (operations < 0)
        return false;
    lobe_put_bound(f, s->model, s->tier, NULL, "OPS", operations);
    if (s->inverse) /* 1/E comes before the division */
        lobe_put_bound(f, s->model, s->tier, NULL, "INVERSE_OPS", operations - 4);
    lobe_put_bound(f, s->model, s->tier, NULL, "DOMAIN_LO", LOBE_JUDGE_LO);
    return true;
}

static bool put_shipped(FILE *f, const lobe_bounded *what, const lobe_shipped *s, const region *inside,
                        const region *below)
{
    const measured in = measure(what->truth, s, inside, 0), out = measure(what->truth, s, below, 1);
    char part[40];
    double rms = 0;
    int m;
    if (strcmp(s->format, "f32") == 0 && !put_operations(f, what, s))
        return false;
    for (m = 0; m < s->measures; m++)
        rms = fmax(rms, in.rms[m]);
    put_measures(f, s, &in, "[.02, 1]");
    put_measures(f, s, &out, "below, down to .001");
    lobe_put_bound(f, s->model, s->tier, s->format, "MAX", lobe_rounded_up(in.top));
    lobe_put_bound(f, s->model, s->tier, s->format, "RMS", lobe_rounded_up(rms));
    lobe_put_bound(f, s->model, s->tier, s->format, "BELOW_MAX", lobe_rounded_up(out.top));
    if (s->measures == 1) {
        snprintf(part, sizeof part, "BELOW_%s", what->part);
        lobe_put_bound(f, s->model, s->tier, s->format, what->part, lobe_rounded_up(in.max[1]));
        lobe_put_bound(f, s->model, s->tier, s->format, part, lobe_rounded_up(out.max[1]));
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

bool lobe_bounds_write(const lobe_case *self, const lobe_bounded *what, const lobe_fit_request *request)
{
    const lobe_case *c = what->truth;
    region inside = {{NULL, 0, 0}, NULL}, below = {{NULL, 0, 0}, NULL};
    lobe_atomic_file file;
    char path[4200];
    int i;
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
            " * n_dot_v. Macros are rounded up%s */\n",
            self->name, c->brdf, c->accuracy, what->note);
        for (i = 0; good && what->shipped(i); i++)
            if (strcmp(what->shipped(i)->model, self->name) == 0)
                good = put_shipped(file.stream, what, what->shipped(i), &inside, &below);
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
    const lobe_bounded what = {.truth = strcmp(self->name, "energy") == 0 ? lobe_case_find("split_sum") : self,
                               .shipped = lobe_shipped_at,
                               .part = "FURNACE",
                               .note = ": MAX over all outputs and their sum E, RMS the largest of theirs.",
                               .operations = operations_of};
    return lobe_bounds_write(self, &what, request);
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
