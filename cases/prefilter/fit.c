/* Small mips: lookups between few texels of a curved function are off by a few per cent, always to the same side, and
 * two kernels mixed are not the kernel between them. Least squares for all small mips at once, over widths between them
 * and a grid of directions for each, by conjugate gradients on the normal equations. */
#include "cube_sample.h"
#include "prefilter.h"
#include "../fit/interrupt.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FINE = 4, BETWEEN = 4, STEPS = 60, MOST = LOBE_PREFILTER_TILE * LOBE_PREFILTER_TILE, ENTRIES = 12 };

/* One lookup: what it takes of which unknown texels, and what it should give, less what known texels give. */
typedef struct lookup {
    int count;
    unsigned texel[ENTRIES];
    double weight[ENTRIES], solid_angle, wanted[3];
} lookup;

typedef struct problem {
    const lobe_prefilter_source *source;
    const lobe_prefilter_options *options;
    lobe_cube *cube;
    int first;                         /* the first of the mips that are fitted */
    size_t offset[LOBE_CUBE_MAX_MIPS]; /* of a fitted mip's texels among the unknowns */
    size_t texels, rows;
    lookup *row;
    lobe_prefilter_cells cells;
} problem;

static size_t index_of(int side, lobe_cube_texel t)
{
    return ((size_t)t.face * (size_t)side + (size_t)t.row) * (size_t)side + (size_t)t.column;
}

static void take(const problem *p, int mip, double weight, const double d[3], lookup *l)
{
    lobe_cube_footprint f;
    const int side = lobe_cube_side(p->cube->size, mip);
    if (weight == 0)
        return;
    lobe_cube_footprint_of(side, d, &f);
    for (int i = 0; i < f.count; i++)
        if (mip >= p->first) {
            l->texel[l->count] = (unsigned)(p->offset[mip] + index_of(side, f.texel[i]));
            l->weight[l->count++] = weight * f.weight[i];
        } else {
            for (int k = 0; k < 3; k++)
                l->wanted[k] -= weight * f.weight[i] * (double)lobe_cube_at(p->cube, mip, f.texel[i])[k];
        }
}

/* One tile of the fine grid, whose texels are lookups at mip + fraction. */
static int fill(problem *p, lobe_prefilter_group *group, const lobe_prefilter_tile *tile, int fine, double fraction)
{
    double d[3 * MOST], rgb[3 * MOST];
    const int n = tile->height * tile->width;
    lobe_prefilter_tile_directions(tile, fine, d);
    lobe_prefilter_bound(d, n, group);
    if (!lobe_prefilter_group_filter(p->source, group, &p->cells, d, n, rgb))
        return 0;
    for (int i = 0; i < n; i++) {
        const int row = tile->row + i / tile->width, column = tile->column + i % tile->width;
        lookup *l = &p->row[p->rows++];
        l->count = 0;
        l->solid_angle = lobe_cube_solid_angle(fine, row, column, row + 1, column + 1);
        memcpy(l->wanted, rgb + 3 * i, sizeof l->wanted);
        take(p, tile->mip, 1 - fraction, d + 3 * i, l);
        take(p, tile->mip + 1, fraction, d + 3 * i, l);
    }
    return 1;
}

/* The lookups of all widths; with no room for them they are only counted. */
static int fill_all(problem *p)
{
    const lobe_prefilter_scale *scale = &p->options->scale;
    const int last = scale->mips - 1;
    p->rows = 0;
    for (int step = BETWEEN * (p->first - 1) + 1; step <= BETWEEN * last; step++) {
        const int mip = step / BETWEEN, fine = FINE * lobe_cube_side(p->cube->size, mip < last ? mip + 1 : last);
        const double fraction = (double)(step % BETWEEN) / BETWEEN, width = lobe_prefilter_width(scale, mip + fraction);
        lobe_prefilter_group group = {
            scale->kernel, lobe_prefilter_parameter(scale->kernel, width), p->options->detail, {0, 0, 0}, 0};
        if (!p->row) {
            p->rows += 6 * (size_t)fine * (size_t)fine;
            continue;
        }
        for (int face = 0; face < 6; face++)
            for (int i = 0; i < fine; i += LOBE_PREFILTER_TILE)
                for (int j = 0; j < fine; j += LOBE_PREFILTER_TILE) {
                    const lobe_prefilter_tile tile = {mip, face, i, j, LOBE_PREFILTER_TILE, LOBE_PREFILTER_TILE};
                    if (lobe_interrupt_requested() || !fill(p, &group, &tile, fine, fraction))
                        return 0;
                }
    }
    return 1;
}

/* out = A' W (A x - wanted), or A' W A x where there is no wanted; one channel. */
static void normal(const problem *p, const double *x, int channel, int with_wanted, double *out)
{
    memset(out, 0, p->texels * sizeof *out);
    for (size_t r = 0; r < p->rows; r++) {
        const lookup *l = &p->row[r];
        double sum = with_wanted ? -l->wanted[channel] : 0;
        for (int i = 0; i < l->count; i++)
            sum += l->weight[i] * x[l->texel[i]];
        for (int i = 0; i < l->count; i++)
            out[l->texel[i]] += l->weight[i] * l->solid_angle * sum;
    }
}

static double square(const double *x, size_t n)
{
    double sum = 0;
    for (size_t i = 0; i < n; i++)
        sum += x[i] * x[i];
    return sum;
}

/* x is improved in place; work holds three more vectors. */
static void solve(const problem *p, int channel, double *x, double *work)
{
    double *residual = work, *step = work + p->texels, *image = work + 2 * p->texels;
    normal(p, x, channel, 1, residual);
    for (size_t i = 0; i < p->texels; i++)
        step[i] = residual[i] = -residual[i];
    double size = square(residual, p->texels);
    const double enough = 1e-16 * size;
    for (int n = 0; n < STEPS && size > enough; n++) {
        double along = 0;
        normal(p, step, channel, 0, image);
        for (size_t i = 0; i < p->texels; i++)
            along += step[i] * image[i];
        if (!(along > 0))
            return;
        for (size_t i = 0; i < p->texels; i++) {
            x[i] += size / along * step[i];
            residual[i] -= size / along * image[i];
        }
        const double next = square(residual, p->texels), ratio = next / size;
        for (size_t i = 0; i < p->texels; i++)
            step[i] = residual[i] + ratio * step[i];
        size = next;
    }
}

static void solve_all(const problem *p, double *x)
{
    for (int c = 0; c < 3; c++)
        for (int store = 0; store < 2; store++) {
            for (int m = p->first; m < p->cube->mips; m++) {
                const size_t side = (size_t)lobe_cube_side(p->cube->size, m);
                for (size_t i = 0; i < 6 * side * side; i++) {
                    float *texel = &p->cube->rgb[m][3 * i + (size_t)c];
                    double *unknown = &x[p->offset[m] + i];
                    if (!store)
                        *unknown = (double)*texel;
                    else
                        *texel = *texel >= 0 && *unknown < 0 ? 0 : (float)*unknown; /* no light where there was none */
                }
            }
            if (!store)
                solve(p, c, x, x + p->texels);
        }
}

int lobe_prefilter_fit(const lobe_prefilter_source *source, const lobe_prefilter_options *o, lobe_cube *cube)
{
    problem p;
    memset(&p, 0, sizeof p);
    p.source = source;
    p.options = o;
    p.cube = cube;
    p.first = 1;
    while (p.first < cube->mips && lobe_cube_side(cube->size, p.first) > LOBE_PREFILTER_FIT_SIDE)
        p.first++;
    if (p.first >= cube->mips)
        return 1;
    for (int m = p.first; m < cube->mips; m++) {
        const size_t side = (size_t)lobe_cube_side(cube->size, m);
        p.offset[m] = p.texels;
        p.texels += 6 * side * side;
    }
    fill_all(&p);
    p.row = malloc(p.rows * sizeof *p.row);
    double *x = malloc(4 * p.texels * sizeof *x);
    const int good = p.row && x && fill_all(&p);
    if (good)
        solve_all(&p, x);
    lobe_prefilter_cells_free(&p.cells);
    free(p.row);
    free(x);
    return good;
}
