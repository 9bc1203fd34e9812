/* The local engines: Nelder-Mead and least squares, the latter beside cminpack. */
#include "../fit/least_squares.h"
#include "../fit/nelder_mead.h"
#include "../fit/parallel.h"
#include "../fit/triangle.h"
#include "optimiser_problems.h"

#include <cminpack-1/cminpack.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>

static void rosenbrock(void *ctx, const double *params, size_t count, double *values)
{
    const size_t dim = *(const size_t *)ctx;
    for (size_t i = 0; i < count; i++) {
        const double *x = params + i * dim;
        values[i] = 0.0;
        for (size_t k = 0; k + 1 < dim; k++)
            values[i] += 100.0 * pow(x[k + 1] - x[k] * x[k], 2.0) + pow(1.0 - x[k], 2.0);
    }
}

static void simplex_finds_rosenbrock_without_bounds(void **state)
{
    (void)state;
    for (size_t dim = 2; dim <= 10; dim += 4) {
        const lobe_objective objective = {rosenbrock, &dim, dim, NULL, NULL, NULL};
        double x[10];
        for (size_t k = 0; k < dim; k++)
            x[k] = 3.0;
        const lobe_fit_result r = lobe_nelder_mead(&objective, NULL, x);
        assert_int_equal(r.status, LOBE_FIT_CONVERGED);
        assert_true(r.value <= 1e-9);
        for (size_t k = 0; k < dim; k++)
            assert_true(fabs(x[k] - 1.0) < 1e-4);
    }
}

/* |determinant| of the edges, by elimination: independent of the repair, which orthogonalises. */
static void volume_check(double *simplex, size_t n, double *volume)
{
    double a[16];
    *volume = 1.0;
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++)
            a[i * n + k] = simplex[(i + 1) * n + k] - simplex[k];
    for (size_t c = 0; c < n; c++) { /* elimination with row pivots */
        size_t p = c;
        for (size_t i = c + 1; i < n; i++)
            if (fabs(a[i * n + c]) > fabs(a[p * n + c]))
                p = i;
        for (size_t k = 0; k < n; k++) {
            const double swap = a[c * n + k];
            a[c * n + k] = a[p * n + k];
            a[p * n + k] = swap;
        }
        *volume *= a[c * n + c];
        for (size_t i = c + 1; i < n && a[c * n + c] != 0.0; i++) {
            const double f = a[i * n + c] / a[c * n + c];
            for (size_t k = c; k < n; k++)
                a[i * n + k] -= f * a[c * n + k];
        }
    }
    *volume = fabs(*volume);
}

static void flat_simplex_is_repaired(void **state)
{
    const double scale[3] = {0.1, 0.1, 0.1}, top[3] = {1.0, 1.0, 1.0};
    double flat[12] = {1, 1, 1, 0.9, 1, 1, 0.8, 1, 1, 1, 0.9, 1}; /* the second edge is twice the first */
    double good[12] = {0, 0, 0, 0.1, 0, 0, 0.1, 0.1, 0, 0.1, 0.1, 0.1}, kept[12], volume;
    (void)state;
    memcpy(kept, good, sizeof good);
    assert_int_equal(lobe_simplex_repair(good, 3, scale, top), 0);
    assert_memory_equal(good, kept, sizeof good);
    volume_check(flat, 3, &volume);
    assert_true(volume == 0.0);
    /* The second edge becomes the y axis, in whose plane the third then lies. */
    assert_int_equal(lobe_simplex_repair(flat, 3, scale, top), 2);
    volume_check(flat, 3, &volume);
    assert_true(volume > 1e-4);
    for (int i = 0; i < 12; i++)
        assert_true(flat[i] <= 1.0);

    /* A run from a simplex that is one point thrice still finds the minimum. */
    size_t dim = 2;
    const lobe_objective objective = {rosenbrock, &dim, 2, NULL, NULL, NULL};
    const double point[6] = {-1.2, 1.0, -1.2, 1.0, -1.2, 1.0};
    lobe_nm_options o = lobe_nm_default();
    o.simplex = point;
    double x[2] = {-1.2, 1.0};
    assert_true(lobe_nelder_mead(&objective, &o, x).value < 1e-9);
}

static void corner(void *ctx, const double *params, size_t count, double *values)
{
    for (size_t i = 0; i < count; i++) {
        const double *x = params + 2 * i;
        if (x[0] < 0.0 || x[0] > 1.0 || x[1] < 0.0 || x[1] > 1.0)
            *(bool *)ctx = true;
        values[i] = pow(x[0] - 2.0, 2.0) + pow(x[1] - 0.5, 2.0);
    }
}

static void simplex_respects_bounds(void **state)
{
    static const double lower[2] = {0.0, 0.0}, upper[2] = {1.0, 1.0};
    bool escaped = false;
    const lobe_objective objective = {corner, &escaped, 2, lower, upper, NULL};
    double x[2] = {0.1, 0.9};
    (void)state;
    const lobe_fit_result r = lobe_nelder_mead(&objective, NULL, x);
    assert_false(escaped);
    assert_true(fabs(x[0] - 1.0) < 1e-6 && fabs(x[1] - 0.5) < 1e-4 && fabs(r.value - 1.0) < 1e-6);
}

/* Two wells: the start is in the shallow one, of value 1 at 3; the deep one is 0 at -3. */
static void wells(void *ctx, const double *params, size_t count, double *values)
{
    (void)ctx;
    for (size_t i = 0; i < count; i++)
        values[i] = fmin(1.0 + pow(params[i] - 3.0, 2.0), pow(params[i] + 3.0, 2.0));
}

static void more_starts_leave_a_bad_basin(void **state)
{
    static const double lower = -5.0, upper = 5.0;
    const lobe_objective objective = {wells, NULL, 1, &lower, &upper, NULL};
    lobe_nm_options o = lobe_nm_default();
    double x = 3.2;
    (void)state;
    assert_true(fabs(lobe_nelder_mead(&objective, &o, &x).value - 1.0) < 1e-6);
    o.starts = 5;
    x = 3.2;
    assert_true(lobe_nelder_mead(&objective, &o, &x).value < 1e-6);
    assert_true(fabs(x + 3.0) < 1e-3);
}

static bool stop_after(void *ctx, const lobe_progress *progress)
{
    return progress->evaluations < *(const size_t *)ctx;
}

static void interruption_keeps_the_best(void **state)
{
    size_t dim = 5, limit = 100;
    const lobe_objective objective = {rosenbrock, &dim, 5, NULL, NULL, NULL};
    lobe_nm_options o = lobe_nm_default();
    double x[5] = {-1.2, 1.0, -1.2, 1.0, -1.2}, first, value;
    (void)state;
    rosenbrock(&dim, x, 1, &first);
    o.progress = stop_after;
    o.progress_ctx = &limit;
    const lobe_fit_result r = lobe_nelder_mead(&objective, &o, x);
    rosenbrock(&dim, x, 1, &value);
    assert_int_equal(r.status, LOBE_FIT_INTERRUPTED);
    assert_true(r.evaluations < 120 && r.value < first && r.value == value);
}

static lobe_residuals residuals_of(const lobe_square_problem *p)
{
    lobe_residuals r = {0};
    r.f = lobe_square_problem_eval;
    r.ctx = (void *)(uintptr_t)p;
    r.dim = p->dim;
    r.rows = p->rows;
    return r;
}

static int lmdif_rows(void *ctx, int m, int n, const double *x, double *r, int flag)
{
    (void)m, (void)n, (void)flag;
    lobe_square_problem_eval(ctx, x, 1, r);
    return 0;
}

static double minpack(const lobe_square_problem *p, double *x)
{
    const int m = (int)p->rows, n = (int)p->dim;
    double r[LOBE_PROBLEM_MAX_ROWS], work[5 * LOBE_PROBLEM_MAX_ROWS + 400], sum = 0.0;
    int pivot[LOBE_PROBLEM_MAX_DIM];
    lmdif1(lmdif_rows, (void *)(uintptr_t)p, m, n, x, r, 1e-14, pivot, work, (int)(sizeof work / sizeof *work));
    for (int i = 0; i < m; i++)
        sum += r[i] * r[i];
    return sum;
}

static void least_squares_agrees_with_cminpack(void **state)
{
    (void)state;
    for (size_t i = 0; i < lobe_square_problem_count; i++) {
        const lobe_square_problem *p = &lobe_square_problems[i];
        const lobe_residuals residuals = residuals_of(p);
        double x[LOBE_PROBLEM_MAX_DIM], y[LOBE_PROBLEM_MAX_DIM];
        memcpy(x, p->start, sizeof x);
        memcpy(y, p->start, sizeof y);
        const lobe_fit_result r = lobe_least_squares(&residuals, NULL, x);
        const double theirs = minpack(p, y);
        assert_int_equal(r.status, LOBE_FIT_CONVERGED);
        assert_true(fabs(r.value - p->minimum) <= 1e-5 * p->minimum + 1e-12);
        assert_true(r.value <= theirs * (1.0 + 1e-9) + 1e-12);
        for (size_t k = 0; k < p->dim; k++)
            assert_true(fabs(x[k] - y[k]) <= 1e-3 * (fabs(y[k]) + 1.0));
    }
}

static void rosenbrock_jacobian(void *ctx, const double *x, double *transposed)
{
    (void)ctx;
    transposed[0] = -20.0 * x[0];
    transposed[1] = -1.0;
    transposed[2] = 10.0;
    transposed[3] = 0.0;
}

static void own_derivatives_and_central_ones_serve(void **state)
{
    lobe_residuals residuals = residuals_of(&lobe_square_problems[0]);
    lobe_ls_options o = lobe_ls_default();
    (void)state;
    o.difference = LOBE_DIFFERENCE_CENTRAL;
    double x[2] = {-1.2, 1.0}, y[2] = {-1.2, 1.0};
    const lobe_fit_result central = lobe_least_squares(&residuals, &o, x);
    residuals.jacobian = rosenbrock_jacobian;
    const lobe_fit_result exact = lobe_least_squares(&residuals, &o, y);
    assert_true(central.value < 1e-18 && exact.value < 1e-18);
    assert_true(exact.evaluations < central.evaluations);
}

static void least_squares_respects_bounds(void **state)
{
    /* Rosenbrock with x <= 0.5: the minimum is at (0.5, 0.25), of value 0.25. */
    static const double lower[2] = {-2.0, -2.0}, upper[2] = {0.5, 2.0};
    lobe_residuals residuals = residuals_of(&lobe_square_problems[0]);
    double x[2] = {-1.2, 1.0};
    (void)state;
    residuals.lower = lower;
    residuals.upper = upper;
    const lobe_fit_result r = lobe_least_squares(&residuals, NULL, x);
    assert_true(x[0] <= 0.5);
    assert_true(fabs(x[0] - 0.5) < 1e-9 && fabs(x[1] - 0.25) < 1e-6 && fabs(r.value - 0.25) < 1e-9);
}

/* r = x - 1 and x - 3, the second of weight 2: the minimum is at (1 + 4 * 3) / 5; with ridge 5 at 13 / 10. */
static void two_rows(void *ctx, const double *params, size_t count, double *values)
{
    (void)ctx;
    for (size_t i = 0; i < count; i++) {
        values[2 * i] = params[i] - 1.0;
        values[2 * i + 1] = params[i] - 3.0;
    }
}

static void weights_and_ridge_do_what_they_say(void **state)
{
    static const double weights[2] = {1.0, 2.0};
    const lobe_residuals residuals = {two_rows, NULL, NULL, 1, 2, NULL, NULL, weights};
    lobe_ls_options o = lobe_ls_default();
    double x = 0.0;
    (void)state;
    lobe_least_squares(&residuals, &o, &x);
    assert_true(fabs(x - 2.6) < 1e-7);
    o.ridge = 5.0;
    lobe_least_squares(&residuals, &o, &x);
    assert_true(fabs(x - 1.3) < 1e-7);
}

static void threads_change_no_byte(void **state)
{
    const lobe_square_problem *p = &lobe_square_problems[4];
    lobe_residuals residuals = residuals_of(p);
    lobe_parallel parallel = {lobe_square_problem_eval, residuals.ctx, p->dim, p->rows, 1};
    double x[LOBE_PROBLEM_MAX_DIM], y[LOBE_PROBLEM_MAX_DIM];
    (void)state;
    memcpy(x, p->start, sizeof x);
    memcpy(y, p->start, sizeof y);
    residuals.f = lobe_parallel_eval;
    residuals.ctx = &parallel;
    lobe_least_squares(&residuals, NULL, x);
    parallel.threads = 2;
    lobe_least_squares(&residuals, NULL, y);
    assert_memory_equal(x, y, sizeof x);
}

/* Vandermonde rows of degree 12 on [0, 1]: normal equations lose all digits, the factor keeps about half. */
static void triangle_keeps_its_digits(void **state)
{
    enum { N = 13, M = 200 };
    double r[N * (N + 1)], rows[M * (N + 1)], spare[N + 1], x[N];
    lobe_triangle t = {N, r};
    (void)state;
    lobe_triangle_clear(&t);
    for (int i = 0; i < M; i++) {
        const double at = i / (double)(M - 1);
        double power = 1.0, sum = 0.0;
        for (int k = 0; k < N; k++, power *= at) {
            rows[i * (N + 1) + k] = power;
            sum += power; /* all coefficients 1 */
        }
        rows[i * (N + 1) + N] = -sum;
    }
    for (int first = 0; first < M; first += 64)
        lobe_triangle_add(&t, rows + first * (N + 1), M - first < 64 ? (size_t)(M - first) : 64, spare);
    assert_true(lobe_triangle_solve(&t, x));
    for (int k = 0; k < N; k++)
        assert_true(fabs(x[k] - 1.0) < 1e-6);
}

static void bad_input_is_refused_with_a_reason(void **state)
{
    size_t dim = 2;
    lobe_objective objective = {rosenbrock, &dim, 2, NULL, NULL, NULL};
    lobe_nm_options o = lobe_nm_default();
    double x[2] = {1.0, NAN};
    (void)state;
    assert_non_null(strstr(lobe_nelder_mead(&objective, &o, x).reason, "finite"));
    x[1] = 1.0;
    o.size = 0.0;
    assert_non_null(strstr(lobe_nelder_mead(&objective, &o, x).reason, "size"));
    o = lobe_nm_default();
    o.starts = 3;
    assert_non_null(strstr(lobe_nelder_mead(&objective, &o, x).reason, "bounds"));

    lobe_residuals residuals = residuals_of(&lobe_square_problems[0]);
    lobe_ls_options ls = lobe_ls_default();
    ls.ridge = -1.0;
    assert_int_equal(lobe_least_squares(&residuals, &ls, x).status, LOBE_FIT_BAD_INPUT);
    x[0] = INFINITY;
    const lobe_fit_result r = lobe_least_squares(&residuals, NULL, x);
    assert_int_equal(r.status, LOBE_FIT_BAD_INPUT);
    assert_non_null(strstr(r.reason, "start point"));
    residuals.rows = 0;
    assert_non_null(strstr(lobe_least_squares(&residuals, NULL, x).reason, "rows"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(simplex_finds_rosenbrock_without_bounds),
        cmocka_unit_test(flat_simplex_is_repaired),
        cmocka_unit_test(simplex_respects_bounds),
        cmocka_unit_test(more_starts_leave_a_bad_basin),
        cmocka_unit_test(interruption_keeps_the_best),
        cmocka_unit_test(least_squares_agrees_with_cminpack),
        cmocka_unit_test(own_derivatives_and_central_ones_serve),
        cmocka_unit_test(least_squares_respects_bounds),
        cmocka_unit_test(weights_and_ridge_do_what_they_say),
        cmocka_unit_test(threads_change_no_byte),
        cmocka_unit_test(triangle_keeps_its_digits),
        cmocka_unit_test(bad_input_is_refused_with_a_reason),
    };
    return cmocka_run_group_tests_name("local optimisers", tests, NULL, NULL);
}
