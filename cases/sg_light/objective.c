#define LOBE_DOUBLE 1
#define LOBE_FIT 1
#include "objective.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "row.h"

bool lobe_sg_problem_make(lobe_sg_problem *p, const lobe_sg_tier *tier, const lobe_sg_cells cells[2], int stride)
{
    size_t set, cell, i, at = 0;
    memset(p, 0, sizeof *p);
    p->tier = tier;
    p->positions = (size_t)(LOBE_SG_POSITIONS / stride);
    p->rows = 2 * LOBE_SG_CELLS * p->positions;
    p->light = malloc(p->rows * sizeof *p->light);
    p->roughness = malloc(3 * p->rows * sizeof *p->roughness);
    if (!p->light || !p->roughness)
        return false;
    p->truth = p->roughness + p->rows;
    p->weight = p->truth + p->rows;
    for (set = 0; set < 2; set++) {
        for (cell = 0; cell < LOBE_SG_CELLS; cell++) {
            const size_t first = at;
            double square = 0;
            for (i = 0; i < p->positions; i++, at++) {
                const size_t from = cell * LOBE_SG_POSITIONS + i * (size_t)stride;
                const double *row = cells[set].in + 5 * from;
                p->light[at] = lobe_sg_of_row(row);
                p->roughness[at] = row[0];
                p->truth[at] = cells[set].truth[from];
                square += p->truth[at] * p->truth[at];
            }
            for (i = first; i < at; i++)
                p->weight[i] = 1 / sqrt(2 * LOBE_SG_CELLS * square);
        }
    }
    return true;
}

void lobe_sg_problem_free(lobe_sg_problem *p)
{
    free(p->light);
    free(p->roughness);
    memset(p, 0, sizeof *p);
}

static double residual(const lobe_sg_problem *p, const double *params, size_t i)
{
    return (p->tier->call(params, p->roughness[i], p->light[i]) - p->truth[i]) * p->weight[i];
}

void lobe_sg_residuals(void *ctx, const double *params, size_t count, double *values)
{
    const lobe_sg_problem *p = ctx;
    size_t n, i;
    for (n = 0; n < count; n++)
        for (i = 0; i < p->rows; i++)
            values[n * p->rows + i] = residual(p, params + n * p->tier->count, i);
}

void lobe_sg_sum(void *ctx, const double *params, size_t count, double *values)
{
    const lobe_sg_problem *p = ctx;
    size_t n, i;
    for (n = 0; n < count; n++) {
        values[n] = 0;
        for (i = 0; i < p->rows; i++) {
            const double r = residual(p, params + n * p->tier->count, i);
            values[n] += r * r;
        }
    }
}
