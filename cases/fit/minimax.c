#include "minimax.h"
#include "power_norm.h"
#include "triangle.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A row whose weight is below this part of the largest cannot be seen in the factor: most rows, once p is large. */
static const double negligible = 1e-6; /* of the factor, the weight's root */
#define TRIES 14

lobe_minimax_options lobe_minimax_default(void)
{
    lobe_minimax_options o = {0};
    o.p_first = 2;
    o.p_last = 400;
    o.p_growth = 1.5;
    o.steps_per_p = 12;
    o.step_tolerance = 1e-5;
    o.difference = LOBE_DIFFERENCE_FORWARD;
    o.budget = 1000000;
    return o;
}

static const char *check(const lobe_residuals *residuals, const lobe_minimax_options *o, const double *x)
{
    const char *reason = lobe_residuals_check(residuals);
    if (reason)
        return reason;
    if (!x)
        return "no start point";
    if (o->p_first < 2 || o->p_last < o->p_first || o->p_last > 1000000)
        return "the powers must satisfy 2 <= p_first <= p_last <= 1000000";
    if (!(o->p_growth > 1.0))
        return "p must grow: p_growth > 1";
    if (o->steps_per_p < 1 || o->budget < 1)
        return "no steps, or no evaluations, are allowed";
    if (!(o->ridge >= 0.0 && isfinite(o->ridge)) || !(o->step_tolerance >= 0.0) || !(o->target >= 0.0))
        return "the ridge or a tolerance is negative or not a number";
    for (size_t k = 0; o->ridge_weight && k < residuals->dim; k++)
        if (!(o->ridge_weight[k] >= 0.0))
            return "a ridge weight is negative or not a number";
    if (o->difference != LOBE_DIFFERENCE_FORWARD && o->difference != LOBE_DIFFERENCE_CENTRAL)
        return "unknown kind of difference";
    return NULL;
}

typedef struct fit {
    const lobe_residuals *p;
    const lobe_minimax_options *o;
    lobe_difference difference;
    double *x, *tried, *best, *step, *lengths, *gradient, *diagonal; /* dim each */
    double *at_x, *at_tried, *factor;                                /* rows each */
    double *jacobian, *scratch, *block, *spare;
    bool *frozen;
    lobe_triangle t, damped;
    lobe_power_norm norm;
    double rho, damping, best_max;
    lobe_minimax_result out;
} fit;

static double ridge_weight(const fit *f, size_t k) { return f->o->ridge_weight ? f->o->ridge_weight[k] : 1.0; }

/* What is minimised at one p: the squared norm and the ridge. */
static double merit(const fit *f, const lobe_power_norm *norm, const double *x)
{
    double ridge = 0.0;
    for (size_t k = 0; f->rho > 0.0 && k < f->p->dim; k++)
        ridge += ridge_weight(f, k) * x[k] * x[k];
    return norm->norm * norm->norm + f->rho * ridge;
}

/* Factor of the rows sqrt((p-1) g) J | sqrt(g / (p-1)) e, whose normal equations are Newton's for sum |e|^p. */
static void factorise(fit *f, size_t p)
{
    const size_t n = f->p->dim, m = f->p->rows, stride = n + 1;
    const double steep = sqrt((double)(p - 1));
    size_t filled = 0;
    lobe_triangle_clear(&f->t);
    for (size_t r = 0; r < m; r++) {
        if (f->factor[r] > negligible * (f->p->weights ? f->p->weights[r] : 1.0)) {
            double *row = f->block + filled * stride;
            lobe_jacobian_rows(f->p, f->jacobian, f->at_x, f->frozen, f->factor, r, r + 1, row);
            for (size_t k = 0; k < n; k++)
                row[k] *= steep;
            row[n] /= steep;
            filled++;
        }
        if (filled == LOBE_TRIANGLE_BLOCK || (r + 1 == m && filled > 0)) {
            lobe_triangle_add(&f->t, f->block, filled, f->spare);
            filled = 0;
        }
    }
    /* d norm^2 = (norm / max)^2 / sum times the gradient of the rows: the ridge is brought to their scale. */
    const double scale =
        f->norm.max > 0.0 ? f->norm.norm * f->norm.norm / (f->norm.max * f->norm.max * f->norm.sum) : 1.0;
    for (size_t k = 0; f->rho > 0.0 && k < n; k++) {
        const double root = sqrt(f->rho * ridge_weight(f, k) / scale);
        memset(f->block, 0, stride * sizeof *f->block);
        f->block[k] = f->frozen[k] ? 0.0 : root;
        f->block[n] = root * f->x[k];
        lobe_triangle_add(&f->t, f->block, 1, f->spare);
    }
}

static void linearise(fit *f, size_t p)
{
    const size_t n = f->p->dim;
    f->norm = lobe_power_norm_of(f->at_x, f->p->weights, f->p->rows, p, f->factor);
    f->out.fit.evaluations += lobe_jacobian(f->p, f->difference, f->x, f->at_x, f->scratch, f->jacobian);
    memset(f->frozen, 0, n * sizeof *f->frozen);
    factorise(f, p);
    bool any = false;
    if (f->p->lower)
        lobe_triangle_gradient(&f->t, f->gradient);
    for (size_t k = 0; f->p->lower && k < n; k++) {
        f->frozen[k] = (f->x[k] <= f->p->lower[k] && f->gradient[k] >= 0.0) ||
                       (f->x[k] >= f->p->upper[k] && f->gradient[k] <= 0.0);
        any = any || f->frozen[k];
    }
    if (any)
        factorise(f, p);
    lobe_triangle_gradient(&f->t, f->gradient);
    lobe_triangle_column_lengths(&f->t, f->lengths);
}

/* The damped Newton step for the p-norm itself. The Hessian of the norm is that of the sum less a multiple of
 * gradient gradient^T, which by Sherman and Morrison lengthens the step and leaves its direction. */
static bool newton_step(fit *f, size_t p)
{
    const size_t n = f->p->dim;
    for (size_t k = 0; k < n; k++)
        f->diagonal[k] = f->lengths[k] > 0.0 ? sqrt(f->damping) * f->lengths[k] : 1.0;
    lobe_triangle_damp(&f->t, f->diagonal, &f->damped, f->block, f->spare);
    if (!lobe_triangle_solve(&f->damped, f->step))
        return false;
    double descent = 0.0;
    for (size_t k = 0; k < n; k++)
        descent -= f->gradient[k] * f->step[k];
    const double ratio = (double)(p - 2) * descent / (f->norm.max * f->norm.max * f->norm.sum);
    const double longest = (double)(p - 1); /* reached where the rows could all be zero */
    const double lengthen = ratio < 1.0 && 1.0 / (1.0 - ratio) < longest ? 1.0 / (1.0 - ratio) : longest;
    for (size_t k = 0; k < n; k++) {
        f->tried[k] = f->x[k] + lengthen * f->step[k];
        if (!isfinite(f->tried[k]))
            return false;
    }
    lobe_box_clamp(f->p->lower, f->p->upper, n, f->tried);
    return true;
}

static void note_best(fit *f, double max, const double *x)
{
    if (max >= 0.0 && max < f->best_max) {
        f->best_max = max;
        memcpy(f->best, x, f->p->dim * sizeof *x);
    }
}

static bool over(fit *f)
{
    const lobe_progress progress = {"minimax", f->out.fit.evaluations, f->o->budget, f->best_max};
    if (f->best_max <= f->o->target) {
        f->out.fit.status = LOBE_FIT_CONVERGED;
        f->out.fit.reason = f->best_max == 0.0 ? "every residual is zero" : "the target value is reached";
    } else if (f->out.fit.evaluations >= f->o->budget) {
        f->out.fit.status = LOBE_FIT_BUDGET;
        f->out.fit.reason = "the evaluations ran out";
    } else if (f->o->progress && !f->o->progress(f->o->progress_ctx, &progress)) {
        f->out.fit.status = LOBE_FIT_INTERRUPTED;
        f->out.fit.reason = "interrupted";
    } else
        return false;
    return true;
}

typedef enum outcome { OVER, NO_GAIN, SMALL_GAIN, GAIN } outcome;

/* One linearisation, then more damping until the merit falls. */
static outcome advance(fit *f, size_t p)
{
    linearise(f, p);
    f->out.fit.iterations++;
    const double before = merit(f, &f->norm, f->x);
    for (int tries = 0; tries < TRIES; tries++) {
        if (over(f))
            return OVER;
        if (newton_step(f, p)) {
            f->p->f(f->p->ctx, f->tried, 1, f->at_tried);
            f->out.fit.evaluations++;
            const lobe_power_norm norm = lobe_power_norm_of(f->at_tried, f->p->weights, f->p->rows, p, NULL);
            note_best(f, norm.max, f->tried);
            const double after = norm.max >= 0.0 ? merit(f, &norm, f->tried) : HUGE_VAL;
            if (after < before) {
                double *swap = f->at_x;
                f->at_x = f->at_tried;
                f->at_tried = swap;
                memcpy(f->x, f->tried, f->p->dim * sizeof *f->x);
                if (tries == 0)
                    f->damping = fmax(0.1 * f->damping, 1e-16);
                return before - after <= 2.0 * f->o->step_tolerance * before ? SMALL_GAIN : GAIN;
            }
        }
        f->damping = fmax(8.0 * f->damping, 1e-13);
    }
    return NO_GAIN;
}

/* Steps at one p until they stop to gain. Returns false where the fit is over. */
static bool settle(fit *f, size_t p)
{
    f->rho = f->o->ridge * f->norm.max * f->norm.max;
    for (size_t step = 0; step < f->o->steps_per_p; step++) {
        const outcome result = advance(f, p);
        if (result == OVER)
            return false;
        if (result == NO_GAIN) {
            f->damping = 1e-6;
            if (f->difference == LOBE_DIFFERENCE_CENTRAL || f->p->jacobian)
                return true;
            f->difference = LOBE_DIFFERENCE_CENTRAL;
        }
        if (result == SMALL_GAIN)
            return true;
    }
    return true;
}

static double *allocate(fit *f)
{
    const size_t n = f->p->dim, m = f->p->rows, stride = n + 1;
    /* The block also takes the n rows of the damping. */
    const size_t block = (n > LOBE_TRIANGLE_BLOCK ? n : LOBE_TRIANGLE_BLOCK) * stride;
    const size_t total = 7 * n + 3 * m + n * m + lobe_jacobian_scratch(f->p) + block + stride + 2 * n * stride;
    double *memory = calloc(total, sizeof *memory), *q = memory;
    f->frozen = calloc(n, sizeof *f->frozen);
    if (!memory || !f->frozen) {
        free(memory);
        free(f->frozen);
        return NULL;
    }
    double **vectors[] = {&f->x, &f->tried, &f->best, &f->step, &f->lengths, &f->gradient, &f->diagonal};
    for (size_t i = 0; i < sizeof vectors / sizeof *vectors; i++, q += n)
        *vectors[i] = q;
    f->at_x = q;
    f->at_tried = f->at_x + m;
    f->factor = f->at_tried + m;
    f->jacobian = f->factor + m;
    f->scratch = f->jacobian + n * m;
    f->block = f->scratch + lobe_jacobian_scratch(f->p);
    f->spare = f->block + block;
    f->t.dim = f->damped.dim = n;
    f->t.r = f->spare + stride;
    f->damped.r = f->t.r + n * stride;
    return memory;
}

/* Loads x and its residuals; false where they are not finite. */
static bool start(fit *f, const double *x)
{
    memcpy(f->x, x, f->p->dim * sizeof *x);
    lobe_box_clamp(f->p->lower, f->p->upper, f->p->dim, f->x);
    f->p->f(f->p->ctx, f->x, 1, f->at_x);
    f->out.fit.evaluations++;
    f->norm = lobe_power_norm_of(f->at_x, f->p->weights, f->p->rows, 2, NULL);
    f->best_max = HUGE_VAL;
    note_best(f, f->norm.max, f->x);
    return f->norm.max >= 0.0;
}

lobe_minimax_result lobe_minimax(const lobe_residuals *residuals, const lobe_minimax_options *options, double *x)
{
    const lobe_minimax_options o = options ? *options : lobe_minimax_default();
    const char *reason = check(residuals, &o, x);
    fit f = {0};
    f.p = residuals;
    f.o = &o;
    f.difference = o.difference;
    f.damping = 1e-6;
    f.out.fit = lobe_fit_refused(reason);
    if (reason)
        return f.out;
    double *memory = allocate(&f);
    if (!memory) {
        f.out.fit = lobe_fit_no_memory();
        return f.out;
    }
    if (!start(&f, x)) {
        f.out.fit.reason = "the residuals of the start point are not finite";
    } else {
        f.out.fit.status = LOBE_FIT_CONVERGED;
        f.out.fit.reason = "the last p is reached";
        bool going = !over(&f);
        for (size_t p = o.p_first; going;) {
            going = settle(&f, p) && p < o.p_last;
            const double grown = ceil((double)p * o.p_growth);
            p = grown < (double)o.p_last ? (size_t)grown : o.p_last;
        }
        f.p->f(f.p->ctx, f.best, 1, f.at_tried);
        f.out.fit.evaluations++;
        f.norm = lobe_power_norm_of(f.at_tried, f.p->weights, f.p->rows, 2, NULL);
        f.out.fit.value = f.norm.max;
        f.out.worst_row = f.norm.row;
        f.out.rms = f.norm.norm / sqrt((double)f.p->rows);
        memcpy(x, f.best, residuals->dim * sizeof *x);
    }
    free(f.frozen);
    free(memory);
    return f.out;
}

const char *lobe_minimax_prices(const lobe_residuals *residuals, size_t p, const double *x, double *prices)
{
    lobe_minimax_options o = lobe_minimax_default();
    o.p_first = p;
    o.p_last = p > o.p_last ? p : o.p_last;
    const char *reason = check(residuals, &o, x);
    if (reason)
        return reason;
    fit f = {0};
    f.p = residuals;
    f.o = &o;
    double *memory = allocate(&f);
    if (!memory)
        return "out of memory";
    const size_t n = residuals->dim;
    if (start(&f, x)) {
        linearise(&f, p);
        for (size_t k = 0; k < n; k++) /* a hair of damping, so that a dead parameter has a price: nothing */
            f.diagonal[k] = f.lengths[k] > 0.0 ? 1e-8 * f.lengths[k] : 1.0;
        lobe_triangle_damp(&f.t, f.diagonal, &f.damped, f.block, f.spare);
        for (size_t k = 0; k < n; k++) {
            /* (R^T R)^-1 at (k, k) is |R^-T unit_k|^2. */
            double inverse = 0.0;
            memset(f.step, 0, n * sizeof *f.step);
            f.step[k] = 1.0;
            for (size_t i = k; i < n; i++) {
                f.step[i] /= f.damped.r[i * (n + 1) + i];
                inverse += f.step[i] * f.step[i];
                for (size_t j = i + 1; j < n; j++)
                    f.step[j] -= f.damped.r[i * (n + 1) + j] * f.step[i];
            }
            prices[k] = 0.5 * f.x[k] * f.x[k] / inverse;
        }
    } else
        reason = "the residuals of the start point are not finite";
    free(f.frozen);
    free(memory);
    return reason;
}
