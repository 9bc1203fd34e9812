#include "coarse_to_fine.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void lobe_levels_by_stride(size_t rows, size_t factor, size_t levels, size_t *strides, size_t *counts)
{
    size_t stride = 1;
    for (size_t l = levels; l-- > 0; stride *= factor) {
        strides[l] = stride;
        counts[l] = (rows + stride - 1) / stride;
    }
}

size_t lobe_levels_screen(const lobe_levels *levels, const double *params, size_t count, const double *cutoffs,
                          double *values)
{
    const size_t n = levels->dim;
    double *alive = malloc((count * n + count) * sizeof *alive), *found = alive ? alive + count * n : NULL;
    size_t *index = malloc((count + 1) * sizeof *index), left = count, rows = 0;
    if (!alive || !index) {
        for (size_t i = 0; i < count; i++)
            values[i] = HUGE_VAL;
        free(alive);
        free(index);
        return 0;
    }
    memcpy(alive, params, count * n * sizeof *alive);
    for (size_t i = 0; i < count; i++)
        index[i] = i;
    for (size_t l = 0; l < levels->levels && left > 0; l++) {
        levels->f(levels->ctx, l, alive, left, found);
        rows += left * levels->rows[l];
        size_t kept = 0;
        for (size_t i = 0; i < left; i++) {
            values[index[i]] = found[i];
            if (found[i] <= cutoffs[index[i]]) { /* a NaN is out */
                memmove(alive + kept * n, alive + i * n, n * sizeof *alive);
                index[kept++] = index[i];
            }
        }
        left = kept;
    }
    free(alive);
    free(index);
    return rows;
}

lobe_level_estimate lobe_levels_estimate(const lobe_levels *levels, const double *params, double tolerance)
{
    lobe_level_estimate e = {0.0, HUGE_VAL, 0, 0};
    for (size_t l = 0; l < levels->levels; l++) {
        double value;
        levels->f(levels->ctx, l, params, 1, &value);
        e.rows += levels->rows[l];
        e.growth = l > 0 ? value - e.value : HUGE_VAL;
        e.value = value;
        e.level = l;
        if (l > 0 && e.growth <= tolerance * value)
            break;
    }
    return e;
}

lobe_coarse_to_fine_options lobe_coarse_to_fine_default(void)
{
    lobe_coarse_to_fine_options o = {0};
    o.global = lobe_de_default();
    o.global.value_tolerance = 1e-3;
    o.global.spread_tolerance = 1e-3;
    o.local = lobe_nm_default();
    o.local.size = 0.02;
    o.screen = true;
    return o;
}

typedef struct view {
    const lobe_levels *levels;
    size_t level;
    double rows;
} view;

static void on_level(void *ctx, const double *params, size_t count, double *values)
{
    view *v = ctx;
    v->levels->f(v->levels->ctx, v->level, params, count, values);
    v->rows += (double)count * (double)v->levels->rows[v->level];
}

static void screened(void *ctx, const double *params, size_t count, const double *cutoffs, double *values)
{
    view *v = ctx;
    v->rows += (double)lobe_levels_screen(v->levels, params, count, cutoffs, values);
}

static const char *check(const lobe_levels *levels, const lobe_coarse_to_fine_options *o)
{
    if (!levels || !levels->f || !levels->rows)
        return "no levels";
    if (levels->levels < 1 || levels->levels > LOBE_LEVELS_MAX)
        return "the number of levels must be in 1 .. 16";
    for (size_t l = 0; l < levels->levels; l++)
        if (levels->rows[l] < 1 || (l > 0 && levels->rows[l] < levels->rows[l - 1]))
            return "the rows of the levels must grow";
    if (o->polish_from >= levels->levels)
        return "polish_from is beyond the finest level";
    return NULL;
}

lobe_coarse_to_fine_result lobe_coarse_to_fine(const lobe_levels *levels, const lobe_coarse_to_fine_options *options,
                                               double *x)
{
    const lobe_coarse_to_fine_options o = options ? *options : lobe_coarse_to_fine_default();
    lobe_coarse_to_fine_result out = {{LOBE_FIT_BAD_INPUT, "", 0.0, 0, 0}, 0.0, {0}};
    out.fit.reason = check(levels, &o);
    if (out.fit.reason)
        return out;
    view v = {levels, levels->levels - 1, 0.0};
    lobe_objective objective = {on_level, &v, levels->dim, levels->lower, levels->upper, o.screen ? screened : NULL};
    out.fit = lobe_differential_evolution(&objective, &o.global, x);
    if (out.fit.status == LOBE_FIT_BAD_INPUT || out.fit.status == LOBE_FIT_NO_MEMORY)
        return out;
    double *tried = malloc(levels->dim * sizeof *tried);
    if (!tried) {
        out.fit = lobe_fit_no_memory();
        return out;
    }
    memcpy(tried, x, levels->dim * sizeof *x);
    objective.race = NULL;
    for (size_t l = o.polish_from; l < levels->levels && out.fit.status != LOBE_FIT_INTERRUPTED; l++) {
        v.level = l;
        lobe_fit_result r = lobe_nelder_mead(&objective, &o.local, tried);
        if (r.status == LOBE_FIT_BAD_INPUT || r.status == LOBE_FIT_NO_MEMORY) {
            out.fit.status = r.status;
            out.fit.reason = r.reason;
            break;
        }
        out.fit.evaluations += r.evaluations;
        out.fit.iterations += r.iterations;
        out.fit.status = r.status;
        out.fit.reason = r.reason;
    }
    for (size_t l = 0; l < levels->levels; l++)
        levels->f(levels->ctx, l, tried, 1, &out.on_level[l]);
    out.fit.evaluations++;
    if (out.on_level[levels->levels - 1] < out.fit.value) {
        out.fit.value = out.on_level[levels->levels - 1];
        memcpy(x, tried, levels->dim * sizeof *x);
    } else { /* a polish on coarse rows may lose on the fine ones */
        for (size_t l = 0; l < levels->levels; l++)
            levels->f(levels->ctx, l, x, 1, &out.on_level[l]);
    }
    out.rows = v.rows;
    free(tried);
    return out;
}
