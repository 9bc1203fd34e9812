#define LOBE_DOUBLE 1
#define LOBE_FIT 1
#include "objective.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "row.h"

enum { HINGES = 2, CELL_ROWS = LOBE_SPHERE_POSITIONS + HINGES };

static bool set_make(lobe_sphere_set *s, const lobe_sphere_tier *tier, const lobe_sphere_cells *cells, size_t positions,
                     size_t stride)
{
    const size_t count = LOBE_SPHERE_CELLS * positions;
    size_t cell, i;
    s->light = malloc(count * sizeof *s->light);
    s->roughness = malloc((4 * LOBE_SPHERE_CELLS + count) * sizeof *s->roughness);
    if (!s->light || !s->roughness)
        return false;
    s->weight = s->roughness + LOBE_SPHERE_CELLS;
    s->energy = s->weight + LOBE_SPHERE_CELLS;
    s->excess = s->energy + LOBE_SPHERE_CELLS;
    s->truth = s->excess + LOBE_SPHERE_CELLS;
    s->part = tier->set_weight[cells->mixed];
    for (cell = 0; cell < LOBE_SPHERE_CELLS; cell++) {
        const double *in = cells->in + 5 * LOBE_SPHERE_POSITIONS * cell;
        double square = 0, point = 0;
        s->roughness[cell] = in[0];
        s->energy[cell] = 0;
        for (i = 0; i < positions; i++) {
            const size_t to = cell * positions + i;
            const double t = cells->truth[cell * LOBE_SPHERE_POSITIONS + i * stride];
            double d;
            s->light[to] = lobe_sphere_of_row(in + 5 * i * stride);
            s->truth[to] = t;
            d = lobe_sphere_light_punctual(in[0], s->light[to]) - t;
            square += t * t;
            point += d * d;
            s->energy[cell] += t;
        }
        s->weight[cell] = 1 / sqrt(square);
        s->excess[cell] =
            s->light[cell * positions].sine < .505 * in[0] * in[0] ? sqrt(point / square) + tier->excess_cap : HUGE_VAL;
    }
    return true;
}

bool lobe_sphere_problem_make(lobe_sphere_problem *p, const lobe_sphere_tier *tier, const lobe_sphere_cells cells[2],
                              int stride)
{
    memset(p, 0, sizeof *p);
    p->tier = tier;
    p->positions = (size_t)(LOBE_SPHERE_POSITIONS / stride);
    p->rows = 2 * LOBE_SPHERE_CELLS * (p->positions + HINGES);
    return set_make(&p->set[0], tier, &cells[0], p->positions, (size_t)stride) &&
           set_make(&p->set[1], tier, &cells[1], p->positions, (size_t)stride);
}

void lobe_sphere_problem_free(lobe_sphere_problem *p)
{
    int i;
    for (i = 0; i < 2; i++) {
        free(p->set[i].light);
        free(p->set[i].roughness);
    }
    memset(p, 0, sizeof *p);
}

/* The residuals of one cell, its hinges last. */
static void cell_residuals(const lobe_sphere_problem *p, const lobe_sphere_set *s, size_t cell, const double *params,
                           double *out)
{
    const lobe_sphere_tier *tier = p->tier;
    const lobe_sphere *light = s->light + cell * p->positions;
    const double *truth = s->truth + cell * p->positions, cells = sqrt(LOBE_SPHERE_CELLS);
    double square = 0, energy = 0;
    size_t i;
    for (i = 0; i < p->positions; i++) {
        const double y = tier->call(params, s->roughness[cell], light[i]);
        const double e = (y - truth[i]) * s->weight[cell];
        square += e * e;
        energy += y;
        out[i] = e * s->part / cells;
    }
    out[i++] = s->part * tier->energy_weight * fmax(0, fabs(energy / s->energy[cell] - 1) - tier->energy_cap);
    out[i] = tier->excess_weight > 0 ? s->part * tier->excess_weight * fmax(0, sqrt(square) - s->excess[cell]) : 0;
}

void lobe_sphere_residuals(void *ctx, const double *params, size_t count, double *values)
{
    const lobe_sphere_problem *p = ctx;
    size_t n, cell;
    int set;
    for (n = 0; n < count; n++) {
        double *out = values + n * p->rows;
        for (set = 0; set < 2; set++)
            for (cell = 0; cell < LOBE_SPHERE_CELLS; cell++, out += p->positions + HINGES)
                cell_residuals(p, &p->set[set], cell, params + n * p->tier->count, out);
    }
}

void lobe_sphere_sum(void *ctx, const double *params, size_t count, double *values)
{
    const lobe_sphere_problem *p = ctx;
    double out[CELL_ROWS];
    size_t n, cell, i;
    int set;
    for (n = 0; n < count; n++) {
        values[n] = 0;
        for (set = 0; set < 2; set++)
            for (cell = 0; cell < LOBE_SPHERE_CELLS; cell++) {
                cell_residuals(p, &p->set[set], cell, params + n * p->tier->count, out);
                for (i = 0; i < p->positions + HINGES; i++)
                    values[n] += out[i] * out[i];
            }
    }
}
