#define LOBE_DOUBLE 1
#define LOBE_FIT 1
#include "lit_objective.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "row.h"

enum { POSITION_ROWS = LOBE_SPHERE_F0S + 1 };

static double at_f0(double f0, double bright, double dark) { return f0 * bright + (1 - f0) * dark; }

/* What an f0 counts in a cell: its weight over the cell's squared length of the truth, over the number of cells. */
static void parts_of(const lobe_sphere_lit_tier *tier, const lobe_sphere_lit_set *s, size_t first, size_t positions,
                     double parts[LOBE_SPHERE_F0S])
{
    double sum = 0;
    size_t i, k;
    for (k = 0; k < LOBE_SPHERE_F0S; k++)
        sum += tier->weight[k];
    for (k = 0; k < LOBE_SPHERE_F0S; k++) {
        double square = 0;
        for (i = first; i < first + positions; i++) {
            const double t = at_f0(lobe_sphere_f0s[k], s->truth[i], s->dark[i]);
            square += t * t;
        }
        parts[k] = tier->weight[k] / sum / square / LOBE_SPHERE_CELLS;
    }
}

/* The errors under a given radiance, with that part, added to a position's parabola a s^2 + 2 b s + c. */
static void add_given(const double parts[LOBE_SPHERE_F0S], double part, double radiance, double truth, double dark,
                      double parabola[3])
{
    int k;
    for (k = 0; k < LOBE_SPHERE_F0S; k++) {
        const double f0 = lobe_sphere_f0s[k], slope = (1 - f0) * radiance;
        const double offset = f0 * radiance - at_f0(f0, truth, dark);
        parabola[0] += part * parts[k] * slope * slope;
        parabola[1] += part * parts[k] * slope * offset;
        parabola[2] += part * parts[k] * offset * offset;
    }
}

static bool set_allocate(lobe_sphere_lit_set *s, size_t count)
{
    s->light = malloc(count * sizeof *s->light);
    s->truth = malloc((4 * count + (1 + LOBE_SPHERE_F0S) * LOBE_SPHERE_CELLS) * sizeof *s->truth);
    if (!s->light || !s->truth)
        return false;
    s->dark = s->truth + count;
    s->slope = s->dark + count;
    s->offset = s->slope + count;
    s->roughness = s->offset + count;
    s->weight = s->roughness + LOBE_SPHERE_CELLS;
    return true;
}

static void cell_make(lobe_sphere_lit_problem *p, lobe_sphere_lit_set *s, size_t cell, size_t first,
                      const double *const given[LOBE_SPHERE_BASES], size_t stride)
{
    const lobe_sphere_lit_tier *tier = p->tier;
    const double share = (1 - tier->own - tier->true_one) / (tier->under[1] ? 2 : 1);
    double parts[LOBE_SPHERE_F0S];
    size_t i, k;
    parts_of(tier, s, cell * p->positions, p->positions, parts);
    for (k = 0; k < LOBE_SPHERE_F0S; k++)
        s->weight[cell * LOBE_SPHERE_F0S + k] = sqrt(tier->own * parts[k]);
    for (i = 0; i < p->positions; i++) {
        const size_t to = cell * p->positions + i;
        double parabola[3] = {0, 0, 0};
        if (tier->true_one > 0)
            add_given(parts, tier->true_one, s->truth[to], s->truth[to], s->dark[to], parabola);
        for (k = 0; k < LOBE_SPHERE_BASES && tier->under[k]; k++)
            add_given(parts, share, given[k][first + i * stride], s->truth[to], s->dark[to], parabola);
        s->slope[to] = sqrt(parabola[0]);
        s->offset[to] = parabola[0] > 0 ? parabola[1] / s->slope[to] : 0;
        p->rest += parabola[2] - s->offset[to] * s->offset[to];
    }
}

static bool set_make(lobe_sphere_lit_problem *p, lobe_sphere_lit_set *s, const lobe_sphere_cells *cells,
                     const double *const given[LOBE_SPHERE_BASES], size_t stride)
{
    size_t cell, i;
    if (!set_allocate(s, LOBE_SPHERE_CELLS * p->positions))
        return false;
    for (cell = 0; cell < LOBE_SPHERE_CELLS; cell++) {
        const size_t first = cell * LOBE_SPHERE_POSITIONS;
        s->roughness[cell] = cells->in[5 * first];
        for (i = 0; i < p->positions; i++) {
            const size_t from = first + i * stride, to = cell * p->positions + i;
            s->light[to] = lobe_sphere_of_row(cells->in + 5 * from);
            s->truth[to] = cells->truth[from];
            s->dark[to] = cells->dark[from];
        }
        cell_make(p, s, cell, first, given, stride);
    }
    return true;
}

bool lobe_sphere_lit_problem_make(lobe_sphere_lit_problem *p, const lobe_sphere_lit_tier *tier,
                                  const lobe_sphere_cells cells[2], double *const under[LOBE_SPHERE_BASES][2],
                                  int stride)
{
    const double *given[2][LOBE_SPHERE_BASES] = {{under[0][0], under[1][0]}, {under[0][1], under[1][1]}};
    size_t k, rows = 1;
    memset(p, 0, sizeof *p);
    p->tier = tier;
    for (k = 0; tier->own > 0 && k < LOBE_SPHERE_F0S; k++)
        rows += tier->weight[k] > 0;
    p->positions = (size_t)(LOBE_SPHERE_POSITIONS / stride);
    p->rows = 2 * LOBE_SPHERE_CELLS * p->positions * rows + 1;
    return set_make(p, &p->set[0], &cells[0], given[0], (size_t)stride) &&
           set_make(p, &p->set[1], &cells[1], given[1], (size_t)stride);
}

void lobe_sphere_lit_problem_free(lobe_sphere_lit_problem *p)
{
    int i;
    for (i = 0; i < 2; i++) {
        free(p->set[i].light);
        free(p->set[i].truth);
    }
    memset(p, 0, sizeof *p);
}

/* The residuals of one position; returns how many. */
static size_t position_residuals(const lobe_sphere_lit_problem *p, const lobe_sphere_lit_set *s, size_t cell, size_t at,
                                 const double *params, double *out)
{
    const lobe_sphere_lit lit = p->tier->call(params, s->roughness[cell], s->light[at]);
    size_t k, rows = 0;
    out[rows++] = s->slope[at] * lit.schlick + s->offset[at];
    for (k = 0; p->tier->own > 0 && k < LOBE_SPHERE_F0S; k++)
        if (p->tier->weight[k] > 0)
            out[rows++] = s->weight[cell * LOBE_SPHERE_F0S + k] *
                          (at_f0(lobe_sphere_f0s[k], lit.radiance, lit.radiance * lit.schlick) -
                           at_f0(lobe_sphere_f0s[k], s->truth[at], s->dark[at]));
    return rows;
}

void lobe_sphere_lit_residuals(void *ctx, const double *params, size_t count, double *values)
{
    const lobe_sphere_lit_problem *p = ctx;
    size_t n, cell, i;
    int set;
    for (n = 0; n < count; n++, params += p->tier->count) {
        double *out = values + n * p->rows;
        for (set = 0; set < 2; set++)
            for (cell = 0; cell < LOBE_SPHERE_CELLS; cell++)
                for (i = 0; i < p->positions; i++)
                    out += position_residuals(p, &p->set[set], cell, cell * p->positions + i, params, out);
        *out = sqrt(fmax(p->rest, 0));
    }
}

void lobe_sphere_lit_sum(void *ctx, const double *params, size_t count, double *values)
{
    const lobe_sphere_lit_problem *p = ctx;
    double out[POSITION_ROWS];
    size_t n, cell, i, k, rows;
    int set;
    for (n = 0; n < count; n++, params += p->tier->count) {
        values[n] = p->rest;
        for (set = 0; set < 2; set++)
            for (cell = 0; cell < LOBE_SPHERE_CELLS; cell++)
                for (i = 0; i < p->positions; i++) {
                    rows = position_residuals(p, &p->set[set], cell, cell * p->positions + i, params, out);
                    for (k = 0; k < rows; k++)
                        values[n] += out[k] * out[k];
                }
    }
}
