#include "cells.h"
#define LOBE_DOUBLE
#include "kernel.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A texel wider than the kernel is divided into at most this many a side. */
#define FINEST_SPLIT 64
/* No kernel is wider than a hemisphere, whose edge is as sharp as this. */
#define WIDEST 0.7

typedef struct gather {
    const lobe_prefilter_source *source;
    const lobe_prefilter_group *group;
    lobe_prefilter_cells *cells;
    double peak;
} gather;

double lobe_prefilter_peak(lobe_prefilter_kernel kernel, double parameter)
{
    const double square = kernel == LOBE_PREFILTER_SG ? 1 / parameter : 2 / parameter;
    return parameter > 0 && square < 1 ? sqrt(square) : 1;
}

/* The largest cell at a distance: the ggx kernel falls like a power of distance, the sg kernel so fast that what is far
 * down may be taken coarsely. */
static double limit(const gather *g, double near)
{
    double scale;
    if (g->group->kernel == LOBE_PREFILTER_GGX)
        scale = sqrt(g->peak * g->peak + near * near);
    else
        scale = g->peak * exp(fmin(g->group->parameter * near * near / 8, 2));
    return g->group->detail * fmin(scale, WIDEST);
}

static double *add(gather *g)
{
    lobe_prefilter_cells *c = g->cells;
    if (c->count == c->room) {
        const size_t room = c->room ? 2 * c->room : 4096;
        double *more = realloc(c->rows, room * LOBE_PREFILTER_ROW * sizeof *more);
        if (!more)
            return NULL;
        c->rows = more;
        c->room = room;
    }
    return c->rows + LOBE_PREFILTER_ROW * c->count++;
}

static int add_cell(gather *g, const lobe_prefilter_cell *cell)
{
    double *row = add(g);
    if (!row)
        return 0;
    for (int k = 0; k < 3; k++) {
        row[k] = (double)cell->weight[k];
        row[3 + k] = (double)cell->middle[k];
        row[7 + k] = (double)cell->energy[k];
    }
    row[6] = (double)cell->solid_angle;
    return 1;
}

/* One texel, or a block of them, as split x split parts of its mean radiance. */
static int add_parts(gather *g, const lobe_prefilter_cell *cell, int chart, int i, int j, int split)
{
    const lobe_prefilter_source *s = g->source;
    const double top = i * s->block, left = j * s->block, bottom = fmin(top + s->block, s->rows),
                 right = fmin(left + s->block, s->columns);
    const double down = (bottom - top) / split, across = (right - left) / split;
    for (int a = 0; a < split; a++)
        for (int b = 0; b < split; b++) {
            double *row = add(g), moment[3], length;
            if (!row)
                return 0;
            row[6] = lobe_prefilter_image_moment(&s->image, chart, top + a * down, left + b * across,
                                                 top + (a + 1) * down, left + (b + 1) * across, moment);
            length = sqrt(moment[0] * moment[0] + moment[1] * moment[1] + moment[2] * moment[2]);
            for (int k = 0; k < 3; k++) {
                row[k] = row[3 + k] = moment[k] / length;
                row[7 + k] = (double)cell->energy[k] / (double)cell->solid_angle * row[6];
            }
        }
    return 1;
}

static int visit(gather *g, int level, int chart, int i, int j)
{
    const lobe_prefilter_cell *cell = lobe_prefilter_source_cell(g->source, level, chart, i, j);
    const lobe_prefilter_group *group = g->group;
    double square = 0;
    for (int k = 0; k < 3; k++)
        square += (group->middle[k] - (double)cell->middle[k]) * (group->middle[k] - (double)cell->middle[k]);
    const double near = fmax(0, sqrt(square) - group->radius - (double)cell->radius);
    /* Wholly below the horizon of every direction, or nothing of the kernel left. The radius of a cell that is not
     * small is not a bound; such a cell is divided. */
    const int small = cell->radius < 0.5f;
    if (small && (group->kernel == LOBE_PREFILTER_GGX ? near * near >= 2
                                                      : group->parameter * near * near / 2 >= LOBE_PREFILTER_FARTHEST))
        return 1;
    const double most = limit(g, near), extent = 2 * (double)cell->radius;
    if (small && extent <= most)
        return add_cell(g, cell);
    if (level == 0) {
        const double parts = ceil(extent / most);
        return add_parts(g, cell, chart, i, j, parts < FINEST_SPLIT ? (int)parts : FINEST_SPLIT);
    }
    const lobe_prefilter_level *below = &g->source->level[level - 1];
    for (int a = 2 * i; a < 2 * i + 2 && a < below->rows; a++)
        for (int b = 2 * j; b < 2 * j + 2 && b < below->columns; b++)
            if (!visit(g, level - 1, chart, a, b))
                return 0;
    return 1;
}

int lobe_prefilter_gather(const lobe_prefilter_source *source, const lobe_prefilter_group *group,
                          lobe_prefilter_cells *cells)
{
    gather g = {source, group, cells, lobe_prefilter_peak(group->kernel, group->parameter)};
    cells->count = 0;
    for (int chart = 0; chart < source->charts; chart++)
        if (!visit(&g, source->levels - 1, chart, 0, 0))
            return 0;
    return 1;
}

void lobe_prefilter_cells_free(lobe_prefilter_cells *cells)
{
    free(cells->rows);
    memset(cells, 0, sizeof *cells);
}
