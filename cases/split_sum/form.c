#define LOBE_DOUBLE 1
#include "form.h"
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "../fit/coefficients.h"
#include "../fit/minimax.h"
#include "../fit/progress.h"
#include "../fit/random.h"

enum { KEEP = 3 };

static const double bends0[] = {0.35, 0.6, 0.85, 1.2, 1.8, 2.2, 2.8, 3.4};
static const double bends1[] = {0, 1.5, -0.3, 3.5};
enum { BENDS0 = sizeof bends0 / sizeof bends0[0], BENDS1 = sizeof bends1 / sizeof bends1[0] };

typedef struct problem {
    const lobe_form *f;
    const lobe_fit_grid *g;
    lobe_progress_line line;
} problem;

void lobe_form_errors(const lobe_form *f, const double *c, const lobe_fit_grid *g, size_t row,
                      double errors[LOBE_FORM_CHANNELS])
{
    const double *truth = g->truth + 2 * row;
    const lobe_dfg d = f->call(c, g->at[2 * row], g->at[2 * row + 1]);
    errors[0] = d.scale - truth[0];
    errors[1] = d.bias - truth[1];
    errors[2] = errors[0] + errors[1];
}

static void residuals(void *ctx, const double *params, size_t count, double *values)
{
    const problem *p = ctx;
    size_t i, r;
    for (i = 0; i < count; i++) {
        for (r = 0; r < p->g->count; r++, values += LOBE_FORM_CHANNELS)
            lobe_form_errors(p->f, params + i * p->f->count, p->g, r, values);
    }
}

static lobe_minimax_result solve(problem *p, const lobe_fit_grid *g, int polish, double *x)
{
    lobe_residuals r = {0};
    lobe_minimax_options o = lobe_minimax_default();
    p->g = g;
    r.f = residuals;
    r.ctx = p;
    r.dim = p->f->count;
    r.rows = LOBE_FORM_CHANNELS * g->count;
    o.ridge = p->f->ridge;
    o.progress = lobe_progress_print;
    o.progress_ctx = &p->line;
    if (polish) {
        o.p_first = 8;
        o.steps_per_p = 40;
        o.step_tolerance = 1e-6;
    } else {
        o.p_last = 100;
        o.p_growth = 1.7;
    }
    return lobe_minimax(&r, &o, x);
}

static size_t start_count(const lobe_form *f)
{
    if (f->starts)
        return f->starts;
    return f->bends > 1 ? BENDS0 * BENDS1 : BENDS0;
}

static void start(const lobe_form *f, size_t i, uint64_t seed, double *x)
{
    size_t k;
    memset(x, 0, f->count * sizeof *x);
    if (f->starts) {
        lobe_random random;
        lobe_random_seed(&random, seed, i);
        for (k = 0; k < f->count; k++)
            x[k] = 3 * lobe_random_unit(&random) - 1.5;
        return;
    }
    x[0] = bends0[i % BENDS0];
    if (f->bends > 1)
        x[1] = bends1[i / BENDS0];
    x[f->bends] = f->first_of_e;
    x[f->constant_of_u] = 1;
}

/* The best KEEP ends of all starts, in order. Returns how many; 0 where it was interrupted. */
static size_t scan(problem *p, const lobe_fit_grid *g, uint64_t seed, double best[KEEP][LOBE_FORM_COEFFICIENTS])
{
    double value[KEEP], x[LOBE_FORM_COEFFICIENTS];
    size_t i, kept = 0;
    for (i = 0; i < start_count(p->f); i++) {
        lobe_minimax_result r;
        size_t at;
        start(p->f, i, seed, x);
        r = solve(p, g, 0, x);
        if (r.fit.status == LOBE_FIT_INTERRUPTED)
            return 0;
        if (!(r.fit.value >= 0) || (kept == KEEP && r.fit.value >= value[KEEP - 1]))
            continue;
        at = kept < KEEP ? kept++ : KEEP - 1;
        for (; at > 0 && value[at - 1] > r.fit.value; at--) {
            value[at] = value[at - 1];
            memcpy(best[at], best[at - 1], sizeof best[at]);
        }
        value[at] = r.fit.value;
        memcpy(best[at], x, sizeof x);
    }
    return kept;
}

bool lobe_form_solve(const lobe_form *f, const lobe_fit_grid *coarse, const lobe_fit_grid *fine, uint64_t seed,
                     bool progress, double *c)
{
    static double best[KEEP][LOBE_FORM_COEFFICIENTS];
    double value = HUGE_VAL;
    problem p = {0};
    size_t kept, i, k;
    p.f = f;
    p.line = lobe_progress_line_default();
    p.line.out = progress ? stderr : NULL;
    kept = scan(&p, coarse, seed, best);
    for (i = 0; i < kept; i++) {
        const lobe_minimax_result r = solve(&p, fine, 1, best[i]);
        if (r.fit.status == LOBE_FIT_INTERRUPTED)
            break;
        if (r.fit.value >= 0 && r.fit.value < value) {
            value = r.fit.value;
            memcpy(c, best[i], f->count * sizeof *c);
        }
    }
    lobe_progress_finish(&p.line);
    if (!kept || i < kept || value == HUGE_VAL) {
        fprintf(stderr, "lobefit: fit %s: interrupted; the old coefficients stand\n", f->kernel);
        return false;
    }
    for (k = 0; k < f->count; k++)
        c[k] = lobe_coefficient_rounded(c[k]);
    return true;
}
