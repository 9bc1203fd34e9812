#include "table_fit.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../fit/parallel.h"
#include "table_band.h"

enum { CELLS = LOBE_ENV_TABLE_CELLS, ROWS = LOBE_CELL_ROWS, SIDE = LOBE_ENV_TABLE_SIDE, NODES = LOBE_ENV_TABLE_NODES };
enum { NUMBERS = LOBE_ENV_TABLE_NUMBERS, WIDTH = 1 + NUMBERS + NUMBERS * NUMBERS };

/* A width over the roughness and a part count for this much more than a shift. */
#define NARROW_KINDS 10.0
/* Against all nodes moving together. */
#define ANCHOR 0.01

typedef struct problem {
    lobe_env_table_fit *fit;
    int taps, numbers; /* numbers: of a node */
    const double *asked;
    bool slopes;
    double number[CELLS];
    double *values;   /* of every cell: its square, half the gradient and half the curvature by what is looked up */
    lobe_band curve;  /* by the table */
    lobe_band factor; /* with damping */
    double *gradient, *start, *step, *tried, *least, *most;
    bool *held;
} problem;

static void ask_cells(void *ctx, const double *params, size_t count, double *values)
{
    const problem *q = ctx;
    const lobe_env_table_training *t = q->fit->training;
    double *scratch = malloc(sizeof *scratch * lobe_cell_scratch(t->cell[0]));
    for (size_t i = 0; scratch && i < count; i++) {
        const int c = (int)params[i], last = 3 * q->taps - 1;
        double *out = values + i * WIDTH, growth[LOBE_CELL_TAPS], rows[ROWS], slopes[3 * LOBE_CELL_TAPS * ROWS];
        lobe_cell_tap taps[LOBE_CELL_TAPS];
        lobe_env_table_taps(&t->point[c], q->asked, q->taps, taps, growth);
        lobe_cell_residuals(t->cell[c], taps, q->taps, scratch, rows, q->slopes ? slopes : NULL);
        out[0] = t->weight[c] * lobe_band_dot(rows, rows, ROWS);
        for (int k = 0; q->slopes && k < q->numbers; k++) {
            const double scale = k % 3 == 0 ? t->point[c].reach : k % 3 == 1 ? growth[k / 3] : 1;
            double *slope = slopes + k * ROWS;
            for (int b = 0; b < ROWS; b++)
                slope[b] = scale * (slope[b] - (k % 3 == 2 ? slopes[last * ROWS + b] : 0));
            out[1 + k] = t->weight[c] * lobe_band_dot(slope, rows, ROWS);
            for (int j = 0; j <= k; j++)
                out[1 + NUMBERS + k * NUMBERS + j] = t->weight[c] * lobe_band_dot(slope, slopes + j * ROWS, ROWS);
        }
    }
    for (size_t i = 0; !scratch && i < count; i++)
        values[i * WIDTH] = NAN;
    free(scratch);
}

static double stiffness_of(const problem *q, int k) { return q->fit->stiffness * (k % 3 == 0 ? 1 : NARROW_KINDS); }

static double moved(const problem *q, const double *table, int node, int k)
{
    return table[node * q->numbers + k] - q->start[node * q->numbers + k];
}

static double ask(problem *q, const double *table, bool slopes, double *stiff)
{
    lobe_parallel parallel = {ask_cells, q, 1, WIDTH, (size_t)q->fit->threads};
    double sum = 0;
    q->asked = table;
    q->slopes = slopes;
    lobe_parallel_eval(&parallel, q->number, CELLS, q->values);
    for (int c = 0; c < CELLS; c++)
        sum += q->values[(size_t)c * WIDTH];
    *stiff = 0;
    for (int node = 0; node < NODES; node++)
        for (int k = 0; k < q->numbers; k++) {
            const double here = moved(q, table, node, k);
            const double right = node % SIDE < SIDE - 1 ? here - moved(q, table, node + 1, k) : 0;
            const double below = node < NODES - SIDE ? here - moved(q, table, node + SIDE, k) : 0;
            *stiff += stiffness_of(q, k) * (right * right + below * below + ANCHOR * here * here);
        }
    return sum;
}

static void pull_together(problem *q, int a, int b, int k)
{
    const int i = a * q->numbers + k, j = b * q->numbers + k;
    const double s = stiffness_of(q, k), d = s * (moved(q, q->asked, a, k) - moved(q, q->asked, b, k));
    q->gradient[i] += d;
    q->gradient[j] -= d;
    lobe_band_row(&q->curve, i)[i] += s;
    lobe_band_row(&q->curve, j)[j] += s;
    lobe_band_row(&q->curve, j)[i] -= s;
}

/* Gradient and curvature by the table, of what was asked with slopes. */
static void assemble(problem *q)
{
    static const int offset[4] = {0, 1, SIDE, SIDE + 1};
    const int n = q->numbers;
    memset(q->curve.entry, 0, sizeof(double) * (size_t)q->curve.size * (size_t)(q->curve.reach + 1));
    memset(q->gradient, 0, sizeof *q->gradient * (size_t)q->curve.size);
    for (int c = 0; c < CELLS; c++) {
        const lobe_env_table_point *p = &q->fit->training->point[c];
        const double *gradient = q->values + (size_t)c * WIDTH + 1, *curve = gradient + NUMBERS;
        for (int u = 0; u < 4; u++)
            for (int k = 0; k < n; k++) {
                const int i = (p->node + offset[u]) * n + k;
                double *row = lobe_band_row(&q->curve, i);
                q->gradient[i] += p->part[u] * gradient[k];
                for (int w = 0; w <= u; w++)
                    for (int l = 0; l < (w == u ? k + 1 : n); l++)
                        row[(p->node + offset[w]) * n + l] +=
                            p->part[u] * p->part[w] * (l <= k ? curve[k * NUMBERS + l] : curve[l * NUMBERS + k]);
            }
    }
    for (int node = 0; node < NODES; node++)
        for (int k = 0; k < n; k++) {
            const int i = node * n + k;
            q->gradient[i] += ANCHOR * stiffness_of(q, k) * moved(q, q->asked, node, k);
            lobe_band_row(&q->curve, i)[i] += ANCHOR * stiffness_of(q, k);
            if (node % SIDE < SIDE - 1)
                pull_together(q, node, node + 1, k);
            if (node < NODES - SIDE)
                pull_together(q, node, node + SIDE, k);
        }
}

/* q->step; what is pushed against a bound stays. */
static void solve(problem *q, const double *table, double damping)
{
    const int n = q->curve.size;
    for (int i = 0; i < n; i++) {
        q->held[i] = (table[i] <= q->least[i] && q->gradient[i] > 0) || (table[i] >= q->most[i] && q->gradient[i] < 0);
        q->step[i] = q->held[i] ? 0 : -q->gradient[i];
    }
    for (int i = 0; i < n; i++) {
        const double *from = lobe_band_row(&q->curve, i);
        double *to = lobe_band_row(&q->factor, i);
        for (int j = i > q->curve.reach ? i - q->curve.reach : 0; j < i; j++)
            to[j] = q->held[i] || q->held[j] ? 0 : from[j];
        to[i] = from[i] * (1 + damping);
    }
    lobe_band_solve(&q->factor, q->step);
}

static void free_problem(problem *q)
{
    if (q) {
        free(q->values);
        free(q->curve.entry);
        free(q->held);
    }
    free(q);
}

static problem *new_problem(lobe_env_table_fit *fit, int taps)
{
    problem *q = calloc(1, sizeof *q);
    size_t n, entries;
    if (!q)
        return NULL;
    q->fit = fit;
    q->taps = taps;
    q->numbers = lobe_env_table_numbers(taps);
    q->curve.size = NODES * q->numbers;
    q->curve.reach = (SIDE + 2) * q->numbers - 1;
    n = (size_t)q->curve.size;
    entries = n * ((size_t)q->curve.reach + 1);
    q->values = malloc(sizeof(double) * CELLS * WIDTH);
    q->curve.entry = malloc(sizeof(double) * (2 * entries + 6 * n));
    q->held = malloc(n * sizeof *q->held);
    if (!q->values || !q->curve.entry || !q->held) {
        free_problem(q);
        return NULL;
    }
    q->factor = q->curve;
    q->factor.entry = q->curve.entry + entries;
    q->gradient = q->factor.entry + entries;
    q->start = q->gradient + n;
    q->step = q->start + n;
    q->tried = q->step + n;
    q->least = q->tried + n;
    q->most = q->least + n;
    for (int c = 0; c < CELLS; c++)
        q->number[c] = c;
    for (int i = 0; i < q->curve.size; i++)
        lobe_env_table_bounds(i % q->numbers % 3, i / q->numbers, &q->least[i], &q->most[i]);
    return q;
}

static void inside(const problem *q, double *table)
{
    for (int i = 0; i < q->curve.size; i++)
        table[i] = fmin(q->most[i], fmax(q->least[i], table[i]));
}

lobe_fit_result lobe_env_table_improve(lobe_env_table_fit *fit, int taps, int budget, double *table)
{
    enum { TRIES = 8 };
    problem *q = new_problem(fit, taps);
    lobe_fit_result result = {LOBE_FIT_BUDGET, "all steps done", 0, 1, 0};
    double damping = 1e-3, stiff, best;
    size_t bytes;
    if (!q)
        return lobe_fit_no_memory();
    bytes = sizeof *table * (size_t)q->curve.size;
    inside(q, table);
    memcpy(q->start, table, bytes);
    result.value = ask(q, table, false, &stiff);
    best = result.value + stiff;
    for (bool moving = true; moving && result.iterations < (size_t)budget; result.iterations++) {
        const double before = best;
        lobe_progress progress = {"table", result.evaluations, (size_t)(2 * budget), best};
        if (!lobe_progress_print(&fit->line, &progress)) {
            result.status = LOBE_FIT_INTERRUPTED;
            result.reason = "interrupted";
            break;
        }
        ask(q, table, true, &stiff);
        assemble(q);
        for (int k = 0; k < TRIES && !(best < before); k++) {
            double value;
            solve(q, table, damping);
            for (int i = 0; i < q->curve.size; i++)
                q->tried[i] = table[i] + q->step[i];
            inside(q, q->tried);
            value = ask(q, q->tried, false, &stiff);
            result.evaluations++;
            damping *= 5;
            if (value + stiff < best) {
                best = value + stiff;
                result.value = value;
                memcpy(table, q->tried, bytes);
                damping = fmax(1e-6, damping / 20);
            }
        }
        moving = before - best > 1e-4 * best;
        if (!moving) {
            result.status = LOBE_FIT_CONVERGED;
            result.reason = "steps gain nothing more";
        }
    }
    free_problem(q);
    return result;
}

void lobe_env_table_score(const lobe_env_table_fit *fit, int taps, const double *table, double error[LOBE_CELL_PARTS])
{
    const lobe_env_table_training *t = fit->training;
    double *scratch = malloc(sizeof *scratch * lobe_cell_scratch(t->cell[0])), count = 0;
    for (int k = 0; k < LOBE_CELL_PARTS; k++)
        error[k] = 0;
    for (int c = 0; scratch && c < CELLS; c++) {
        lobe_cell_tap tap[LOBE_CELL_TAPS];
        double part[LOBE_CELL_PARTS];
        if (t->point[c].alpha < 0.04)
            continue;
        lobe_env_table_taps(&t->point[c], table, taps, tap, NULL);
        lobe_cell_errors(t->cell[c], tap, taps, scratch, part);
        for (int k = 0; k < LOBE_CELL_PARTS; k++)
            error[k] += part[k];
        count++;
    }
    for (int k = 0; k < LOBE_CELL_PARTS; k++)
        error[k] = scratch ? sqrt(error[k] / count) : NAN;
    free(scratch);
}
