#include "source.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What adds up from cell to cell. */
typedef struct sums {
    double solid_angle, energy[3];
    double moment[3];            /* integral of the direction */
    double bright, bright_at[3]; /* of the radiance's size, and of that times the direction */
} sums;

static void unit(const double v[3], const double otherwise[3], float out[3])
{
    const double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int k = 0; k < 3; k++)
        out[k] = (float)(length > 1e-30 ? v[k] / length : otherwise[k]);
}

/* The rectangle's corners and the middles of its edges; a cell as large as that holds is divided anyway. */
static float radius(const lobe_prefilter_image *image, int chart, const double box[4], const float middle[3])
{
    double worst = 0;
    for (int i = 0; i < 9; i++) {
        double d[3], sum = 0;
        lobe_prefilter_image_direction(image, chart, box[0] + (box[2] - box[0]) * (i / 3) / 2,
                                       box[1] + (box[3] - box[1]) * (i % 3) / 2, d);
        for (int k = 0; k < 3; k++)
            sum += (d[k] - (double)middle[k]) * (d[k] - (double)middle[k]);
        worst = fmax(worst, sum);
    }
    return (float)(sqrt(worst) * 1.0001);
}

static void finish(const lobe_prefilter_source *s, int chart, const double box[4], const sums *a,
                   lobe_prefilter_cell *cell)
{
    double fallback[3];
    lobe_prefilter_image_direction(&s->image, chart, (box[0] + box[2]) / 2, (box[1] + box[3]) / 2, fallback);
    unit(a->moment, fallback, cell->middle);
    if (a->bright > 0)
        unit(a->bright_at, fallback, cell->weight);
    else
        memcpy(cell->weight, cell->middle, sizeof cell->weight);
    for (int k = 0; k < 3; k++)
        cell->energy[k] = (float)a->energy[k];
    cell->solid_angle = (float)a->solid_angle;
    cell->radius = radius(&s->image, chart, box, cell->middle);
}

/* One cell of level 0 from its texels. */
static void leaf(const lobe_prefilter_source *s, int chart, int row, int column, lobe_prefilter_cell *cell)
{
    const int top = row * s->block, left = column * s->block;
    const int bottom = top + s->block < s->rows ? top + s->block : s->rows;
    const int right = left + s->block < s->columns ? left + s->block : s->columns;
    const double box[4] = {top, left, bottom, right};
    sums a;
    memset(&a, 0, sizeof a);
    for (int i = top; i < bottom; i++)
        for (int j = left; j < right; j++) {
            double moment[3];
            const float *rgb = lobe_prefilter_image_texel(&s->image, chart, i, j);
            const double angle = lobe_prefilter_image_moment(&s->image, chart, i, j, i + 1, j + 1, moment);
            const double bright = fabs((double)rgb[0]) + fabs((double)rgb[1]) + fabs((double)rgb[2]);
            a.solid_angle += angle;
            a.bright += bright * angle;
            for (int k = 0; k < 3; k++) {
                a.energy[k] += (double)rgb[k] * angle;
                a.moment[k] += moment[k];
                a.bright_at[k] += bright * moment[k];
            }
        }
    finish(s, chart, box, &a, cell);
}

const lobe_prefilter_cell *lobe_prefilter_source_cell(const lobe_prefilter_source *source, int level, int chart,
                                                      int row, int column)
{
    const lobe_prefilter_level *l = &source->level[level];
    return l->cells + ((size_t)chart * (size_t)l->rows + (size_t)row) * (size_t)l->columns + (size_t)column;
}

/* From up to four cells of the level below; the directions are weighted by what they stand for. */
static void parent(const lobe_prefilter_source *s, int level, int chart, int row, int column, lobe_prefilter_cell *cell)
{
    const lobe_prefilter_level *below = &s->level[level - 1];
    const int step = s->block << level;
    const double box[4] = {row * step, column * step, fmin((row + 1) * step, s->rows),
                           fmin((column + 1) * step, s->columns)};
    sums a;
    memset(&a, 0, sizeof a);
    for (int i = 2 * row; i < 2 * row + 2 && i < below->rows; i++)
        for (int j = 2 * column; j < 2 * column + 2 && j < below->columns; j++) {
            const lobe_prefilter_cell *c = lobe_prefilter_source_cell(s, level - 1, chart, i, j);
            const double angle = (double)c->solid_angle;
            const double bright = fabs((double)c->energy[0]) + fabs((double)c->energy[1]) + fabs((double)c->energy[2]);
            a.solid_angle += angle;
            a.bright += bright;
            for (int k = 0; k < 3; k++) {
                a.energy[k] += (double)c->energy[k];
                a.moment[k] += angle * (double)c->middle[k];
                a.bright_at[k] += bright * (double)c->weight[k];
            }
        }
    finish(s, chart, box, &a, cell);
}

static int add_level(lobe_prefilter_source *s, int rows, int columns)
{
    lobe_prefilter_level *l = &s->level[s->levels];
    l->rows = rows;
    l->columns = columns;
    l->cells = malloc((size_t)s->charts * (size_t)rows * (size_t)columns * sizeof *l->cells);
    if (!l->cells)
        return 0;
    for (int chart = 0; chart < s->charts; chart++)
        for (int i = 0; i < rows; i++)
            for (int j = 0; j < columns; j++) {
                lobe_prefilter_cell *cell = l->cells + ((size_t)chart * (size_t)rows + (size_t)i) * (size_t)columns + j;
                if (s->levels == 0)
                    leaf(s, chart, i, j, cell);
                else
                    parent(s, s->levels, chart, i, j, cell);
            }
    s->levels++;
    return 1;
}

int lobe_prefilter_source_build(lobe_prefilter_source *s, lobe_prefilter_image image, double finest)
{
    memset(s, 0, sizeof *s);
    s->image = image;
    lobe_prefilter_image_size(&image, &s->charts, &s->rows, &s->columns);
    /* A texel's diagonal: of a map at the equator, of a cube in the middle of a face. */
    const double texel =
        image.map ? LOBE_PI * sqrt(1.0 / s->rows / s->rows + 4.0 / s->columns / s->columns) : 2 * sqrt(2) / s->rows;
    s->block = 1;
    while (2 * s->block * texel <= finest && 2 * s->block <= s->rows && 2 * s->block <= s->columns)
        s->block *= 2;
    int rows = (s->rows + s->block - 1) / s->block, columns = (s->columns + s->block - 1) / s->block;
    for (;;) {
        if (!add_level(s, rows, columns)) {
            lobe_prefilter_source_free(s);
            return 0;
        }
        if (rows == 1 && columns == 1)
            return 1;
        rows = (rows + 1) / 2;
        columns = (columns + 1) / 2;
    }
}

void lobe_prefilter_source_free(lobe_prefilter_source *s)
{
    for (int l = 0; l < s->levels; l++)
        free(s->level[l].cells);
    s->levels = 0;
}
