#include "fan_fit.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../fit/least_squares.h"
#include "../fit/parallel.h"
#include "../fit/random.h"

enum { CELLS = LOBE_TRAINING_CELLS, ROWS = LOBE_CELL_ROWS, COLUMNS = 1 + 3 * LOBE_CELL_TAPS, TERMS = LOBE_FAN_TERMS };

typedef struct problem {
    lobe_fan_fit *fit;
    int taps;
    lobe_fan_point point[CELLS];
    const double *p; /* what the cells are asked about */
    bool slopes;
    double number[CELLS];
    double *block; /* of every cell: residuals, then slopes by angle, ln t and weight of every tap */
} problem;

/* A cell's residuals, and its slopes by the sums of every tap. */
static void ask_cells(void *ctx, const double *params, size_t count, double *values)
{
    const problem *q = ctx;
    const lobe_training *t = q->fit->training;
    const size_t width = q->slopes ? COLUMNS * ROWS : ROWS;
    double *scratch = malloc(sizeof *scratch * lobe_cell_scratch(t->cell[0]));
    for (size_t i = 0; scratch && i < count; i++) {
        const int c = (int)params[i];
        const double weight = sqrt(t->weight[c]);
        double *out = values + i * width, growth[LOBE_CELL_TAPS];
        lobe_cell_tap taps[LOBE_CELL_TAPS];
        (q->fit->free_energy ? lobe_fan_free_taps : lobe_fan_taps)(&q->point[c], q->p, q->taps, taps, growth);
        lobe_cell_residuals(t->cell[c], taps, q->taps, scratch, out, q->slopes ? out + ROWS : NULL);
        for (int k = 0; k < (q->slopes ? 1 + 3 * q->taps : 1); k++) {
            const int tap = (k - 1) / 3;
            const double scale = k == 0 || k % 3 == 0 ? 1 : k % 3 == 1 ? q->point[c].reach : growth[tap];
            for (int b = 0; b < ROWS; b++)
                out[k * ROWS + b] *= scale * weight;
        }
    }
    for (size_t i = 0; !scratch && i < count * width; i++)
        values[i] = NAN;
    free(scratch);
}

static void ask(problem *q, const double *p, bool slopes, double *values)
{
    lobe_parallel parallel = {ask_cells, q, 1, slopes ? COLUMNS * ROWS : ROWS, (size_t)q->fit->threads};
    q->p = p;
    q->slopes = slopes;
    lobe_parallel_eval(&parallel, q->number, CELLS, values);
}

static int count_of(const lobe_fan_fit *fit, int taps) { return lobe_fan_count(taps) + (fit->free_energy ? TERMS : 0); }

static void residuals(void *ctx, const double *params, size_t count, double *values)
{
    problem *q = ctx;
    for (size_t i = 0; i < count; i++)
        ask(q, params + i * (size_t)count_of(q->fit, q->taps), false, values + i * CELLS * ROWS);
}

static void jacobian(void *ctx, const double *params, double *transposed)
{
    problem *q = ctx;
    const int last = 3 * (q->taps - 1) + 2;
    ask(q, params, true, q->block);
    for (int k = 0; k < (q->fit->free_energy ? last + 1 : last); k++)
        for (int c = 0; c < CELLS; c++) {
            const double *slope = q->block + (c * COLUMNS + 1 + k) * ROWS;
            const double *rest = q->block + (c * COLUMNS + 1 + last) * ROWS;
            for (int i = 0; i < TERMS; i++) {
                double *out = transposed + ((size_t)(TERMS * k + i) * CELLS + (size_t)c) * ROWS;
                const double term = q->point[c].term[i];
                for (int b = 0; b < ROWS; b++)
                    out[b] = term * (slope[b] - (k % 3 == 2 && !q->fit->free_energy ? rest[b] : 0));
            }
        }
}

lobe_fit_result lobe_fan_improve(lobe_fan_fit *fit, int taps, int budget, double *p)
{
    problem *q = calloc(1, sizeof *q);
    lobe_residuals r = {0};
    lobe_ls_options o = lobe_ls_default();
    lobe_fit_result result = {0};
    if (q)
        q->block = malloc(sizeof *q->block * CELLS * COLUMNS * ROWS);
    if (!q || !q->block) {
        free(q);
        result.status = LOBE_FIT_NO_MEMORY;
        result.reason = "not enough memory";
        return result;
    }
    q->fit = fit;
    q->taps = taps;
    for (int c = 0; c < CELLS; c++) {
        q->number[c] = c;
        q->point[c] = lobe_fan_point_of(fit->training->alpha[c], fit->training->n_dot_v[c]);
    }
    r.f = residuals;
    r.jacobian = jacobian;
    r.ctx = q;
    r.dim = (size_t)count_of(fit, taps);
    r.rows = CELLS * ROWS;
    o.budget = (size_t)budget;
    o.ridge = 1e-9;
    o.value_tolerance = 2e-6;
    o.progress = lobe_progress_print;
    o.progress_ctx = &fit->line;
    result = lobe_least_squares(&r, &o, p);
    free(q->block);
    free(q);
    return result;
}

/* Taps in a row, as wide as the seed says. */
static void row_start(int taps, uint64_t seed, double *p)
{
    lobe_random r;
    double reach;
    lobe_random_seed(&r, 3, (uint64_t)taps + 100 * seed);
    reach = 0.6 + 1.2 * lobe_random_unit(&r);
    memset(p, 0, sizeof *p * LOBE_FAN_MOST);
    for (int i = 0; i < taps; i++) {
        const double at = taps > 1 ? 2.0 * i / (taps - 1) - 1 : 0;
        p[lobe_fan_first(i, 0) + 1] = -0.7 + reach * at;
        p[lobe_fan_first(i, 0) + 3] = -0.7;
        p[lobe_fan_first(i, 1)] =
            -0.6 - (taps > 1 ? 0.8 * lobe_random_unit(&r) : 0) + 0.3 * fabs(at) + 0.3 * (lobe_random_unit(&r) - 0.5);
        if (i < taps - 1)
            p[lobe_fan_first(i, 2)] = 1.0 / taps;
    }
}

/* Every tap of a fit of half as many becomes two, side by side. */
static void split_start(int taps, const double *half, uint64_t seed, double *p)
{
    lobe_random r;
    double last[TERMS] = {1};
    lobe_random_seed(&r, 5, (uint64_t)taps + 100 * seed);
    memset(p, 0, sizeof *p * LOBE_FAN_MOST);
    for (int j = 0; j < taps / 2 - 1; j++)
        for (int i = 0; i < TERMS; i++)
            last[i] -= half[lobe_fan_first(j, 2) + i];
    for (int k = 0; k < taps; k++) {
        const double *from = half + lobe_fan_first(k / 2, 0), *part = k / 2 < taps / 2 - 1 ? from + 2 * TERMS : last;
        double *to = p + lobe_fan_first(k, 0);
        memcpy(to, from, sizeof *to * 2 * TERMS);
        to[0] += (k % 2 ? 1 : -1) * (0.3 + 0.3 * (double)seed) * (0.5 + lobe_random_unit(&r));
        to[TERMS] -= 0.4 * lobe_random_unit(&r);
        for (int i = 0; k < taps - 1 && i < TERMS; i++)
            to[2 * TERMS + i] = 0.5 * part[i];
    }
}

lobe_fit_result lobe_fan_search(lobe_fan_fit *fit, int taps, const double *half, double *p)
{
    enum { STARTS = 5, SPLITS = 2 };
    double best[2][LOBE_FAN_MOST], value[2] = {INFINITY, INFINITY};
    lobe_fit_result result = {0};
    for (int s = half ? 0 : SPLITS; s < (taps > 1 ? STARTS : SPLITS + 1); s++) {
        double trial[LOBE_FAN_MOST];
        if (s < SPLITS)
            split_start(taps, half, (uint64_t)s, trial);
        else
            row_start(taps, (uint64_t)s, trial);
        result = lobe_fan_improve(fit, taps, 20, trial);
        if (result.status == LOBE_FIT_INTERRUPTED || result.status == LOBE_FIT_NO_MEMORY)
            return result;
        for (int k = 0; k < 2; k++) {
            if (result.value < value[k]) {
                if (k == 0) {
                    memcpy(best[1], best[0], sizeof trial);
                    value[1] = value[0];
                }
                memcpy(best[k], trial, sizeof trial);
                value[k] = result.value;
                break;
            }
        }
    }
    for (int k = 0; k < (taps > 1 ? 2 : 1); k++) {
        result = lobe_fan_improve(fit, taps, taps > 4 ? 80 : 100, best[k]);
        if (result.status == LOBE_FIT_INTERRUPTED || result.status == LOBE_FIT_NO_MEMORY)
            return result;
        value[k] = result.value;
    }
    if (taps > 1 && value[1] < value[0])
        memcpy(best[0], best[1], sizeof best[0]);
    memcpy(p, best[0], sizeof best[0]);
    result.value = taps > 1 ? fmin(value[0], value[1]) : value[0];
    return result;
}

void lobe_fan_score(const lobe_fan_fit *fit, int taps, const double *p, double error[LOBE_CELL_PARTS])
{
    const lobe_training *t = fit->training;
    double *scratch = malloc(sizeof *scratch * lobe_cell_scratch(t->cell[0])), count = 0;
    for (int k = 0; k < LOBE_CELL_PARTS; k++)
        error[k] = 0;
    for (int c = 0; scratch && c < CELLS; c++) {
        const lobe_fan_point point = lobe_fan_point_of(t->alpha[c], t->n_dot_v[c]);
        lobe_cell_tap tap[LOBE_CELL_TAPS];
        double part[LOBE_CELL_PARTS];
        if (t->alpha[c] < 0.04)
            continue;
        lobe_fan_taps(&point, p, taps, tap, NULL);
        lobe_cell_errors(t->cell[c], tap, taps, scratch, part);
        for (int k = 0; k < LOBE_CELL_PARTS; k++)
            error[k] += part[k];
        count++;
    }
    for (int k = 0; k < LOBE_CELL_PARTS; k++)
        error[k] = scratch ? sqrt(error[k] / count) : NAN;
    free(scratch);
}
