/* Fits 1/E. The furnace error f E - 1 is linear in every coefficient but the first, k, which bends s = v / (k a + v):
 * so for each k there is one linear problem, solved towards its smallest maximum, and over k a search in one
 * dimension: a scan from scratch, then a golden section around its best. The matrix comes from the kernel itself,
 * by calling it with one coefficient at a time, so that the form is written once, in models/energy.h. */
#define LOBE_DOUBLE 1
#define LOBE_FIT 1
#include "fit.h"
#include "../../models/energy.h"
#include "../fit/coefficients.h"
#include "../fit/fit_command.h"
#include "../fit/fit_grid.h"
#include "../fit/minimax.h"
#include "../fit/progress.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 80, SEARCH = 90, SCANS = 14, SECTIONS = 12, FINE = 97, BELOW = 36 };

#define TRUTH_LO 0.001

typedef double (*kernel_fn)(const double *p, double roughness, double n_dot_v);

typedef struct tier {
    const char *name, *kernel, *domain;
    kernel_fn call;
    size_t count;
    double lo;
    double below; /* what an error counts below lo, down to the truth's end; 0: nothing is fitted there */
    int coarse;   /* side of the grid that the search over k uses */
} tier;

/* side^2 points, denser toward every edge and toward low roughness and grazing views. */
typedef struct grid {
    size_t count;
    double *at, *e, *weight; /* rows of roughness and NdotV; the truth; what an error counts */
} grid;

/* The problem for one k: residual = matrix c + fixed. */
typedef struct problem {
    const tier *t;
    const grid *g;
    double *matrix, *fixed; /* matrix: column k at k * count */
    lobe_progress_line line;
} problem;

static void grid_add(grid *g, double roughness, double n_dot_v, double weight)
{
    g->at[2 * g->count] = roughness;
    g->at[2 * g->count + 1] = n_dot_v;
    g->weight[g->count++] = weight;
}

static bool grid_make(grid *g, int side, const tier *t, const lobe_case *c, const lobe_fit_request *request)
{
    const size_t most = (size_t)(side * side) + BELOW * BELOW;
    lobe_sweep_options options = request->sweep;
    double x[BELOW];
    int i, k;
    g->at = malloc(2 * most * sizeof *g->at);
    g->e = malloc(most * sizeof *g->e);
    g->weight = malloc(most * sizeof *g->weight);
    if (!g->at || !g->e || !g->weight) {
        fputs("lobefit: fit: not enough memory\n", stderr);
        return false;
    }
    for (i = 0; i < side; i++)
        for (k = 0; k < side; k++)
            grid_add(g, lobe_fit_roughness(i, side, t->lo), lobe_fit_n_dot_v(k, side, t->lo), 1);
    /* Each step from the truth's end to 1 is the same factor. */
    for (i = 0; i < BELOW; i++)
        x[i] = TRUTH_LO * pow(1 / TRUTH_LO, i / (BELOW - 1.0));
    x[BELOW - 1] = 1;
    for (i = 0; i < BELOW && t->below > 0; i++)
        for (k = 0; k < BELOW; k++)
            if (x[i] < t->lo || x[k] < t->lo)
                grid_add(g, x[i], x[k], t->below);
    options.label = "truth";
    lobe_sweep(c->truth, g->at, 2, g->e, 1, g->count, &options);
    return true;
}

static void grid_free(grid *g)
{
    free(g->at);
    free(g->e);
    free(g->weight);
}

static void residuals(void *ctx, const double *params, size_t count, double *values)
{
    const problem *p = ctx;
    const size_t n = p->t->count - 1, rows = p->g->count;
    size_t i, k, r;
    for (i = 0; i < count; i++) {
        double *out = values + i * rows;
        memcpy(out, p->fixed, rows * sizeof *out);
        for (k = 0; k < n; k++) {
            const double c = params[i * n + k], *column = p->matrix + k * rows;
            for (r = 0; r < rows; r++)
                out[r] += c * column[r];
        }
    }
}

static void jacobian(void *ctx, const double *params, double *transposed)
{
    const problem *p = ctx;
    (void)params;
    memcpy(transposed, p->matrix, (p->t->count - 1) * p->g->count * sizeof *transposed);
}

static void fill(problem *p, double k)
{
    const size_t rows = p->g->count;
    double c[MOST] = {0};
    size_t i, r;
    c[0] = k;
    for (i = 0; i < p->t->count; i++) {
        double *column = i ? p->matrix + (i - 1) * rows : p->fixed;
        if (i)
            c[i] = 1;
        for (r = 0; r < rows; r++) {
            const double f = p->t->call(c, p->g->at[2 * r], p->g->at[2 * r + 1]), e = p->g->e[r];
            column[r] = i ? (f - 1) * e : f * e - 1; /* f = 1 where all are zero */
        }
        if (i)
            c[i] = 0;
    }
}

/* The smallest maximum that this k allows, about; HUGE_VAL where it fails. c: start in, best out. */
static double solve(problem *p, double k, size_t last, lobe_fit_status *status, double *c)
{
    lobe_residuals r = {0};
    lobe_minimax_options o = lobe_minimax_default();
    lobe_minimax_result result;
    fill(p, k);
    r.f = residuals;
    r.jacobian = jacobian;
    r.ctx = p;
    r.dim = p->t->count - 1;
    r.rows = p->g->count;
    r.weights = p->g->weight;
    o.p_last = last;
    o.ridge = 1e-9; /* keeps the coefficients small where two would cancel */
    o.progress = lobe_progress_print;
    o.progress_ctx = &p->line;
    if (last < 100) {
        o.p_growth = 2.5;
        o.steps_per_p = 4;
        o.step_tolerance = 1e-3;
    }
    result = lobe_minimax(&r, &o, c);
    *status = result.fit.status;
    return result.fit.value >= 0 ? result.fit.value : HUGE_VAL;
}

/* The k whose linear problem ends lowest, where *status says that it was not interrupted. */
static double search(problem *p, lobe_fit_status *status)
{
    const double golden = 0.61803398874989485, ratio = 1.2;
    double best = HUGE_VAL, middle = 0, k = 0.2, c[MOST] = {0}, lo, hi, left, right, at_left, at_right;
    int i;
    for (i = 0; i < SCANS && *status != LOBE_FIT_INTERRUPTED; i++, k *= ratio) {
        const double e = solve(p, k, SEARCH, status, c);
        if (e < best) {
            best = e;
            middle = k;
        }
    }
    lo = middle / ratio;
    hi = middle * ratio;
    left = hi - golden * (hi - lo);
    right = lo + golden * (hi - lo);
    at_left = solve(p, left, SEARCH, status, c);
    at_right = solve(p, right, SEARCH, status, c);
    for (i = 0; i < SECTIONS && *status != LOBE_FIT_INTERRUPTED; i++) {
        if (at_left < at_right) {
            hi = right;
            right = left;
            at_right = at_left;
            left = hi - golden * (hi - lo);
            at_left = solve(p, left, SEARCH, status, c);
        } else {
            lo = left;
            left = right;
            at_left = at_right;
            right = lo + golden * (hi - lo);
            at_right = solve(p, right, SEARCH, status, c);
        }
    }
    return at_left < at_right ? left : right;
}

static void judge(const tier *t, const grid *g, const double *c, lobe_coefficients *out)
{
    double sum = 0;
    size_t r, count = 0;
    out->max = 0;
    for (r = 0; r < g->count; r++) {
        const double error = fabs(t->call(c, g->at[2 * r], g->at[2 * r + 1]) * g->e[r] - 1);
        if (g->weight[r] < 1)
            continue;
        count++;
        sum += error * error;
        if (error > out->max) {
            out->max = error;
            out->at[0] = g->at[2 * r];
            out->at[1] = g->at[2 * r + 1];
        }
    }
    out->rms = sqrt(sum / (double)count);
}

static bool fit_on(problem *p, const grid *coarse, const grid *fine, double *c)
{
    const size_t columns = p->t->count - 1;
    lobe_fit_status status = LOBE_FIT_NO_MEMORY;
    size_t i;
    p->matrix = malloc(columns * fine->count * sizeof *p->matrix);
    p->fixed = malloc(fine->count * sizeof *p->fixed);
    if (p->matrix && p->fixed) {
        p->g = coarse;
        c[0] = lobe_coefficient_rounded(search(p, &status));
        p->g = fine;
        if (status != LOBE_FIT_INTERRUPTED)
            solve(p, c[0], 600, &status, c + 1);
        for (i = 1; i <= columns; i++)
            c[i] = lobe_coefficient_rounded(c[i]);
    }
    lobe_progress_finish(&p->line);
    free(p->matrix);
    free(p->fixed);
    if (status == LOBE_FIT_CONVERGED || status == LOBE_FIT_STALLED)
        return true;
    fprintf(stderr, "lobefit: fit energy %s: %s; the old coefficients stand\n", p->t->name,
            lobe_fit_status_name(status));
    return false;
}

static bool fit_tier(const lobe_case *self, const lobe_fit_request *request, const tier *t)
{
    lobe_coefficients out = {0};
    problem p = {0};
    grid coarse = {0}, fine = {0};
    double c[MOST] = {0};
    bool good = grid_make(&coarse, t->coarse, t, self, request) && grid_make(&fine, FINE, t, self, request);
    p.t = t;
    p.line = lobe_progress_line_default();
    p.line.out = request->sweep.progress ? stderr : NULL;
    if (good && fit_on(&p, &coarse, &fine, c)) {
        out.model = "energy";
        out.tier = t->name;
        out.brdf = self->brdf;
        out.domain = t->domain;
        out.grid = "97 x 97, denser toward the edges, low roughness and grazing views";
        out.metric = "furnace, |E f - 1| with f the polynomial for 1/E";
        out.kernel = t->kernel;
        out.source = "models/energy.h";
        out.values = c;
        out.count = t->count;
        judge(t, &fine, c, &out);
        good = lobe_coefficients_write(&out, request->coeffs);
    } else {
        good = false;
    }
    grid_free(&coarse);
    grid_free(&fine);
    return good;
}

/* low keeps its error down to the truth's own end, .001, at no cost; medium and high would double theirs, or worse. So
 * they are fitted on [.02, 1], and high, which would wander off below, is held there by a little weight. */
static const tier low = {.name = "low",
                         .kernel = "lobe_energy_inverse_low",
                         .domain = "roughness, n_dot_v in [.001, 1]",
                         .call = lobe_energy_inverse_low,
                         .count = 10,
                         .lo = TRUTH_LO,
                         .coarse = 32};
static const tier medium = {.name = "medium",
                            .kernel = "lobe_energy_inverse_medium",
                            .domain = "roughness, n_dot_v in [.02, 1]",
                            .call = lobe_energy_inverse_medium,
                            .count = 29,
                            .lo = 0.02,
                            .coarse = 32};
static const tier high = {.name = "high",
                          .kernel = "lobe_energy_inverse_high",
                          .domain = "roughness, n_dot_v in [.02, 1]; down to .001 an error counts 3 percent",
                          .call = lobe_energy_inverse_high,
                          .count = 65,
                          .lo = 0.02,
                          .below = 0.03,
                          .coarse = 44};

static bool fit_low(const lobe_case *self, const lobe_fit_request *request) { return fit_tier(self, request, &low); }
static bool fit_medium(const lobe_case *self, const lobe_fit_request *request)
{
    return fit_tier(self, request, &medium);
}
static bool fit_high(const lobe_case *self, const lobe_fit_request *request) { return fit_tier(self, request, &high); }

int lobe_energy_fit(const lobe_case *self, int argc, char **argv)
{
    static const lobe_fit_tier tiers[] = {{"low", fit_low}, {"medium", fit_medium}, {"high", fit_high}};
    return lobe_fit_command(self, tiers, (int)(sizeof tiers / sizeof tiers[0]), argc, argv);
}
