/* Success rates and costs of our engines beside those of nlopt, liblbfgs and cminpack, as a table on standard output.
 * Every engine sees the same 50 random starts or seeds and the same budget; evaluations are counted outside the engine,
 * up to the first value that counts as a success, so that stop criteria do not blur the comparison. */
#include "../fit/global_local.h"
#include "../fit/random.h"
#include "optimiser_problems.h"

#include <cminpack-1/cminpack.h>
#include <lbfgs.h>
#include <math.h>
#include <nlopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SEEDS 50
static const double near = 1e-6, near_sum = 1e-5; /* minima are published with six digits */

/* Counts evaluations, remembers the one that first came near enough, and says when the budget is spent. */
typedef struct counter {
    const lobe_value_problem *values;
    const lobe_square_problem *squares;
    size_t evaluations, hit, budget;
} counter;

static void note(counter *c, double distance, double enough)
{
    c->evaluations++;
    if (c->hit == 0 && distance <= enough)
        c->hit = c->evaluations;
}

static double value_at(counter *c, const double *x)
{
    const double value = c->values->value(x, c->values->dim);
    note(c, value, near);
    return value;
}

static void batch(void *ctx, const double *params, size_t count, double *values)
{
    counter *c = ctx;
    for (size_t i = 0; i < count; i++)
        values[i] = value_at(c, params + i * c->values->dim);
}

typedef struct run {
    counter *c;
    const double *lower, *upper;
    uint64_t seed;
    double *x;
} run;

static lobe_objective objective_of(const run *r)
{
    lobe_objective o = {batch, r->c, r->c->values->dim, r->lower, r->upper, NULL};
    return o;
}

static void evolution(const run *r, lobe_de_strategy strategy)
{
    const lobe_objective objective = objective_of(r);
    lobe_de_options o = lobe_de_default();
    o.strategy = strategy;
    o.seed = r->seed;
    o.budget = r->c->budget;
    lobe_differential_evolution(&objective, &o, r->x);
}

static void ours_rand(const run *r) { evolution(r, LOBE_DE_RAND_1_BIN); }
static void ours_best(const run *r) { evolution(r, LOBE_DE_BEST_1_BIN); }

static void ours_global_local(const run *r)
{
    const lobe_objective objective = objective_of(r);
    lobe_global_local_options o = lobe_global_local_default();
    o.global.seed = r->seed;
    o.budget = r->c->budget;
    lobe_global_local(&objective, &o, r->x);
}

static void simplex(const run *r, size_t starts)
{
    const lobe_objective objective = objective_of(r);
    lobe_nm_options o = lobe_nm_default();
    o.starts = starts;
    o.seed = r->seed;
    o.budget = r->c->budget;
    lobe_nelder_mead(&objective, &o, r->x);
}

static void ours_simplex(const run *r) { simplex(r, 1); }
static void ours_simplex_20(const run *r) { simplex(r, 20); }

static double nlopt_value(unsigned n, const double *x, double *gradient, void *ctx)
{
    (void)n, (void)gradient;
    return value_at(ctx, x);
}

static void with_nlopt(const run *r, nlopt_algorithm algorithm)
{
    nlopt_opt opt = nlopt_create(algorithm, (unsigned)r->c->values->dim);
    double value;
    nlopt_srand((unsigned long)r->seed);
    nlopt_set_lower_bounds(opt, r->lower);
    nlopt_set_upper_bounds(opt, r->upper);
    nlopt_set_min_objective(opt, nlopt_value, r->c);
    nlopt_set_maxeval(opt, (int)r->c->budget);
    nlopt_set_xtol_rel(opt, 1e-12);
    nlopt_set_stopval(opt, 1e-14);
    nlopt_optimize(opt, r->x, &value);
    nlopt_destroy(opt);
}

static void nlopt_simplex(const run *r) { with_nlopt(r, NLOPT_LN_NELDERMEAD); }
static void nlopt_crs2(const run *r) { with_nlopt(r, NLOPT_GN_CRS2_LM); }
static void nlopt_isres(const run *r) { with_nlopt(r, NLOPT_GN_ISRES); }

/* The gradient by central differences: 2 dim evaluations, which count. */
static lbfgsfloatval_t lbfgs_value(void *ctx, const lbfgsfloatval_t *x, lbfgsfloatval_t *g, const int n,
                                   const lbfgsfloatval_t step)
{
    double moved[LOBE_PROBLEM_MAX_DIM];
    (void)step;
    memcpy(moved, x, (size_t)n * sizeof *x);
    for (int k = 0; k < n; k++) {
        const double h = 6e-6 * (fabs(x[k]) > 1.0 ? fabs(x[k]) : 1.0);
        moved[k] = x[k] + h;
        const double above = value_at(ctx, moved);
        moved[k] = x[k] - h;
        g[k] = (above - value_at(ctx, moved)) / (2.0 * h);
        moved[k] = x[k];
    }
    return value_at(ctx, x);
}

static int lbfgs_progress(void *ctx, const lbfgsfloatval_t *x, const lbfgsfloatval_t *g, const lbfgsfloatval_t value,
                          const lbfgsfloatval_t x_length, const lbfgsfloatval_t g_length, const lbfgsfloatval_t step,
                          int n, int k, int tries)
{
    const counter *c = ctx;
    (void)x, (void)g, (void)value, (void)x_length, (void)g_length, (void)step, (void)n, (void)k, (void)tries;
    return c->evaluations >= c->budget;
}

static void with_lbfgs(const run *r)
{
    lbfgs_parameter_t o;
    lbfgs_parameter_init(&o);
    o.epsilon = 1e-9;
    lbfgsfloatval_t *x = lbfgs_malloc((int)r->c->values->dim); /* aligned for its vector code */
    memcpy(x, r->x, r->c->values->dim * sizeof *x);
    lbfgs((int)r->c->values->dim, x, NULL, lbfgs_value, lbfgs_progress, r->c, &o);
    lbfgs_free(x);
}

static int by_size(const void *a, const void *b)
{
    const size_t x = *(const size_t *)a, y = *(const size_t *)b;
    return (x > y) - (x < y);
}

static void row(const char *problem, const char *engine, size_t *hits, size_t successes, size_t *spent)
{
    qsort(hits, successes, sizeof *hits, by_size);
    qsort(spent, SEEDS, sizeof *spent, by_size);
    printf("%-16s %-28s %3zu/%d ", problem, engine, successes, SEEDS);
    if (successes > 0)
        printf("%10zu", hits[successes / 2]);
    else
        printf("%10s", "-");
    printf(" %10zu\n", spent[SEEDS / 2]);
}

static const struct {
    const char *name;
    void (*go)(const run *r);
} engines[] = {
    {"lobe evolution rand/1/bin", ours_rand},
    {"lobe evolution best/1/bin", ours_best},
    {"lobe global, then local", ours_global_local},
    {"lobe Nelder-Mead 20 starts", ours_simplex_20},
    {"nlopt CRS2_LM", nlopt_crs2},
    {"nlopt ISRES", nlopt_isres},
    {"lobe Nelder-Mead", ours_simplex},
    {"nlopt NELDERMEAD", nlopt_simplex},
    {"lbfgs", with_lbfgs},
};

static void compare_values(const lobe_value_problem *problem)
{
    double lower[LOBE_PROBLEM_MAX_DIM], upper[LOBE_PROBLEM_MAX_DIM];
    for (size_t k = 0; k < problem->dim; k++) {
        lower[k] = problem->lower;
        upper[k] = problem->upper;
    }
    for (size_t e = 0; e < sizeof engines / sizeof *engines; e++) {
        size_t hits[SEEDS], spent[SEEDS], successes = 0;
        for (size_t seed = 0; seed < SEEDS; seed++) {
            double x[LOBE_PROBLEM_MAX_DIM];
            counter c = {problem, NULL, 0, 0, 20000 * problem->dim};
            lobe_random random;
            lobe_random_seed(&random, seed + 1, 99);
            for (size_t k = 0; k < problem->dim; k++)
                x[k] = lower[k] + (upper[k] - lower[k]) * lobe_random_unit(&random);
            const run r = {&c, lower, upper, seed + 1, x};
            engines[e].go(&r);
            if (c.hit > 0 && c.hit <= c.budget)
                hits[successes++] = c.hit;
            spent[seed] = c.evaluations;
        }
        row(problem->name, engines[e].name, hits, successes, spent);
    }
}

static void squares_at(counter *c, const double *x, double *r)
{
    double sum = 0.0;
    c->squares->residual(x, r);
    for (size_t i = 0; i < c->squares->rows; i++)
        sum += r[i] * r[i];
    note(c, (sum - c->squares->minimum) / (c->squares->minimum > 0.0 ? c->squares->minimum : 1e-6), near_sum);
}

static void squares_batch(void *ctx, const double *params, size_t count, double *values)
{
    counter *c = ctx;
    for (size_t i = 0; i < count; i++)
        squares_at(c, params + i * c->squares->dim, values + i * c->squares->rows);
}

static int lmdif_rows(void *ctx, int m, int n, const double *x, double *r, int flag)
{
    (void)m, (void)n, (void)flag;
    squares_at(ctx, x, r);
    return 0;
}

static void ours_squares(counter *c, double *x)
{
    const lobe_residuals residuals = {squares_batch, NULL, c, c->squares->dim, c->squares->rows, NULL, NULL, NULL};
    lobe_ls_options o = lobe_ls_default();
    o.budget = c->budget;
    lobe_least_squares(&residuals, &o, x);
}

static void minpack_squares(counter *c, double *x)
{
    const int m = (int)c->squares->rows, n = (int)c->squares->dim;
    double r[LOBE_PROBLEM_MAX_ROWS], diag[LOBE_PROBLEM_MAX_DIM], qtf[LOBE_PROBLEM_MAX_DIM], w1[LOBE_PROBLEM_MAX_DIM],
        w2[LOBE_PROBLEM_MAX_DIM], w3[LOBE_PROBLEM_MAX_DIM], w4[LOBE_PROBLEM_MAX_ROWS],
        jacobian[LOBE_PROBLEM_MAX_ROWS * LOBE_PROBLEM_MAX_DIM];
    int pivot[LOBE_PROBLEM_MAX_DIM], evaluations;
    lmdif(lmdif_rows, c, m, n, x, r, 1e-14, 1e-13, 0.0, (int)c->budget, 0.0, diag, 1, 100.0, 0, &evaluations, jacobian,
          m, pivot, qtf, w1, w2, w3, w4);
}

static void compare_squares(const lobe_square_problem *problem)
{
    for (int engine = 0; engine < 2; engine++) {
        size_t hits[SEEDS], spent[SEEDS], successes = 0;
        for (size_t seed = 0; seed < SEEDS; seed++) {
            double x[LOBE_PROBLEM_MAX_DIM];
            counter c = {NULL, problem, 0, 0, 2000 * problem->dim};
            lobe_random random;
            lobe_random_seed(&random, seed + 1, 98);
            for (size_t k = 0; k < problem->dim; k++) /* the first start is the published one */
                x[k] = problem->start[k] * (seed == 0 ? 1.0 : 0.5 + lobe_random_unit(&random));
            if (engine == 0)
                ours_squares(&c, x);
            else
                minpack_squares(&c, x);
            if (c.hit > 0)
                hits[successes++] = c.hit;
            spent[seed] = c.evaluations;
        }
        row(problem->name, engine == 0 ? "lobe least squares" : "cminpack lmdif", hits, successes, spent);
    }
}

int main(void)
{
    printf(
        "# Written by `make optimiser-table`.\n"
        "# %d seeds or random starts an engine. A success is a value <= %g, in least squares a sum that exceeds the\n"
        "# published minimum by <= %g of it (of 1e-6 where it is 0). To success: median evaluations up to the first\n"
        "# such value, over the successes; spent: median evaluations until the engine stopped by itself or at its\n"
        "# budget, 20000 a parameter (least squares: 2000). One start: the last three engines of each problem.\n"
        "%-16s %-28s %6s %10s %10s\n",
        SEEDS, near, near_sum, "# problem", "engine", "success", "to success", "spent");
    for (size_t i = 0; i < lobe_value_problem_count; i++)
        compare_values(&lobe_value_problems[i]);
    for (size_t i = 0; i < lobe_square_problem_count; i++)
        compare_squares(&lobe_square_problems[i]);
    return 0;
}
