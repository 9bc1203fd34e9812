#include "objective.h"

#include <math.h>

static const char *box_check(const double *lower, const double *upper, size_t dim, bool need_box)
{
    if (!lower != !upper)
        return "one of the bounds is missing: give both or neither";
    if (!lower)
        return need_box ? "this engine needs bounds" : NULL;
    for (size_t i = 0; i < dim; i++) {
        if (isnan(lower[i]) || isnan(upper[i]) || (need_box && (isinf(lower[i]) || isinf(upper[i]))))
            return "a bound is not a finite number";
        if (lower[i] > upper[i])
            return "a lower bound is above its upper bound";
    }
    return NULL;
}

const char *lobe_objective_check(const lobe_objective *objective, bool need_box)
{
    if (!objective || !objective->f)
        return "no objective function";
    if (objective->dim < 1)
        return "no parameters";
    return box_check(objective->lower, objective->upper, objective->dim, need_box);
}

const char *lobe_residuals_check(const lobe_residuals *residuals)
{
    if (!residuals || !residuals->f)
        return "no residual function";
    if (residuals->dim < 1)
        return "no parameters";
    if (residuals->rows < 1)
        return "no rows";
    if (residuals->weights)
        for (size_t r = 0; r < residuals->rows; r++)
            if (!(residuals->weights[r] >= 0.0 && isfinite(residuals->weights[r])))
                return "a weight is negative or not finite";
    return box_check(residuals->lower, residuals->upper, residuals->dim, false);
}

void lobe_box_clamp(const double *lower, const double *upper, size_t dim, double *x)
{
    if (!lower)
        return;
    for (size_t i = 0; i < dim; i++) {
        if (x[i] < lower[i])
            x[i] = lower[i];
        if (x[i] > upper[i])
            x[i] = upper[i];
    }
}

void lobe_objective_eval(const lobe_objective *objective, const double *params, size_t count, double *values)
{
    objective->f(objective->ctx, params, count, values);
    for (size_t i = 0; i < count; i++)
        if (isnan(values[i]))
            values[i] = HUGE_VAL;
}
