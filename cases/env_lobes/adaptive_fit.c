#include "adaptive_fit.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../fit/parallel.h"
#include "normal_equations.h"

enum {
    MOST = LOBE_ADAPTIVE_CELLS,
    CELL_ROWS = LOBE_CELL_ROWS,
    ROWS = LOBE_CELL_ROWS + LOBE_ADAPTIVE_TAPS, /* a cell's and what is asked for its weights */
    COUNT = LOBE_ADAPTIVE_COUNT,
    TERMS = LOBE_ADAPTIVE_TERMS,
    TAPS = LOBE_ADAPTIVE_TAPS,
    NEEDS = LOBE_ADAPTIVE_NEEDS,
    COLUMNS = 1 + 3 * TAPS /* residuals, then slopes: shift, width and part of every tap, the first's part aside */
};
#define RIDGE 1e-7
/* On the square of a weight: fans of weights that all but cancel each other are no use to half floats. */
#define SQUARES 3e-5

typedef struct problem {
    lobe_adaptive_fit *fit;
    const double *p; /* what the cells are asked about */
    bool slopes;
    double number[MOST];
    double *block; /* of every cell COLUMNS of ROWS; the need's slope is last */
    double (*square)[LOBE_ADAPTIVE_NEEDS];
    lobe_normal_equations *equations;
} problem;

/* What part of the judge's points lies in [lo, hi] of n_dot_v: a fifth within the borders of each. */
static double judged_view(double lo, double hi)
{
    static const double border[6] = {0, .15, .375, .625, .875, 1};
    double part = 0;
    for (int i = 0; i < 5; i++)
        part += 0.2 * fmax(0, fmin(hi, border[i + 1]) - fmax(lo, border[i])) / (border[i + 1] - border[i]);
    return part;
}

/* What part of them lies between these two of alpha, in even steps of its logarithm as they are. */
static double judged_alpha(double lo, double hi) { return fmax(0, log(fmin(1.2, hi) / fmax(.034, lo))); }

void lobe_adaptive_fit_of(lobe_cell *const *cell, const lobe_fan_point *point, int rows, int columns,
                          const double *share, int threads, lobe_adaptive_fit *fit)
{
    double total = 0;
    memset(fit, 0, sizeof *fit);
    fit->count = rows * columns;
    fit->cell = cell;
    fit->share = share;
    fit->threads = threads;
    fit->line = lobe_progress_line_default();
    memcpy(fit->point, point, sizeof *point * (size_t)fit->count);
    for (int c = 0; c < fit->count; c++) {
        const int j = c % columns;
        const bool first = c < columns, last = c + columns >= fit->count;
        const double alpha = point[c].alpha, before = first ? 0 : point[c - columns].alpha,
                     after = last ? 1 : point[c + columns].alpha;
        const double left = j ? 0.5 * (point[c].n_dot_v + point[c - 1].n_dot_v) : 0;
        const double right = j + 1 < columns ? 0.5 * (point[c].n_dot_v + point[c + 1].n_dot_v) : 1;
        const double low = first ? 0 : 0.5 * (sqrt(alpha) + sqrt(before));
        const double high = last ? 1 : 0.5 * (sqrt(alpha) + sqrt(after));
        const double share_of_alpha = judged_alpha(sqrt(alpha * before), last ? 1.2 : sqrt(alpha * after));
        fit->weight[c] = (alpha < 0.04 ? fmax(0.06, share_of_alpha) : share_of_alpha) * judged_view(left, right);
        fit->area[c] = (high - low) * (right - left);
        total += fit->weight[c];
    }
    for (int c = 0; c < fit->count; c++)
        fit->weight[c] /= total;
}

/* A cell's residuals, and its slopes by what every tap is summed from. Below them the weights with their price. */
static void ask_cells(void *ctx, const double *params, size_t count, double *values)
{
    const problem *q = ctx;
    lobe_cell *const *cell = q->fit->cell;
    const size_t width = q->slopes ? COLUMNS * ROWS : ROWS;
    double *scratch = malloc(sizeof *scratch * (lobe_cell_scratch(cell[0]) + 3 * TAPS * CELL_ROWS));
    double *slope = scratch ? scratch + lobe_cell_scratch(cell[0]) : NULL;
    for (size_t i = 0; scratch && i < count; i++) {
        const int c = (int)params[i];
        const double weight = sqrt(q->fit->weight[c]), priced = sqrt(SQUARES * q->fit->weight[c]);
        double *out = values + i * width, *need = out + (COLUMNS - 1) * ROWS;
        lobe_adaptive_fan fan;
        lobe_adaptive_taps(&q->fit->point[c], q->p, q->fit->softness, &fan);
        lobe_cell_residuals(cell[c], fan.tap, fan.count, scratch, out, q->slopes ? slope : NULL);
        for (int b = 0; b < CELL_ROWS; b++)
            out[b] *= weight;
        for (int k = 0; k < TAPS; k++)
            out[CELL_ROWS + k] = k < fan.count ? priced * fan.tap[k].weight : 0;
        if (!q->slopes)
            continue;
        memset(out + ROWS, 0, sizeof *out * (COLUMNS - 1) * ROWS);
        for (int k = 0; k < fan.count; k++) {
            const double *by_angle = slope + 3 * k * CELL_ROWS, *by_log_t = by_angle + CELL_ROWS,
                         *by_weight = by_log_t + CELL_ROWS;
            double *shift = out + (1 + (k ? 3 * k - 1 : 0)) * ROWS, *wide = shift + ROWS, *part = wide + ROWS;
            for (int b = 0; b < CELL_ROWS; b++) {
                shift[b] = weight * fan.angle_by_shift[k] * by_angle[b];
                wide[b] = weight * fan.log_t_by_width[k] * by_log_t[b];
                need[b] += weight * (fan.angle_by_need[k] * by_angle[b] + fan.log_t_by_need[k] * by_log_t[b] +
                                     fan.weight_by_need[k] * by_weight[b]);
                if (k)
                    part[b] = weight * fan.gate[k] * (by_weight[b] - slope[2 * CELL_ROWS + b]);
            }
            need[CELL_ROWS + k] = priced * fan.weight_by_need[k];
            if (k) {
                part[CELL_ROWS + k] = priced * fan.gate[k];
                part[CELL_ROWS] = -priced * fan.gate[k];
            }
        }
    }
    for (size_t i = 0; !scratch && i < count * width; i++)
        values[i] = NAN;
    free(scratch);
}

/* Mean number of taps with its steps rounded off, each a blur early, so that it pays to leave a border well behind, and
 * its slopes by the need's coefficients unless NULL. */
static double priced(const problem *q, const double *p, double *slope)
{
    enum { SIDE = LOBE_ADAPTIVE_SIDE };
    double taps = 1;
    for (int j = 0; slope && j < NEEDS; j++)
        slope[j] = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        double need = 0, by_need = 0;
        for (int j = 0; j < NEEDS; j++)
            need += p[j] * q->square[i][j];
        for (int k = 0; k < LOBE_ADAPTIVE_GATES; k++) {
            const double y = 1 / (1 + exp(fmin(700, (k - need) / q->fit->blur - 1)));
            taps += y / (SIDE * SIDE);
            by_need += y * (1 - y) / (q->fit->blur * SIDE * SIDE);
        }
        for (int j = 0; slope && j < NEEDS; j++)
            slope[j] += by_need * q->square[i][j];
    }
    return taps;
}

/* The objective; with slopes, half its gradient and half of what stands for its second derivatives, too. */
static double ask(problem *q, const double *p, bool slopes)
{
    const int width = slopes ? COLUMNS * ROWS : ROWS;
    lobe_parallel parallel = {ask_cells, q, 1, (size_t)width, (size_t)q->fit->threads};
    double sum, by_need[NEEDS], taps;
    q->p = p;
    q->slopes = slopes;
    lobe_parallel_eval(&parallel, q->number, (size_t)q->fit->count, q->block);
    taps = priced(q, p, slopes ? by_need : NULL);
    sum = q->fit->price * taps;
    for (int c = 0; c < q->fit->count; c++)
        for (int b = 0; b < ROWS; b++)
            sum += q->block[c * width + b] * q->block[c * width + b];
    for (int i = 0; i < COUNT; i++)
        sum += RIDGE * p[i] * p[i];
    if (!slopes)
        return sum;
    lobe_normal_clear(q->equations);
    for (int c = 0; c < q->fit->count; c++) {
        lobe_adaptive_fan fan;
        double need_term[NEEDS];
        lobe_normal_column column[COLUMNS - 1];
        int count = 0;
        lobe_adaptive_taps(&q->fit->point[c], p, q->fit->softness, &fan);
        for (int k = 0; k < 3 * fan.count - 1; k++) {
            const lobe_normal_column one = {q->block + (c * COLUMNS + 1 + k) * ROWS, fan.term, NEEDS + TERMS * k,
                                            TERMS};
            column[count++] = one;
        }
        if (!q->fit->hold_need) {
            lobe_adaptive_need_terms(&q->fit->point[c], need_term);
            const lobe_normal_column one = {q->block + (c * COLUMNS + COLUMNS - 1) * ROWS, need_term, 0, NEEDS};
            column[count++] = one;
        }
        lobe_normal_add(q->equations, column, count, q->block + c * COLUMNS * ROWS, ROWS);
    }
    if (!q->fit->hold_need)
        lobe_normal_add_square(q->equations, q->fit->price, taps, by_need, NEEDS);
    lobe_normal_add_ridge(q->equations, RIDGE, p, q->fit->hold_need ? NEEDS : 0);
    return sum;
}

static bool make_problem(problem *q, lobe_adaptive_fit *fit)
{
    enum { SIDE = LOBE_ADAPTIVE_SIDE };
    memset(q, 0, sizeof *q);
    q->fit = fit;
    q->block = malloc(sizeof *q->block * (size_t)fit->count * COLUMNS * ROWS);
    q->square = malloc(sizeof *q->square * SIDE * SIDE);
    q->equations = lobe_normal_new(COUNT);
    if (!q->block || !q->square || !q->equations)
        return false;
    for (int c = 0; c < fit->count; c++)
        q->number[c] = c;
    for (int i = 0; i < SIDE * SIDE; i++) {
        const double r = (i / SIDE + 0.5) / SIDE;
        const lobe_fan_point point = lobe_fan_point_of(r * r, (i % SIDE + 0.5) / SIDE);
        lobe_adaptive_need_terms(&point, q->square[i]);
    }
    return true;
}

static void free_problem(problem *q)
{
    lobe_normal_free(q->equations);
    free(q->square);
    free(q->block);
}

lobe_fit_result lobe_adaptive_improve(lobe_adaptive_fit *fit, int steps, double *p)
{
    enum { TRIES = 30, SLOW = 5 };
    problem q;
    lobe_fit_result result = {LOBE_FIT_BUDGET, "the steps ran out", INFINITY, 0, 0};
    double trial[COUNT], damping = 1e-2;
    int slow = 0;
    if (!make_problem(&q, fit)) {
        free_problem(&q);
        return lobe_fit_no_memory();
    }
    result.value = ask(&q, p, true);
    while (result.iterations < (size_t)steps && slow < SLOW) {
        int tries = 0;
        double value = INFINITY, promised = 0;
        for (; tries < TRIES && !(value < result.value); tries++) {
            promised = lobe_normal_step(q.equations, damping, p, trial);
            value = promised > 0 ? ask(&q, trial, false) : INFINITY;
            result.evaluations++;
            if (!(value < result.value))
                damping *= 4;
        }
        if (tries == TRIES)
            break;
        damping *= result.value - value > 0.75 * promised ? 0.2 : result.value - value > 0.25 * promised ? 0.6 : 2;
        damping = fmax(damping, 1e-9);
        slow = result.value - value < 2e-5 * result.value ? slow + 1 : 0;
        memcpy(p, trial, sizeof trial);
        result.value = ask(&q, p, true);
        result.iterations++;
        const lobe_progress at = {.stage = "adaptive", .best = result.value, .evaluations = result.evaluations};
        if (!lobe_progress_print(&fit->line, &at)) {
            result.status = LOBE_FIT_INTERRUPTED;
            result.reason = "interrupted";
            break;
        }
    }
    free_problem(&q);
    return result;
}

void lobe_adaptive_score(const lobe_adaptive_fit *fit, const double *p, double error[LOBE_CELL_PARTS])
{
    double *scratch = malloc(sizeof *scratch * lobe_cell_scratch(fit->cell[0])), total = 0;
    for (int k = 0; k < LOBE_CELL_PARTS; k++)
        error[k] = 0;
    for (int c = 0; scratch && c < fit->count; c++) {
        lobe_adaptive_fan fan;
        double part[LOBE_CELL_PARTS];
        if (fit->point[c].alpha < 0.04)
            continue;
        lobe_adaptive_taps(&fit->point[c], p, 0, &fan);
        lobe_cell_errors(fit->cell[c], fan.tap, fan.count, scratch, part);
        for (int k = 0; k < LOBE_CELL_PARTS; k++)
            error[k] += fit->weight[c] * part[k];
        total += fit->weight[c];
    }
    for (int k = 0; k < LOBE_CELL_PARTS; k++)
        error[k] = scratch ? sqrt(error[k] / total) : NAN;
    free(scratch);
}
