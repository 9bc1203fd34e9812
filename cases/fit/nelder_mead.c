#include "nelder_mead.h"
#include "random.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

lobe_nm_options lobe_nm_default(void)
{
    lobe_nm_options o = {0};
    o.size = 0.05;
    o.starts = 1;
    o.restarts = 10;
    o.value_tolerance = 1e-12;
    o.size_tolerance = 1e-8;
    o.target = -HUGE_VAL;
    o.seed = 1;
    o.budget = 100000;
    return o;
}

typedef struct search {
    const lobe_objective *objective;
    const lobe_nm_options *o;
    size_t n;
    double *scale;           /* one unit of every parameter */
    double *simplex, *value; /* n + 1 vertices */
    double *centre, *trial, *trial2;
    lobe_fit_result result;
    bool over; /* the whole search, not this run alone */
} search;

static const char *check(const lobe_objective *objective, const lobe_nm_options *o)
{
    const char *reason = lobe_objective_check(objective, o->starts > 1);
    if (reason)
        return reason;
    if (!(o->size > 0.0 && o->size <= 1.0))
        return "the size must be in (0, 1]";
    if (o->starts < 1)
        return "at least one start is needed";
    if (o->budget / o->starts < objective->dim + 2)
        return "the budget is smaller than dim + 2 evaluations a start";
    if (!(o->value_tolerance >= 0.0) || !(o->size_tolerance >= 0.0) || isnan(o->target))
        return "a tolerance is negative or not a number";
    return NULL;
}

static size_t budget_left(const search *s)
{
    return s->o->budget > s->result.evaluations ? s->o->budget - s->result.evaluations : 0;
}

static void evaluate(search *s, const double *points, size_t count, double *values)
{
    lobe_objective_eval(s->objective, points, count, values);
    s->result.evaluations += count;
}

/* Stops the search at its target, budget or interruption. */
static bool must_stop(search *s, double best)
{
    const lobe_progress progress = {"Nelder-Mead", s->result.evaluations, s->o->budget, best};
    if (best <= s->o->target) {
        s->result.status = LOBE_FIT_CONVERGED;
        s->result.reason = "the target value is reached";
    } else if (budget_left(s) < s->n + 2) {
        s->result.status = LOBE_FIT_BUDGET;
        s->result.reason = "the evaluations ran out";
    } else if (s->o->progress && !s->o->progress(s->o->progress_ctx, &progress)) {
        s->result.status = LOBE_FIT_INTERRUPTED;
        s->result.reason = "interrupted";
    } else
        return false;
    return s->over = true;
}

/* Insertion keeps equal values in their order, which makes the path reproducible. */
static void sort_vertices(search *s)
{
    const size_t n = s->n;
    for (size_t i = 1; i <= n; i++) {
        const double value = s->value[i];
        size_t j = i;
        memcpy(s->trial, s->simplex + i * n, n * sizeof(double));
        for (; j > 0 && s->value[j - 1] > value; j--) {
            s->value[j] = s->value[j - 1];
            memcpy(s->simplex + j * n, s->simplex + (j - 1) * n, n * sizeof(double));
        }
        s->value[j] = value;
        memcpy(s->simplex + j * n, s->trial, n * sizeof(double));
    }
}

/* point = centre + t (worst - centre), inside the box. */
static double try_along(search *s, double t, double *point)
{
    const double *worst = s->simplex + s->n * s->n;
    double value;
    for (size_t k = 0; k < s->n; k++)
        point[k] = s->centre[k] + t * (worst[k] - s->centre[k]);
    lobe_box_clamp(s->objective->lower, s->objective->upper, s->n, point);
    evaluate(s, point, 1, &value);
    return value;
}

static void replace_worst(search *s, const double *point, double value)
{
    memcpy(s->simplex + s->n * s->n, point, s->n * sizeof(double));
    s->value[s->n] = value;
}

/* One step on a sorted simplex. */
static void step(search *s)
{
    const size_t n = s->n;
    const double d = n < 2 ? 2.0 : (double)n, expand = 1.0 + 2.0 / d, contract = 0.75 - 0.5 / d, shrink = 1.0 - 1.0 / d;
    memset(s->centre, 0, n * sizeof(double));
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++)
            s->centre[k] += s->simplex[i * n + k] / (double)n;
    const double reflected = try_along(s, -1.0, s->trial);
    if (reflected < s->value[0]) {
        const double expanded = try_along(s, -expand, s->trial2);
        const bool better = expanded < reflected;
        replace_worst(s, better ? s->trial2 : s->trial, better ? expanded : reflected);
        return;
    }
    if (reflected < s->value[n - 1]) {
        replace_worst(s, s->trial, reflected);
        return;
    }
    const bool outside = reflected < s->value[n];
    const double contracted = try_along(s, outside ? -contract : contract, s->trial2);
    if (outside ? contracted <= reflected : contracted < s->value[n]) {
        replace_worst(s, s->trial2, contracted);
        return;
    }
    for (size_t i = 1; i <= n; i++)
        for (size_t k = 0; k < n; k++)
            s->simplex[i * n + k] = s->simplex[k] + shrink * (s->simplex[i * n + k] - s->simplex[k]);
    evaluate(s, s->simplex + n, n, s->value + 1);
}

static bool run_converged(const search *s)
{
    const size_t n = s->n;
    const double spread = s->value[n] - s->value[0];
    if (!(spread <= s->o->value_tolerance * fabs(s->value[0]) + 1e-300))
        return false;
    for (size_t i = 1; i <= n; i++)
        for (size_t k = 0; k < n; k++)
            if (fabs(s->simplex[i * n + k] - s->simplex[k]) > s->o->size_tolerance * s->scale[k])
                return false;
    return true;
}

/* A simplex so small that its vertices round to one another cannot move on. */
static bool run_collapsed(const search *s)
{
    const size_t n = s->n;
    for (size_t i = 1; i <= n; i++)
        for (size_t k = 0; k < n; k++)
            if (fabs(s->simplex[i * n + k] - s->simplex[k]) > 1e-15 * (s->scale[k] + fabs(s->simplex[k])))
                return false;
    return true;
}

/* Builds edges of the given part of the scale around the first vertex, or repairs those that stand. */
static bool build_simplex(search *s, double size, const double *given)
{
    const size_t n = s->n;
    if (given)
        memcpy(s->simplex, given, (n + 1) * n * sizeof(double));
    else
        for (size_t i = 1; i <= n; i++) /* flat on purpose: the repair makes every edge an axis */
            memcpy(s->simplex + i * n, s->simplex, n * sizeof(double));
    for (size_t k = 0; k < n; k++)
        s->scale[k] *= size;
    for (size_t i = 0; i <= n; i++)
        lobe_box_clamp(s->objective->lower, s->objective->upper, n, s->simplex + i * n);
    const int replaced = lobe_simplex_repair(s->simplex, n, s->scale, s->objective->upper);
    for (size_t i = 0; i <= n; i++) /* rounding may put a step onto a bound a hair outside */
        lobe_box_clamp(s->objective->lower, s->objective->upper, n, s->simplex + i * n);
    for (size_t k = 0; k < n; k++)
        s->scale[k] /= size;
    return replaced >= 0;
}

/* Runs from x with its value known, restarts while that helps; x and *value become the best seen. */
static void run(search *s, double *x, double *value, const double *given)
{
    const size_t n = s->n;
    double size = s->o->size;
    for (size_t r = 0; r <= s->o->restarts && !s->over; r++) {
        const double before = *value;
        memcpy(s->simplex, x, n * sizeof *x);
        if (!build_simplex(s, size, r == 0 ? given : NULL)) {
            s->over = true;
            s->result = lobe_fit_no_memory();
            return;
        }
        s->value[0] = *value;
        const size_t known = r == 0 && given ? 0 : 1; /* x itself */
        evaluate(s, s->simplex + known * n, n + 1 - known, s->value + known);
        for (sort_vertices(s); !must_stop(s, s->value[0]) && !run_converged(s) && !run_collapsed(s); sort_vertices(s)) {
            step(s);
            s->result.iterations++;
        }
        if (s->value[0] < *value) {
            *value = s->value[0];
            memcpy(x, s->simplex, n * sizeof *x);
        }
        if (s->over || (r > 0 && before - *value <= 1e-9 * fabs(before) + 1e-300))
            break;
        if (size > 1e-4)
            size *= 0.5;
    }
}

static void fill_scale(search *s, const double *x)
{
    const double *lower = s->objective->lower, *upper = s->objective->upper;
    for (size_t k = 0; k < s->n; k++) {
        s->scale[k] = lower ? upper[k] - lower[k] : fabs(x[k]);
        if (!lower && !(s->scale[k] >= 1.0))
            s->scale[k] = 1.0;
        if (!(s->scale[k] > 0.0 && isfinite(s->scale[k]))) /* a fixed or half-bounded parameter */
            s->scale[k] = fabs(x[k]) > 1.0 ? fabs(x[k]) : 1.0;
    }
}

lobe_fit_result lobe_nelder_mead(const lobe_objective *objective, const lobe_nm_options *options, double *x)
{
    const lobe_nm_options o = options ? *options : lobe_nm_default();
    const char *reason = check(objective, &o);
    if (!x)
        reason = "no start point";
    if (reason)
        return lobe_fit_refused(reason);
    const size_t n = objective->dim, starts = o.starts;
    for (size_t k = 0; k < n; k++)
        if (!isfinite(x[k]))
            return lobe_fit_refused("the start point is not finite");
    double *memory = malloc(((n + 1) * n + (n + 1) + 4 * n + starts * n + starts) * sizeof *memory);
    if (!memory)
        return lobe_fit_no_memory();
    search s = {objective, &o, n, NULL, memory, NULL, NULL, NULL, NULL, {LOBE_FIT_CONVERGED, "", 0, 0, 0}, false};
    s.value = s.simplex + (n + 1) * n;
    s.centre = s.value + n + 1;
    s.trial = s.centre + n;
    s.trial2 = s.trial + n;
    s.scale = s.trial2 + n;
    double *start = s.scale + n, *start_value = start + starts * n;
    s.result.reason = "the simplex has contracted, and a restart finds nothing better";

    if (starts > 1) {
        lobe_random random;
        lobe_random_seed(&random, o.seed, 1);
        lobe_random_latin(&random, objective->lower, objective->upper, n, starts, start);
    }
    memcpy(start, x, n * sizeof *x);
    lobe_box_clamp(objective->lower, objective->upper, n, start);
    fill_scale(&s, start);
    evaluate(&s, start, starts, start_value);
    size_t best = 0;
    for (size_t i = 0; i < starts; i++) {
        lobe_nm_options share = o; /* the budget that is left, in equal parts */
        share.budget = s.result.evaluations + budget_left(&s) / (starts - i);
        share.budget = i + 1 == starts ? o.budget : share.budget;
        if (budget_left(&s) < n + 2)
            break;
        s.o = &share;
        s.over = false;
        run(&s, start + i * n, &start_value[i], i == 0 ? o.simplex : NULL);
        s.o = &o;
        if (start_value[i] < start_value[best])
            best = i;
        if (s.over && (s.result.status != LOBE_FIT_BUDGET))
            break;
    }
    if (s.result.status != LOBE_FIT_NO_MEMORY) {
        s.result.value = start_value[best];
        memcpy(x, start + best * n, n * sizeof *x);
        if (s.result.status == LOBE_FIT_BUDGET && budget_left(&s) >= n + 2 && starts > 1) {
            s.result.status = LOBE_FIT_CONVERGED; /* an early start used its share up; the last one came to rest */
            s.result.reason = "every start has come to rest or used its share of the budget";
        }
    }
    free(memory);
    return s.result;
}
