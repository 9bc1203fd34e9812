/* The global engines: known minima, reasons for stopping, reproducibility, threads, levels of rows. */
#include "../fit/coarse_to_fine.h"
#include "../fit/global_local.h"
#include "../fit/parallel.h"
#include "../fit/random.h"
#include "optimiser_problems.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>

static double lower[LOBE_PROBLEM_MAX_DIM], upper[LOBE_PROBLEM_MAX_DIM];

static lobe_objective objective_of(const lobe_value_problem *p)
{
    for (size_t k = 0; k < p->dim; k++) {
        lower[k] = p->lower;
        upper[k] = p->upper;
    }
    lobe_objective o = {lobe_value_problem_eval, (void *)(uintptr_t)p, p->dim, lower, upper, NULL};
    return o;
}

static const lobe_value_problem *problem(const char *name)
{
    for (size_t i = 0; i < lobe_value_problem_count; i++)
        if (strcmp(lobe_value_problems[i].name, name) == 0)
            return &lobe_value_problems[i];
    fail_msg("no problem %s", name);
    return NULL;
}

static void evolution_finds_known_minima(void **state)
{
    static const char *const names[] = {"rosenbrock 2", "rosenbrock 5", "rastrigin 2", "rastrigin 5", "ackley 5"};
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const lobe_objective objective = objective_of(problem(names[i]));
        double x[LOBE_PROBLEM_MAX_DIM];
        const lobe_fit_result r = lobe_differential_evolution(&objective, NULL, x);
        assert_true(r.value <= 1e-6);
        assert_int_equal(r.status, LOBE_FIT_CONVERGED);
    }
}

static void polish_sharpens_the_global_stage(void **state)
{
    const lobe_objective objective = objective_of(problem("rosenbrock 5"));
    lobe_global_local_options o = lobe_global_local_default();
    double x[LOBE_PROBLEM_MAX_DIM], rough[LOBE_PROBLEM_MAX_DIM];
    (void)state;
    o.global.target = 0.1; /* the global stage alone stops far away */
    const lobe_fit_result alone = lobe_differential_evolution(&objective, &o.global, rough);
    assert_true(alone.value > 1e-6);
    o.global.target = -HUGE_VAL;
    o.global.stall_generations = 5;
    o.rounds = 3;
    const lobe_fit_result r = lobe_global_local(&objective, &o, x);
    assert_true(r.value <= 1e-9);
    for (size_t k = 0; k < 5; k++)
        assert_true(fabs(x[k] - 1.0) < 1e-3);
    assert_true(r.evaluations <= o.budget);
}

/* f = |x - (2, 2)|^2 on [0, 1]^2 has its minimum on the corner; the callee sees nothing outside. */
static void corner(void *ctx, const double *params, size_t count, double *values)
{
    bool *escaped = ctx;
    for (size_t i = 0; i < count; i++) {
        const double *x = params + 2 * i;
        for (int k = 0; k < 2; k++)
            if (!(x[k] >= 0.0 && x[k] <= 1.0))
                *escaped = true;
        values[i] = (x[0] - 2.0) * (x[0] - 2.0) + (x[1] - 2.0) * (x[1] - 2.0);
    }
}

static void evolution_respects_bounds(void **state)
{
    static const double zero[2] = {0.0, 0.0}, one[2] = {1.0, 1.0};
    (void)state;
    for (int redraw = 0; redraw < 2; redraw++) {
        bool escaped = false;
        const lobe_objective objective = {corner, &escaped, 2, zero, one, NULL};
        lobe_de_options o = lobe_de_default();
        double x[2];
        o.bounds = redraw ? LOBE_DE_REDRAW : LOBE_DE_CLAMP;
        const lobe_fit_result r = lobe_differential_evolution(&objective, &o, x);
        assert_false(escaped);
        assert_true(r.value - 2.0 < (redraw ? 1e-3 : 1e-12));
    }
}

static void equal_seeds_give_equal_bytes(void **state)
{
    const lobe_objective objective = objective_of(problem("ackley 5"));
    lobe_de_options o = lobe_de_default();
    double a[5], b[5], c[5];
    (void)state;
    o.budget = 2000;
    const lobe_fit_result ra = lobe_differential_evolution(&objective, &o, a);
    const lobe_fit_result rb = lobe_differential_evolution(&objective, &o, b);
    o.seed = 2;
    lobe_differential_evolution(&objective, &o, c);
    assert_memory_equal(a, b, sizeof a);
    assert_int_equal(ra.evaluations, rb.evaluations);
    assert_memory_not_equal(a, c, sizeof a);
    o.seed = 1;
    o.f_min = o.f_max = 0.75; /* no dither: another path, so the weight is really drawn */
    lobe_differential_evolution(&objective, &o, b);
    assert_memory_not_equal(a, b, sizeof a);
}

static void threads_change_no_byte(void **state)
{
    const lobe_value_problem *p = problem("rastrigin 5");
    lobe_objective objective = objective_of(p);
    lobe_parallel parallel = {lobe_value_problem_eval, (void *)(uintptr_t)p, p->dim, 1, 1};
    lobe_global_local_options o = lobe_global_local_default();
    double x[3][5];
    lobe_fit_result r[3];
    (void)state;
    o.budget = 6000;
    objective.f = lobe_parallel_eval;
    objective.ctx = &parallel;
    for (size_t i = 0; i < 3; i++) {
        memset(x[i], 0, sizeof x[i]);
        parallel.threads = i + 1;
        r[i] = lobe_global_local(&objective, &o, x[i]);
    }
    for (size_t i = 1; i < 3; i++) {
        assert_memory_equal(x[0], x[i], sizeof x[0]);
        assert_memory_equal(&r[0].value, &r[i].value, sizeof r[0].value);
        assert_int_equal(r[0].evaluations, r[i].evaluations);
    }
}

static void every_stop_names_its_reason(void **state)
{
    const lobe_objective objective = objective_of(problem("rosenbrock 5"));
    lobe_de_options o = lobe_de_default();
    double x[5];
    (void)state;
    o.budget = 500;
    lobe_fit_result r = lobe_differential_evolution(&objective, &o, x);
    assert_int_equal(r.status, LOBE_FIT_BUDGET);
    assert_int_equal(r.evaluations, 500);
    o = lobe_de_default();
    o.target = 1.0;
    r = lobe_differential_evolution(&objective, &o, x);
    assert_int_equal(r.status, LOBE_FIT_CONVERGED);
    assert_true(r.value <= 1.0);
    assert_non_null(strstr(r.reason, "target"));
    o = lobe_de_default();
    o.spread_tolerance = 0.5;
    r = lobe_differential_evolution(&objective, &o, x);
    assert_non_null(strstr(r.reason, "contracted"));
    o = lobe_de_default();
    o.stall_generations = 1;
    r = lobe_differential_evolution(&objective, &o, x);
    assert_int_equal(r.status, LOBE_FIT_STALLED);
}

static bool stop_after(void *ctx, const lobe_progress *progress)
{
    return progress->evaluations < *(const size_t *)ctx;
}

static void interruption_keeps_the_best(void **state)
{
    const lobe_value_problem *p = problem("rosenbrock 5");
    const lobe_objective objective = objective_of(p);
    lobe_de_options o = lobe_de_default();
    size_t limit = 1000;
    double x[5];
    (void)state;
    o.progress = stop_after;
    o.progress_ctx = &limit;
    const lobe_fit_result r = lobe_differential_evolution(&objective, &o, x);
    assert_int_equal(r.status, LOBE_FIT_INTERRUPTED);
    assert_true(r.evaluations >= 1000 && r.evaluations <= 1050);
    assert_true(r.value == p->value(x, 5));
    o.progress = NULL;
    o.budget = r.evaluations; /* the same path, ended by its budget, is at the same point */
    double y[5];
    lobe_differential_evolution(&objective, &o, y);
    assert_memory_equal(x, y, sizeof x);
}

static void refuse(lobe_de_options o, const char *word)
{
    const lobe_objective objective = objective_of(problem("rosenbrock 2"));
    double x[2] = {3.0, 4.0};
    const lobe_fit_result r = lobe_differential_evolution(&objective, &o, x);
    assert_int_equal(r.status, LOBE_FIT_BAD_INPUT);
    assert_non_null(strstr(r.reason, word));
    assert_true(x[0] == 3.0 && x[1] == 4.0);
}

static void bad_options_are_refused_with_a_reason(void **state)
{
    (void)state;
    lobe_de_options o = lobe_de_default();
    o.population = 3;
    refuse(o, "population");
    o = lobe_de_default();
    o.f_min = 1.5;
    refuse(o, "weights");
    o = lobe_de_default();
    o.crossover = NAN;
    refuse(o, "crossover");
    o = lobe_de_default();
    o.budget = 5;
    refuse(o, "budget");
    o = lobe_de_default();
    o.value_tolerance = -1.0;
    refuse(o, "tolerance");
    lobe_objective objective = objective_of(problem("rosenbrock 2"));
    double x[2];
    objective.lower = NULL;
    assert_non_null(strstr(lobe_differential_evolution(&objective, NULL, x).reason, "bounds"));
    objective.upper = NULL;
    assert_non_null(strstr(lobe_differential_evolution(&objective, NULL, x).reason, "bounds"));
    objective = objective_of(problem("rosenbrock 2"));
    lower[1] = upper[1] + 1.0;
    assert_non_null(strstr(lobe_differential_evolution(&objective, NULL, x).reason, "above"));
}

static void latin_hypercube_fills_every_slice_once(void **state)
{
    static const double lo[3] = {0.0, -1.0, 5.0}, hi[3] = {1.0, 1.0, 25.0};
    lobe_random random;
    double x[20 * 3];
    (void)state;
    lobe_random_seed(&random, 7, 0);
    lobe_random_latin(&random, lo, hi, 3, 20, x);
    for (size_t k = 0; k < 3; k++) {
        int seen[20] = {0};
        for (size_t i = 0; i < 20; i++)
            seen[(size_t)((x[3 * i + k] - lo[k]) / (hi[k] - lo[k]) * 20.0)]++;
        for (size_t i = 0; i < 20; i++)
            assert_int_equal(seen[i], 1);
    }
}

/* Error of a parabola against cosine, on nested subsets of 257 points. */
static size_t strides[4], rows[4];

static void cosine_error(void *ctx, size_t level, const double *params, size_t count, double *values)
{
    (void)ctx;
    for (size_t i = 0; i < count; i++) {
        const double *x = params + 3 * i;
        values[i] = 0.0;
        for (size_t r = 0; r < 257; r += strides[level]) {
            const double t = (double)r / 256.0, e = fabs(x[0] + t * (x[1] + t * x[2]) - cos(t));
            values[i] = e > values[i] ? e : values[i];
        }
    }
}

static void screening_saves_rows_and_changes_nothing(void **state)
{
    static const double lo[3] = {-2.0, -2.0, -2.0}, hi[3] = {2.0, 2.0, 2.0};
    (void)state;
    lobe_levels_by_stride(257, 4, 4, strides, rows);
    assert_int_equal(strides[0], 64);
    assert_int_equal(rows[0], 5);
    assert_int_equal(rows[3], 257);
    const lobe_levels levels = {cosine_error, NULL, 3, 4, rows, lo, hi};
    lobe_coarse_to_fine_options o = lobe_coarse_to_fine_default();
    double x[3], y[3];
    const lobe_coarse_to_fine_result a = lobe_coarse_to_fine(&levels, &o, x);
    o.screen = false;
    const lobe_coarse_to_fine_result b = lobe_coarse_to_fine(&levels, &o, y);
    assert_memory_equal(x, y, sizeof x);
    assert_true(a.fit.value == b.fit.value);
    assert_true(a.rows < 0.7 * b.rows);
    for (size_t l = 1; l < 4; l++)
        assert_true(a.on_level[l] >= a.on_level[l - 1]);
    assert_true(fabs(a.fit.value - 2.49012e-3) < 0.02 * 2.49012e-3); /* sollya: remez(cos(x), 2, [0;1]) */
    const double chord[3] = {1.0, 0.0, -0.4597}; /* touches cosine at both ends: its largest error lies between rows */
    const lobe_level_estimate loose = lobe_levels_estimate(&levels, chord, 0.5);
    const lobe_level_estimate exact = lobe_levels_estimate(&levels, chord, 0.0);
    assert_int_equal(loose.level, 1);
    assert_int_equal(loose.rows, 5 + 17);
    assert_true(exact.level > 1 && exact.value > loose.value && loose.value > 0.9 * exact.value);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(evolution_finds_known_minima),
        cmocka_unit_test(polish_sharpens_the_global_stage),
        cmocka_unit_test(evolution_respects_bounds),
        cmocka_unit_test(equal_seeds_give_equal_bytes),
        cmocka_unit_test(threads_change_no_byte),
        cmocka_unit_test(every_stop_names_its_reason),
        cmocka_unit_test(interruption_keeps_the_best),
        cmocka_unit_test(bad_options_are_refused_with_a_reason),
        cmocka_unit_test(latin_hypercube_fills_every_slice_once),
        cmocka_unit_test(screening_saves_rows_and_changes_nothing),
    };
    return cmocka_run_group_tests_name("global optimisers", tests, NULL, NULL);
}
