#include <math.h>
#include <string.h>
#include "../../fit/nelder_mead.h"
#include "experiment.h"

static double value_of(const lobe_shape_fit *fit, const double *x)
{
    lobe_sg lobes[LOBE_SG_MOST];
    double error, worst = 0;
    int i;
    lobe_shape_lobes(fit, x, lobes);
    for (i = 0; i < fit->count; i++) {
        worst = fmax(worst, fabs(lobes[i].angle) - 3.2);
        worst = fmax(worst, fabs(log(lobes[i].sharpness) - 4) - 7);
        if (!(fabs(lobes[i].weight) < 100))
            return 20;
    }
    if (worst > 0)
        return 10 + fmin(worst, 10);
    if (fit->estimate)
        return fit->estimate(fit->estimate_ctx, lobes, fit->count);
    if (!fit->any_amplitude)
        return lobe_sg_target_error(fit->target, lobes, fit->count);
    lobe_sg_target_amplitude(fit->target, lobes, fit->count, &error);
    return error;
}

int lobe_shape_parameters(const lobe_shape_fit *fit) { return fit->free ? 3 * fit->count : LOBE_FAN_PARAMETERS; }

void lobe_shape_lobes(const lobe_shape_fit *fit, const double *x, lobe_sg *lobes)
{
    double sum = 0;
    int i;
    if (!fit->free) {
        lobe_sg_fan fan = {.centre = x[0], .sharpness = exp(x[1]), .spread = exp(x[2]), .taper = x[3]};
        if (fit->within)
            fan.spread = fmin(fan.spread, fmax(0, fan.centre));
        lobe_sg_fan_lobes(&fan, fit->count, fit->target->albedo, lobes);
        return;
    }
    for (i = 0; i < fit->count; i++) {
        lobes[i].angle = x[3 * i];
        lobes[i].sharpness = exp(x[3 * i + 1]);
        lobes[i].weight = exp(fmin(x[3 * i + 2], 50));
        sum += lobes[i].weight;
    }
    for (i = 0; i < fit->count; i++)
        lobes[i].weight *= fit->target->albedo / sum;
}

void lobe_shape_errors(void *ctx, const double *x, size_t count, double *values)
{
    const lobe_shape_fit *fit = ctx;
    size_t i;
    for (i = 0; i < count; i++)
        values[i] = value_of(fit, x + i * (size_t)lobe_shape_parameters(fit));
}

void lobe_shape_start(const lobe_shape_fit *fit, double *x)
{
    const lobe_sg_fan fan = lobe_sg_fan_start(fit->target->alpha, fit->target->n_dot_v);
    lobe_sg lobes[LOBE_SG_MOST];
    int i;
    if (!fit->free) {
        x[0] = fan.centre;
        x[1] = log(fan.sharpness);
        x[2] = log(fan.spread);
        x[3] = fan.taper;
        return;
    }
    lobe_sg_fan_lobes(&fan, fit->count, 1, lobes);
    for (i = 0; i < fit->count; i++) {
        x[3 * i] = lobes[i].angle;
        x[3 * i + 1] = log(lobes[i].sharpness);
        x[3 * i + 2] = log(lobes[i].weight);
    }
}

void lobe_shape_box(const lobe_shape_fit *fit, double *lower, double *upper)
{
    const double fan[2][LOBE_FAN_PARAMETERS] = {{0, 0, -5, -2}, {1.6, 9, 0.5, 12}};
    const double lobe[2][3] = {{0, 0, -5}, {1.6, 9, 0}};
    int i;
    if (!fit->free) {
        memcpy(lower, fan[0], sizeof fan[0]);
        memcpy(upper, fan[1], sizeof fan[1]);
        return;
    }
    for (i = 0; i < fit->count; i++) {
        memcpy(lower + 3 * i, lobe[0], sizeof lobe[0]);
        memcpy(upper + 3 * i, lobe[1], sizeof lobe[1]);
    }
}

void lobe_shape_random(const lobe_shape_fit *fit, lobe_random *random, double *x)
{
    double lower[LOBE_EXPERIMENT_MOST], upper[LOBE_EXPERIMENT_MOST];
    int i;
    lobe_shape_box(fit, lower, upper);
    for (i = 0; i < lobe_shape_parameters(fit); i++)
        x[i] = lower[i] + (upper[i] - lower[i]) * lobe_random_unit(random);
}

/* A first simplex in proportion to the lobe: a tenth of alpha in angle, a third in sharpness, spread and weight. */
lobe_fit_result lobe_shape_nelder_mead(const lobe_shape_fit *fit, size_t budget, double *x)
{
    const size_t dim = (size_t)lobe_shape_parameters(fit);
    double simplex[(LOBE_EXPERIMENT_MOST + 1) * LOBE_EXPERIMENT_MOST];
    lobe_shape_fit copy = *fit;
    lobe_objective objective = {.f = lobe_shape_errors, .ctx = &copy, .dim = dim};
    lobe_nm_options o = lobe_nm_default();
    size_t i;
    for (i = 0; i <= dim; i++) {
        memcpy(simplex + i * dim, x, dim * sizeof *x);
        if (i > 0) {
            const bool angle = fit->free ? (i - 1) % 3 == 0 : i == 1;
            simplex[i * dim + i - 1] += angle ? 0.1 * fit->target->alpha : 0.35;
        }
    }
    o.simplex = simplex;
    o.starts = 1;
    o.restarts = 2;
    o.budget = budget;
    o.value_tolerance = 1e-7;
    o.size_tolerance = 1e-5;
    return lobe_nelder_mead(&objective, &o, x);
}
