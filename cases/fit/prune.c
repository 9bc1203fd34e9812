#include "prune.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

lobe_prune_options lobe_prune_default(void)
{
    lobe_prune_options o = {0};
    o.refit = lobe_minimax_default();
    o.refit.p_first = 8;
    o.refit.p_growth = 2.0;
    o.refit.p_last = 200;
    o.candidates = 4;
    o.price_p = 8;
    o.keep = 1;
    o.limit = HUGE_VAL;
    return o;
}

/* The problem in the terms that are left. */
typedef struct reduced {
    const lobe_residuals *full;
    const bool *gone;
    double *expanded; /* chunk x full->dim */
    double *full_jacobian, *lower, *upper, *ridge;
    size_t *index; /* of each term left */
    size_t left;
} reduced;

#define CHUNK 16

static void expand(const reduced *r, const double *x, double *out)
{
    memset(out, 0, r->full->dim * sizeof *out);
    for (size_t i = 0; i < r->left; i++)
        out[r->index[i]] = x[i];
}

static void residuals_of(void *ctx, const double *params, size_t count, double *values)
{
    const reduced *r = ctx;
    for (size_t first = 0; first < count; first += CHUNK) {
        const size_t part = count - first < CHUNK ? count - first : CHUNK;
        for (size_t i = 0; i < part; i++)
            expand(r, params + (first + i) * r->left, r->expanded + i * r->full->dim);
        r->full->f(r->full->ctx, r->expanded, part, values + first * r->full->rows);
    }
}

static void jacobian_of(void *ctx, const double *params, double *transposed)
{
    const reduced *r = ctx;
    const size_t rows = r->full->rows;
    expand(r, params, r->expanded);
    r->full->jacobian(r->full->ctx, r->expanded, r->full_jacobian);
    for (size_t i = 0; i < r->left; i++)
        memcpy(transposed + i * rows, r->full_jacobian + r->index[i] * rows, rows * sizeof *transposed);
}

/* Reads r->gone anew. */
static lobe_residuals reduce(reduced *r, const double *ridge_weight)
{
    const lobe_residuals *full = r->full;
    r->left = 0;
    for (size_t k = 0; k < full->dim; k++) {
        if (r->gone[k])
            continue;
        if (full->lower) {
            r->lower[r->left] = full->lower[k];
            r->upper[r->left] = full->upper[k];
        }
        r->ridge[r->left] = ridge_weight ? ridge_weight[k] : 1.0;
        r->index[r->left++] = k;
    }
    lobe_residuals p = *full;
    p.f = residuals_of;
    p.jacobian = full->jacobian ? jacobian_of : NULL;
    p.ctx = r;
    p.dim = r->left;
    p.lower = full->lower ? r->lower : NULL;
    p.upper = full->lower ? r->upper : NULL;
    return p;
}

static const char *check(const lobe_residuals *p, const lobe_prune_options *o)
{
    const char *reason = lobe_residuals_check(p);
    if (reason)
        return reason;
    if (o->keep < 1 || o->keep > p->dim)
        return "the number of terms to keep must be in 1 .. dim";
    if (o->price_p < 2 || o->price_p > 1000)
        return "price_p must be in 2 .. 1000";
    if (isnan(o->limit))
        return "the limit is not a number";
    for (size_t k = 0; p->lower && k < p->dim; k++)
        if (!(o->fixed && o->fixed[k]) && !(p->lower[k] <= 0.0 && p->upper[k] >= 0.0))
            return "0 is outside the bounds of a term that may go";
    return NULL;
}

typedef struct pruning {
    reduced r;
    const lobe_prune_options *o;
    bool *gone;
    double *x, *trial, *best, *price; /* dim each; x is reduced to what is left */
    lobe_fit_result result;
} pruning;

/* Refits without one more term, starting at the others as they are; the fit is in s->trial. */
static lobe_fit_result refit_without(pruning *s, const double *full_x, size_t term)
{
    s->gone[term] = true;
    const lobe_residuals p = reduce(&s->r, s->o->refit.ridge_weight);
    lobe_minimax_options o = s->o->refit;
    o.ridge_weight = s->r.ridge;
    for (size_t i = 0; i < s->r.left; i++)
        s->trial[i] = full_x[s->r.index[i]];
    const lobe_fit_result r = lobe_minimax(&p, &o, s->trial).fit;
    s->result.evaluations += r.evaluations;
    s->result.iterations++;
    s->gone[term] = false;
    return r;
}

/* Predicted prices of the terms left; those gone or fixed cost infinity. */
static const char *predict(pruning *s, const double *full_x)
{
    const lobe_residuals p = reduce(&s->r, NULL);
    for (size_t i = 0; i < s->r.left; i++)
        s->x[i] = full_x[s->r.index[i]];
    const char *reason = lobe_minimax_prices(&p, s->o->price_p, s->x, s->trial);
    for (size_t k = 0; k < s->r.full->dim; k++)
        s->price[k] = HUGE_VAL;
    for (size_t i = 0; !reason && i < s->r.left; i++)
        if (!s->o->fixed || !s->o->fixed[s->r.index[i]])
            s->price[s->r.index[i]] = isfinite(s->trial[i]) ? s->trial[i] : 1e300;
    return reason;
}

/* Tries the cheapest terms and makes the best removal in full_x. False: the pruning is over. */
static bool remove_one(pruning *s, double *full_x, lobe_prune_step *step)
{
    const size_t n = s->r.full->dim;
    const char *reason = predict(s, full_x);
    if (reason) {
        s->result.status = LOBE_FIT_BAD_INPUT;
        s->result.reason = reason;
        return false;
    }
    step->error = HUGE_VAL;
    for (size_t tried = 0; s->o->candidates == 0 || tried < s->o->candidates; tried++) {
        size_t term = 0;
        for (size_t k = 1; k < n; k++)
            if (s->price[k] < s->price[term])
                term = k;
        if (!(s->price[term] < HUGE_VAL))
            break;
        s->price[term] = HUGE_VAL;
        const lobe_fit_result r = refit_without(s, full_x, term);
        if (r.status == LOBE_FIT_INTERRUPTED || r.status == LOBE_FIT_NO_MEMORY) {
            s->result.status = r.status;
            s->result.reason = r.reason;
            return false;
        }
        if (r.status != LOBE_FIT_BAD_INPUT && r.value < step->error) {
            step->term = term;
            step->error = r.value;
            memset(s->best, 0, n * sizeof *s->best);
            for (size_t i = 0, k = 0; k < n; k++)
                if (!s->gone[k] && k != term)
                    s->best[k] = s->trial[i++];
        }
    }
    if (!(step->error < HUGE_VAL)) {
        s->result.reason = "no further term can go";
        return false;
    }
    if (step->error > s->o->limit) {
        s->result.reason = "the next removal would exceed the limit";
        return false;
    }
    s->gone[step->term] = true;
    s->result.value = step->error;
    memcpy(full_x, s->best, n * sizeof *full_x);
    return true;
}

lobe_fit_result lobe_prune(const lobe_residuals *residuals, const lobe_prune_options *options, double *x, bool *removed,
                           lobe_prune_step *steps, size_t *count)
{
    const lobe_prune_options o = options ? *options : lobe_prune_default();
    const char *reason = !x || !removed || !steps || !count ? "no place for the result" : check(residuals, &o);
    if (reason)
        return lobe_fit_refused(reason);
    const size_t n = residuals->dim, jacobian = residuals->jacobian ? n * residuals->rows : 0;
    double *memory = calloc((CHUNK + 7) * n + jacobian, sizeof *memory);
    size_t *index = calloc(n, sizeof *index);
    if (!memory || !index) {
        free(memory);
        free(index);
        return lobe_fit_no_memory();
    }
    pruning s = {{residuals, removed, memory, memory + (CHUNK + 7) * n, NULL, NULL, NULL, index, 0},
                 &o,
                 removed,
                 NULL,
                 NULL,
                 NULL,
                 NULL,
                 {LOBE_FIT_CONVERGED, "keep terms are left", 0.0, 0, 0}};
    double **vectors[] = {&s.r.lower, &s.r.upper, &s.r.ridge, &s.x, &s.trial, &s.best, &s.price};
    for (size_t i = 0; i < sizeof vectors / sizeof *vectors; i++)
        *vectors[i] = memory + (CHUNK + i) * n;
    memset(removed, 0, n * sizeof *removed);
    *count = 0;
    for (size_t left = n; left > o.keep; left--) {
        if (!remove_one(&s, x, &steps[*count]))
            break;
        ++*count;
    }
    free(index);
    free(memory);
    return s.result;
}
