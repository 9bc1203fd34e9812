#include "least_squares.h"
#include "trust_region.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

lobe_ls_options lobe_ls_default(void)
{
    lobe_ls_options o = {0};
    o.value_tolerance = 1e-14;
    o.step_tolerance = 1e-13;
    o.gradient_tolerance = 0.0;
    o.first_step = 100.0;
    o.difference = LOBE_DIFFERENCE_FORWARD;
    o.budget = 100000;
    return o;
}

static const char *check(const lobe_residuals *residuals, const lobe_ls_options *o, const double *x)
{
    const char *reason = lobe_residuals_check(residuals);
    if (reason)
        return reason;
    if (!x)
        return "no start point";
    if (!(o->value_tolerance >= 0.0) || !(o->step_tolerance >= 0.0) || !(o->gradient_tolerance >= 0.0))
        return "a tolerance is negative or not a number";
    if (!(o->first_step > 0.0 && isfinite(o->first_step)))
        return "the first step must be positive";
    if (!(o->ridge >= 0.0 && isfinite(o->ridge)))
        return "the ridge must be at least 0";
    if (o->difference != LOBE_DIFFERENCE_FORWARD && o->difference != LOBE_DIFFERENCE_CENTRAL)
        return "unknown kind of difference";
    if (o->budget < 1)
        return "the budget is zero";
    return NULL;
}

typedef struct solver {
    const lobe_residuals *p;
    const lobe_ls_options *o;
    lobe_difference difference;
    lobe_triangle t;
    double *x, *tried, *step, *scale, *lengths, *gradient; /* dim each */
    double *at_x, *at_tried;                               /* rows each */
    double *jacobian, *jacobian_scratch, *trust_scratch, *block, *spare;
    bool *frozen;
    double value, radius, damping;
    lobe_fit_result result;
} solver;

static double sum_of_squares(const solver *s, const double *x, const double *residual)
{
    double sum = 0.0, ridge = 0.0;
    for (size_t r = 0; r < s->p->rows; r++) {
        const double e = s->p->weights ? s->p->weights[r] * residual[r] : residual[r];
        sum += e * e;
    }
    for (size_t k = 0; k < s->p->dim; k++)
        ridge += x[k] * x[k];
    return sum + s->o->ridge * ridge;
}

static void factorise(solver *s)
{
    const size_t n = s->p->dim;
    lobe_triangle_clear(&s->t);
    for (size_t first = 0; first < s->p->rows; first += LOBE_TRIANGLE_BLOCK) {
        const size_t end = first + LOBE_TRIANGLE_BLOCK < s->p->rows ? first + LOBE_TRIANGLE_BLOCK : s->p->rows;
        lobe_jacobian_rows(s->p, s->jacobian, s->at_x, s->frozen, NULL, first, end, s->block);
        lobe_triangle_add(&s->t, s->block, end - first, s->spare);
    }
    if (s->o->ridge > 0.0) {
        const double root = sqrt(s->o->ridge);
        for (size_t k = 0; k < n; k++) {
            memset(s->block, 0, (n + 1) * sizeof *s->block);
            s->block[k] = s->frozen[k] ? 0.0 : root;
            s->block[n] = root * s->x[k];
            lobe_triangle_add(&s->t, s->block, 1, s->spare);
        }
    }
}

/* Derivatives at x and their factor. A parameter on a bound whose descent points outwards is frozen. */
static void linearise(solver *s)
{
    const size_t n = s->p->dim;
    s->result.evaluations += lobe_jacobian(s->p, s->difference, s->x, s->at_x, s->jacobian_scratch, s->jacobian);
    memset(s->frozen, 0, n * sizeof *s->frozen);
    factorise(s);
    lobe_triangle_gradient(&s->t, s->gradient);
    lobe_triangle_column_lengths(&s->t, s->lengths);
    bool any = false;
    for (size_t k = 0; s->p->lower && k < n; k++) {
        s->frozen[k] = (s->x[k] <= s->p->lower[k] && s->gradient[k] >= 0.0) ||
                       (s->x[k] >= s->p->upper[k] && s->gradient[k] <= 0.0);
        any = any || s->frozen[k];
    }
    if (any) {
        factorise(s);
        lobe_triangle_gradient(&s->t, s->gradient);
    }
    for (size_t k = 0; k < n; k++) {
        if (s->lengths[k] > s->scale[k])
            s->scale[k] = s->lengths[k];
        if (!(s->scale[k] > 0.0))
            s->scale[k] = 1.0;
    }
}

static double scaled_length(const solver *s, const double *x)
{
    double sum = 0.0;
    for (size_t k = 0; k < s->p->dim; k++)
        sum += s->scale[k] * x[k] * s->scale[k] * x[k];
    return sqrt(sum);
}

static bool stop(solver *s, lobe_fit_status status, const char *reason)
{
    s->result.status = status;
    s->result.reason = reason;
    return true;
}

static bool gradient_is_small(const solver *s)
{
    double largest = 0.0;
    for (size_t k = 0; k < s->p->dim; k++)
        if (s->lengths[k] > 0.0)
            largest = fmax(largest, fabs(s->gradient[k]) / s->lengths[k]);
    return largest <= s->o->gradient_tolerance * sqrt(s->value);
}

/* Steps from one linearisation until one is taken. Returns true where the fit is over. */
static bool advance(solver *s)
{
    const size_t n = s->p->dim;
    for (;;) {
        if (s->result.evaluations >= s->o->budget)
            return stop(s, LOBE_FIT_BUDGET, "the evaluations ran out");
        const lobe_progress progress = {"least squares", s->result.evaluations, s->o->budget, s->value};
        if (s->o->progress && !s->o->progress(s->o->progress_ctx, &progress))
            return stop(s, LOBE_FIT_INTERRUPTED, "interrupted");
        lobe_trust_step(&s->t, s->scale, s->radius, &s->damping, s->trust_scratch, s->step);
        for (size_t k = 0; k < n; k++)
            s->tried[k] = s->x[k] + s->step[k];
        lobe_box_clamp(s->p->lower, s->p->upper, n, s->tried);
        for (size_t k = 0; k < n; k++)
            s->step[k] = s->tried[k] - s->x[k];
        const double length = scaled_length(s, s->step);
        if (s->result.iterations == 1)
            s->radius = fmin(s->radius, length);
        s->p->f(s->p->ctx, s->tried, 1, s->at_tried);
        s->result.evaluations++;
        const double value = sum_of_squares(s, s->tried, s->at_tried);
        const double gain = isfinite(value) ? s->value - value : -HUGE_VAL;
        const double expected = -lobe_triangle_change(&s->t, s->step);
        const double ratio = expected > 0.0 ? gain / expected : 0.0;
        if (ratio <= 0.25) {
            /* The minimum of the parabola through value, slope and new value, kept within [0.1, 0.5]. */
            double slope = 0.0, shrink = 0.5;
            for (size_t k = 0; k < n; k++)
                slope += 2.0 * s->gradient[k] * s->step[k];
            if (gain < 0.0)
                shrink = isfinite(gain) ? 0.5 * slope / (slope + gain) : 0.1;
            shrink = shrink > 0.1 ? fmin(shrink, 0.5) : 0.1;
            s->radius = shrink * fmin(s->radius, 10.0 * length);
            s->damping /= shrink;
        } else if (ratio >= 0.75 || s->damping == 0.0) {
            s->radius = fmax(s->radius, 2.0 * length);
            s->damping *= 0.5;
        }
        const double before = s->value;
        const bool taken = ratio >= 1e-4 && gain > 0.0;
        if (taken) {
            double *swap = s->at_x;
            s->at_x = s->at_tried;
            s->at_tried = swap;
            memcpy(s->x, s->tried, n * sizeof *s->x);
            s->value = value;
        }
        if (s->value == 0.0)
            return stop(s, LOBE_FIT_CONVERGED, "every residual is zero");
        const bool flat =
            fabs(gain) <= s->o->value_tolerance * before && expected <= s->o->value_tolerance * before && ratio <= 2.0;
        const bool small = s->radius <= s->o->step_tolerance * scaled_length(s, s->x) || length == 0.0;
        if ((flat || small) && s->difference == LOBE_DIFFERENCE_FORWARD && !s->p->jacobian && !taken && !flat) {
            s->difference = LOBE_DIFFERENCE_CENTRAL; /* the forward differences are at their end, not the fit */
            s->radius = fmax(s->radius, 1e-3 * scaled_length(s, s->x));
            return false;
        }
        if (flat)
            return stop(s, LOBE_FIT_CONVERGED, "a step gains less than value_tolerance");
        if (small)
            return stop(s, LOBE_FIT_CONVERGED, "the trust region is smaller than step_tolerance");
        if (taken)
            return false;
        if (s->radius <= 1e-300)
            return stop(s, LOBE_FIT_STALLED, "no step gains anything");
    }
}

static double *allocate(solver *s)
{
    const size_t n = s->p->dim, m = s->p->rows, stride = n + 1;
    const size_t block = (m < LOBE_TRIANGLE_BLOCK ? m : LOBE_TRIANGLE_BLOCK) * stride;
    const size_t total =
        n * stride + 6 * n + 2 * m + n * m + lobe_jacobian_scratch(s->p) + lobe_trust_scratch(n) + block + stride;
    double *memory = calloc(total, sizeof *memory), *q = memory;
    s->frozen = calloc(n, sizeof *s->frozen);
    if (!memory || !s->frozen) {
        free(memory);
        free(s->frozen);
        return NULL;
    }
    double **vectors[] = {&s->x, &s->tried, &s->step, &s->scale, &s->lengths, &s->gradient};
    for (size_t i = 0; i < sizeof vectors / sizeof *vectors; i++, q += n)
        *vectors[i] = q;
    s->t.dim = n;
    s->t.r = q;
    s->at_x = s->t.r + n * stride;
    s->at_tried = s->at_x + m;
    s->jacobian = s->at_tried + m;
    s->jacobian_scratch = s->jacobian + n * m;
    s->trust_scratch = s->jacobian_scratch + lobe_jacobian_scratch(s->p);
    s->block = s->trust_scratch + lobe_trust_scratch(n);
    s->spare = s->block + block;
    return memory;
}

lobe_fit_result lobe_least_squares(const lobe_residuals *residuals, const lobe_ls_options *options, double *x)
{
    const lobe_ls_options o = options ? *options : lobe_ls_default();
    const char *reason = check(residuals, &o, x);
    if (reason)
        return lobe_fit_refused(reason);
    solver s = {0};
    s.p = residuals;
    s.o = &o;
    s.difference = o.difference;
    s.result.reason = "";
    double *memory = allocate(&s);
    if (!memory)
        return lobe_fit_no_memory();
    memcpy(s.x, x, residuals->dim * sizeof *x);
    lobe_box_clamp(residuals->lower, residuals->upper, residuals->dim, s.x);
    residuals->f(residuals->ctx, s.x, 1, s.at_x);
    s.result.evaluations = 1;
    s.value = sum_of_squares(&s, s.x, s.at_x);
    if (!isfinite(s.value)) {
        s.result = lobe_fit_refused("the residuals of the start point are not finite");
    } else {
        bool over = s.value == 0.0 && stop(&s, LOBE_FIT_CONVERGED, "every residual is zero");
        while (!over) {
            linearise(&s);
            if (++s.result.iterations == 1) {
                const double length = scaled_length(&s, s.x);
                s.radius = o.first_step * (length > 0.0 ? length : 1.0);
            }
            over = gradient_is_small(&s) ? stop(&s, LOBE_FIT_CONVERGED, "the gradient is zero") : advance(&s);
        }
        s.result.value = s.value;
        memcpy(x, s.x, residuals->dim * sizeof *x);
    }
    free(s.frozen);
    free(memory);
    return s.result;
}
