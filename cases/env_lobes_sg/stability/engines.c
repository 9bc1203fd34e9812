/* Which engine gets to the bottom, from the analytic start and from anywhere; and where random starts end. */
#include <lbfgs.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../../fit/differential_evolution.h"
#include "experiment.h"

enum { POINTS = 12, RANDOM = 20 };
static const double points[POINTS][2] = {{0.04, 0.1}, {0.04, 0.5}, {0.1, 0.1}, {0.1, 0.3}, {0.1, 0.8}, {0.2, 0.2},
                                         {0.2, 0.6},  {0.4, 0.1},  {0.4, 0.5}, {0.7, 0.2}, {0.7, 0.7}, {1, 0.4}};

typedef struct counted {
    const lobe_shape_fit *fit;
    size_t evaluations;
} counted;

/* Central differences, as for any objective without derivatives. */
static lbfgsfloatval_t value_and_slope(void *ctx, const lbfgsfloatval_t *x, lbfgsfloatval_t *slope, const int n,
                                       const lbfgsfloatval_t step)
{
    counted *c = ctx;
    double moved[LOBE_EXPERIMENT_MOST], value, up, down;
    int i;
    (void)step;
    memcpy(moved, x, sizeof *x * (size_t)n);
    lobe_shape_errors((void *)c->fit, moved, 1, &value);
    for (i = 0; i < n; i++) {
        moved[i] = x[i] + 1e-6;
        lobe_shape_errors((void *)c->fit, moved, 1, &up);
        moved[i] = x[i] - 1e-6;
        lobe_shape_errors((void *)c->fit, moved, 1, &down);
        moved[i] = x[i];
        slope[i] = (up - down) / 2e-6;
    }
    c->evaluations += 1 + 2 * (size_t)n;
    return value;
}

static double run_lbfgs(const lobe_shape_fit *fit, double *x, size_t *evaluations)
{
    const int n = lobe_shape_parameters(fit);
    lbfgsfloatval_t *at = lbfgs_malloc(n), value = 10;
    lbfgs_parameter_t o;
    counted c = {fit, 0};
    if (!at)
        return 10;
    lbfgs_parameter_init(&o);
    o.max_iterations = 200;
    memcpy(at, x, sizeof *x * (size_t)n);
    lbfgs(n, at, &value, value_and_slope, NULL, &c, &o);
    memcpy(x, at, sizeof *x * (size_t)n);
    lbfgs_free(at);
    *evaluations = c.evaluations;
    return value;
}

static double run_evolution(const lobe_shape_fit *fit, double *x, size_t *evaluations)
{
    double lower[LOBE_EXPERIMENT_MOST], upper[LOBE_EXPERIMENT_MOST];
    lobe_shape_fit copy = *fit;
    lobe_objective objective = {.f = lobe_shape_errors,
                                .ctx = &copy,
                                .dim = (size_t)lobe_shape_parameters(fit),
                                .lower = lower,
                                .upper = upper};
    lobe_de_options o = lobe_de_default();
    lobe_fit_result r;
    lobe_shape_box(fit, lower, upper);
    o.seed = 5;
    o.budget = fit->free ? 12000 : 3000;
    r = lobe_differential_evolution(&objective, &o, x);
    *evaluations = r.evaluations;
    return r.value;
}

static double run_nelder_mead(const lobe_shape_fit *fit, double *x, size_t *evaluations)
{
    const lobe_fit_result r = lobe_shape_nelder_mead(fit, fit->free ? 12000 : 3000, x);
    *evaluations = r.evaluations;
    return r.value;
}

bool lobe_experiment_optimisers(FILE *out)
{
    static const struct {
        const char *name;
        double (*run)(const lobe_shape_fit *fit, double *x, size_t *evaluations);
    } engines[] = {{"Nelder-Mead", run_nelder_mead}, {"L-BFGS", run_lbfgs}, {"differential evolution", run_evolution}};
    size_t e;
    int free_lobes, p, from;
    fputs("lobes,start,engine,rms_error,worst_error,mean_evaluations\n", out);
    for (free_lobes = 0; free_lobes < 2; free_lobes++)
        for (from = 0; from < 2; from++)
            for (e = 0; e < sizeof engines / sizeof engines[0]; e++) {
                double square = 0, worst = 0, all = 0;
                lobe_random random;
                if (from == 1 && e == 2)
                    continue; /* it has no start */
                lobe_random_seed(&random, 31, 0);
                for (p = 0; p < POINTS; p++) {
                    lobe_sg_target target;
                    lobe_shape_fit fit = {.target = &target, .count = 4, .free = free_lobes};
                    double x[LOBE_EXPERIMENT_MOST], value;
                    size_t evaluations;
                    if (!lobe_sg_target_make(&target, points[p][0], points[p][1], 28))
                        return false;
                    if (from == 0)
                        lobe_shape_start(&fit, x);
                    else
                        lobe_shape_random(&fit, &random, x);
                    value = engines[e].run(&fit, x, &evaluations);
                    square += value * value / POINTS;
                    worst = fmax(worst, value);
                    all += (double)evaluations / POINTS;
                    lobe_sg_target_free(&target);
                }
                fprintf(out, "%s,%s,%s,%.4f,%.4f,%.0f\n", free_lobes ? "4 free" : "fan of 4",
                        e == 2 ? "box"
                        : from ? "random"
                               : "analytic",
                        engines[e].name, sqrt(square), worst, all);
            }
    return true;
}

bool lobe_experiment_starts(FILE *out)
{
    int p, i;
    fputs("alpha,n_dot_v,random_success,on_plateau,best_of_20,best_of_first_4,analytic\n", out);
    for (p = 0; p < POINTS; p++) {
        lobe_sg_target target;
        lobe_shape_fit fit = {.target = &target, .count = 4};
        double x[LOBE_EXPERIMENT_MOST], values[RANDOM], best = 10, best4 = 10, analytic;
        lobe_random random;
        int good = 0, flat = 0;
        if (!lobe_sg_target_make(&target, points[p][0], points[p][1], 28))
            return false;
        lobe_shape_start(&fit, x);
        analytic = lobe_shape_nelder_mead(&fit, 400, x).value;
        lobe_random_seed(&random, 32, (uint64_t)p);
        for (i = 0; i < RANDOM; i++) {
            lobe_shape_random(&fit, &random, x);
            values[i] = lobe_shape_nelder_mead(&fit, 400, x).value;
            best = fmin(best, values[i]);
            if (i < 4)
                best4 = best;
        }
        best = fmin(best, analytic);
        for (i = 0; i < RANDOM; i++) {
            good += values[i] < 1.05 * best + 0.002;
            flat += values[i] > 0.9;
        }
        fprintf(out, "%g,%g,%.2f,%.2f,%.4f,%.4f,%.4f\n", points[p][0], points[p][1], (double)good / RANDOM,
                (double)flat / RANDOM, best, best4, analytic);
        lobe_sg_target_free(&target);
    }
    return true;
}
