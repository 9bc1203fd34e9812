/* The minimax engine against Chebyshev's and Remez' errors, which are known, and the pruning on top of it. */
#include "../fit/minimax.h"
#include "../fit/parallel.h"
#include "../fit/power_norm.h"
#include "../fit/prune.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <string.h>
#include <cmocka.h>

#define ROWS 2001

/* A polynomial against a function on [-1, 1]. */
typedef struct polynomial {
    double (*f)(double);
    size_t terms;
} polynomial;

static double point(size_t r) { return ((double)r - (ROWS - 1) / 2) / ((ROWS - 1) / 2); }

static void polynomial_error(void *ctx, const double *params, size_t count, double *values)
{
    const polynomial *p = ctx;
    for (size_t i = 0; i < count; i++) {
        for (size_t r = 0; r < ROWS; r++) {
            const double t = point(r);
            double y = 0.0;
            for (size_t k = p->terms; k-- > 0;)
                y = y * t + params[i * p->terms + k];
            values[i * ROWS + r] = y - p->f(t);
        }
    }
}

static double fifth_power(double t) { return t * t * t * t * t; }

static lobe_residuals residuals_of(polynomial *p)
{
    lobe_residuals r = {polynomial_error, NULL, p, p->terms, ROWS, NULL, NULL, NULL};
    return r;
}

static void known_minimax_errors_are_reproduced(void **state)
{
    /* exp: Remez by sollya, remez(exp(x), n, [-1;1]); |x|: degree 2 is 1/8 (Bernstein), degree 4 .0676209;
     * x^5 by degree 4: Chebyshev's 2^-4. */
    static const struct {
        double (*f)(double);
        size_t degree;
        double error;
    } known[] = {{exp, 1, 0.278802}, {exp, 2, 0.0450174},  {exp, 3, 0.00552837},    {exp, 4, 5.46668e-4},
                 {fabs, 2, 0.125},   {fabs, 4, 0.0676209}, {fifth_power, 4, 0.0625}};
    (void)state;
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        polynomial p = {known[i].f, known[i].degree + 1};
        const lobe_residuals residuals = residuals_of(&p);
        lobe_minimax_options o = lobe_minimax_default();
        double x[6] = {0};
        o.p_last = 20000;
        const lobe_minimax_result r = lobe_minimax(&residuals, &o, x);
        assert_int_equal(r.fit.status, LOBE_FIT_CONVERGED);
        assert_true(fabs(r.fit.value - known[i].error) <= 5e-4 * known[i].error);
        double e[ROWS];
        polynomial_error(&p, x, 1, e); /* what is reported is what is there */
        assert_true(fabs(e[r.worst_row]) == r.fit.value);
        for (size_t k = 0; k < ROWS; k++)
            assert_true(fabs(e[k]) <= r.fit.value);
    }
}

static void maximum_beats_least_squares(void **state)
{
    polynomial p = {fabs, 7};
    const lobe_residuals residuals = residuals_of(&p);
    lobe_minimax_options o = lobe_minimax_default();
    double x[7] = {0}, y[7] = {0};
    (void)state;
    o.p_last = 2;
    const lobe_minimax_result squares = lobe_minimax(&residuals, &o, x);
    const lobe_minimax_result minimax = lobe_minimax(&residuals, NULL, y);
    assert_true(minimax.fit.value < 0.8 * squares.fit.value);
    assert_true(minimax.rms > squares.rms);
}

static void weights_move_the_error(void **state)
{
    static double weights[ROWS];
    polynomial p = {exp, 3};
    lobe_residuals residuals = residuals_of(&p);
    double x[3] = {0}, e[ROWS], largest[2] = {0.0, 0.0};
    (void)state;
    for (size_t r = 0; r < ROWS; r++)
        weights[r] = point(r) < 0.0 ? 4.0 : 1.0;
    residuals.weights = weights;
    const lobe_minimax_result r = lobe_minimax(&residuals, NULL, x);
    polynomial_error(&p, x, 1, e);
    for (size_t i = 0; i < ROWS; i++)
        largest[point(i) < 0.0] = fmax(largest[point(i) < 0.0], fabs(e[i]));
    assert_true(fabs(largest[0] / largest[1] - 4.0) < 0.1);
    assert_true(fabs(r.fit.value - fmax(largest[0], 4.0 * largest[1])) < 1e-12);
}

/* (p0 + p1 x + p2 x^2) / (1 + q1 x + q2 x^2) against exp: not linear in its parameters. */
static void rational_error(void *ctx, const double *params, size_t count, double *values)
{
    (void)ctx;
    for (size_t i = 0; i < count; i++) {
        const double *x = params + 5 * i;
        for (size_t r = 0; r < ROWS; r++) {
            const double t = point(r);
            values[i * ROWS + r] = (x[0] + t * (x[1] + t * x[2])) / (1.0 + t * (x[3] + t * x[4])) - exp(t);
        }
    }
}

static void rational_fit_reaches_the_published_error(void **state)
{
    /* Best (2, 2) approximation of exp on [-1, 1]: 8.69e-5 (Meinardus: n! m! / (2^(n+m) (n+m)! (n+m+1)!) gives 8.7e-5).
     */
    const lobe_residuals residuals = {rational_error, NULL, NULL, 5, ROWS, NULL, NULL, NULL};
    lobe_minimax_options o = lobe_minimax_default();
    double x[5] = {1.0, 0.5, 0.1, -0.5, 0.1};
    (void)state;
    o.p_last = 5000;
    const lobe_minimax_result r = lobe_minimax(&residuals, &o, x);
    assert_true(fabs(r.fit.value - 8.69e-5) < 0.01e-5);
}

static void bounds_hold(void **state)
{
    /* A line through exp with a slope of at most 1: the best is 1 * t + c, with the error (e - 2) / 2 of exp(t) - t. */
    static const double lower[2] = {-10.0, -10.0}, upper[2] = {10.0, 1.0};
    polynomial p = {exp, 2};
    lobe_residuals residuals = residuals_of(&p);
    lobe_minimax_options o = lobe_minimax_default();
    double x[2] = {0};
    (void)state;
    residuals.lower = lower;
    residuals.upper = upper;
    o.p_last = 5000;
    const lobe_minimax_result r = lobe_minimax(&residuals, &o, x);
    assert_true(x[1] <= 1.0);
    assert_true(fabs(r.fit.value - (exp(1.0) - 2.0) / 2.0) < 1e-3);
}

static bool stop_after(void *ctx, const lobe_progress *progress)
{
    return progress->evaluations < *(const size_t *)ctx;
}

static void interruption_and_budget_keep_the_best(void **state)
{
    polynomial p = {exp, 5};
    const lobe_residuals residuals = residuals_of(&p);
    lobe_minimax_options o = lobe_minimax_default();
    double x[5] = {0}, y[5] = {0}, e[ROWS];
    size_t limit = 40;
    (void)state;
    o.progress = stop_after;
    o.progress_ctx = &limit;
    const lobe_minimax_result r = lobe_minimax(&residuals, &o, x);
    assert_int_equal(r.fit.status, LOBE_FIT_INTERRUPTED);
    polynomial_error(&p, x, 1, e);
    assert_true(fabs(e[r.worst_row]) == r.fit.value && r.fit.value < 1e-3);
    o.progress = NULL;
    o.budget = 40;
    const lobe_minimax_result b = lobe_minimax(&residuals, &o, y);
    assert_int_equal(b.fit.status, LOBE_FIT_BUDGET);
    assert_true(b.fit.evaluations <= 50);
    assert_memory_equal(x, y, sizeof x);
}

static void threads_change_no_byte(void **state)
{
    polynomial p = {fabs, 6};
    lobe_parallel parallel = {polynomial_error, &p, 6, ROWS, 1};
    lobe_residuals residuals = residuals_of(&p);
    double x[6] = {0}, y[6] = {0};
    (void)state;
    residuals.f = lobe_parallel_eval;
    residuals.ctx = &parallel;
    const lobe_minimax_result a = lobe_minimax(&residuals, NULL, x);
    parallel.threads = 2;
    const lobe_minimax_result b = lobe_minimax(&residuals, NULL, y);
    assert_memory_equal(x, y, sizeof x);
    assert_true(a.fit.value == b.fit.value && a.fit.evaluations == b.fit.evaluations);
}

static void power_norm_is_a_norm(void **state)
{
    const double e[4] = {3.0, -4.0, 0.0, 1e-200};
    (void)state;
    assert_true(fabs(lobe_power_norm_of(e, NULL, 4, 2, NULL).norm - 5.0) < 1e-12);
    assert_true(fabs(lobe_power_norm_of(e, NULL, 4, 100000, NULL).norm - 4.0) < 1e-12);
    assert_true(fabs(lobe_power_norm_of(e, NULL, 4, 3, NULL).norm - cbrt(27.0 + 64.0)) < 1e-12);
    const double bad[2] = {1.0, NAN};
    assert_true(lobe_power_norm_of(bad, NULL, 2, 2, NULL).max < 0.0);
    assert_true(lobe_integer_power(3.0, 13) == 1594323.0);
}

/* cos(x) on [-1, 1] has no odd terms: those go first and for nothing; then the highest, x^6 before x^4 before x^2. */
static void pruning_finds_the_superfluous_terms(void **state)
{
    polynomial p = {cos, 7};
    const lobe_residuals residuals = residuals_of(&p);
    lobe_prune_options o = lobe_prune_default();
    double x[7] = {0};
    bool removed[7];
    lobe_prune_step steps[7];
    size_t count;
    (void)state;
    const double full = lobe_minimax(&residuals, NULL, x).fit.value;
    o.keep = 1;
    const lobe_fit_result r = lobe_prune(&residuals, &o, x, removed, steps, &count);
    assert_int_equal(r.status, LOBE_FIT_CONVERGED);
    assert_int_equal(count, 6);
    for (size_t i = 0; i < 3; i++) {
        assert_true(steps[i].term % 2 == 1);
        assert_true(steps[i].error < 1.05 * full);
    }
    for (size_t i = 4; i < 6; i++)
        assert_true(steps[i].error > 2.0 * steps[i - 1].error);
    assert_int_equal(steps[3].term, 6);
    assert_false(removed[0]);
    /* One constant for cos on [-1, 1]: (1 - cos 1) / 2. */
    assert_true(fabs(r.value - (1.0 - cos(1.0)) / 2.0) < 5e-3 * r.value);
    for (size_t k = 1; k < 7; k++)
        assert_true(removed[k] && x[k] == 0.0);
}

static void pruning_stops_at_its_limit_and_keeps_fixed_terms(void **state)
{
    static const bool fixed[7] = {false, true, false, false, false, false, false};
    polynomial p = {cos, 7};
    const lobe_residuals residuals = residuals_of(&p);
    lobe_prune_options o = lobe_prune_default();
    double x[7] = {0};
    bool removed[7];
    lobe_prune_step steps[7];
    size_t count;
    (void)state;
    lobe_minimax(&residuals, NULL, x);
    o.limit = 1e-3;
    o.fixed = fixed;
    const lobe_fit_result r = lobe_prune(&residuals, &o, x, removed, steps, &count);
    assert_int_equal(count, 3); /* x^3, x^5 and x^6 */
    assert_false(removed[1]);
    assert_true(removed[3] && removed[5] && removed[6]);
    assert_true(r.value <= 1e-3 && r.value == steps[2].error);
    assert_non_null(strstr(r.reason, "limit"));
}

static void bad_options_are_refused_with_a_reason(void **state)
{
    polynomial p = {exp, 3};
    const lobe_residuals residuals = residuals_of(&p);
    lobe_minimax_options o = lobe_minimax_default();
    double x[3] = {0};
    (void)state;
    o.p_first = 1;
    assert_non_null(strstr(lobe_minimax(&residuals, &o, x).fit.reason, "powers"));
    o = lobe_minimax_default();
    o.p_growth = 1.0;
    assert_non_null(strstr(lobe_minimax(&residuals, &o, x).fit.reason, "grow"));
    o = lobe_minimax_default();
    o.ridge = NAN;
    assert_int_equal(lobe_minimax(&residuals, &o, x).fit.status, LOBE_FIT_BAD_INPUT);
    x[0] = NAN;
    assert_non_null(strstr(lobe_minimax(&residuals, NULL, x).fit.reason, "start point"));
    lobe_prune_options q = lobe_prune_default();
    bool removed[3];
    lobe_prune_step steps[3];
    size_t count;
    q.keep = 4;
    assert_non_null(strstr(lobe_prune(&residuals, &q, x, removed, steps, &count).reason, "keep"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(known_minimax_errors_are_reproduced),
        cmocka_unit_test(maximum_beats_least_squares),
        cmocka_unit_test(weights_move_the_error),
        cmocka_unit_test(rational_fit_reaches_the_published_error),
        cmocka_unit_test(bounds_hold),
        cmocka_unit_test(interruption_and_budget_keep_the_best),
        cmocka_unit_test(threads_change_no_byte),
        cmocka_unit_test(power_norm_is_a_norm),
        cmocka_unit_test(pruning_finds_the_superfluous_terms),
        cmocka_unit_test(pruning_stops_at_its_limit_and_keeps_fixed_terms),
        cmocka_unit_test(bad_options_are_refused_with_a_reason),
    };
    return cmocka_run_group_tests_name("minimax and pruning", tests, NULL, NULL);
}
