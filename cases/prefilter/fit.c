/* Small mips: bilinear lookups between few texels of a curved function are off by a few per cent, always to the same
 * side. Least squares over a grid of four by four directions a texel, by conjugate gradients on the normal equations.
 */
#include "cube_sample.h"
#include "prefilter.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FINE = 4, STEPS = 40, MOST = LOBE_PREFILTER_TILE * LOBE_PREFILTER_TILE };

typedef struct lookups {
    int side, fine;
    size_t texels, rows;
    lobe_cube_footprint *footprint;
    double *solid_angle, *wanted; /* rows, rows x 3 */
} lookups;

static size_t index_of(int side, lobe_cube_texel t)
{
    return ((size_t)t.face * (size_t)side + (size_t)t.row) * (size_t)side + (size_t)t.column;
}

/* One tile of the fine grid, whose texels are the rows. */
static int fill(lookups *s, const lobe_prefilter_source *source, lobe_prefilter_group *group,
                lobe_prefilter_cells *cells, const lobe_prefilter_tile *tile)
{
    double d[3 * MOST], rgb[3 * MOST];
    const int n = tile->height * tile->width;
    lobe_prefilter_tile_directions(tile, s->fine, d);
    lobe_prefilter_bound(d, n, group);
    if (!lobe_prefilter_group_filter(source, group, cells, d, n, rgb))
        return 0;
    for (int i = 0; i < n; i++) {
        const lobe_cube_texel at = {tile->face, tile->row + i / tile->width, tile->column + i % tile->width};
        const size_t row = index_of(s->fine, at);
        lobe_cube_footprint_of(s->side, d + 3 * i, &s->footprint[row]);
        s->solid_angle[row] = lobe_cube_solid_angle(s->fine, at.row, at.column, at.row + 1, at.column + 1);
        memcpy(s->wanted + 3 * row, rgb + 3 * i, 3 * sizeof(double));
    }
    return 1;
}

/* out = A' W (A x - wanted), or A' W A x where wanted is NULL; one channel. */
static void normal(const lookups *s, const double *x, int channel, int with_wanted, double *out)
{
    memset(out, 0, s->texels * sizeof *out);
    for (size_t r = 0; r < s->rows; r++) {
        const lobe_cube_footprint *f = &s->footprint[r];
        double sum = with_wanted ? -s->wanted[3 * r + (size_t)channel] : 0;
        for (int i = 0; i < f->count; i++)
            sum += f->weight[i] * x[index_of(s->side, f->texel[i])];
        for (int i = 0; i < f->count; i++)
            out[index_of(s->side, f->texel[i])] += f->weight[i] * s->solid_angle[r] * sum;
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
static void solve(const lookups *s, int channel, double *x, double *work)
{
    double *residual = work, *step = work + s->texels, *image = work + 2 * s->texels;
    normal(s, x, channel, 1, residual);
    for (size_t i = 0; i < s->texels; i++)
        step[i] = residual[i] = -residual[i];
    double size = square(residual, s->texels);
    const double enough = 1e-20 * size;
    for (int n = 0; n < STEPS && size > enough; n++) {
        double along = 0;
        normal(s, step, channel, 0, image);
        for (size_t i = 0; i < s->texels; i++)
            along += step[i] * image[i];
        if (!(along > 0))
            return;
        for (size_t i = 0; i < s->texels; i++) {
            x[i] += size / along * step[i];
            residual[i] -= size / along * image[i];
        }
        const double next = square(residual, s->texels), ratio = next / size;
        for (size_t i = 0; i < s->texels; i++)
            step[i] = residual[i] + ratio * step[i];
        size = next;
    }
}

static int prepare(lookups *s, const lobe_prefilter_source *source, const lobe_prefilter_options *o, int mip)
{
    const double width = lobe_prefilter_width(&o->scale, mip);
    lobe_prefilter_group group = {
        o->scale.kernel, lobe_prefilter_parameter(o->scale.kernel, width), o->detail, {0, 0, 0}, 0};
    lobe_prefilter_cells cells = {NULL, 0, 0};
    int good = 1;
    for (int face = 0; face < 6 && good; face++)
        for (int i = 0; i < s->fine && good; i += LOBE_PREFILTER_TILE)
            for (int j = 0; j < s->fine && good; j += LOBE_PREFILTER_TILE) {
                const lobe_prefilter_tile tile = {mip, face, i, j, LOBE_PREFILTER_TILE, LOBE_PREFILTER_TILE};
                good = fill(s, source, &group, &cells, &tile);
            }
    lobe_prefilter_cells_free(&cells);
    return good;
}

int lobe_prefilter_fit(const lobe_prefilter_source *source, const lobe_prefilter_options *o, int mip, lobe_cube *cube)
{
    const int side = lobe_cube_side(o->size, mip);
    lookups s = {side, FINE * side, 6 * (size_t)side * (size_t)side, 0, NULL, NULL, NULL};
    s.rows = s.texels * FINE * FINE;
    s.footprint = malloc(s.rows * sizeof *s.footprint);
    s.solid_angle = malloc(s.rows * sizeof *s.solid_angle);
    s.wanted = malloc(3 * s.rows * sizeof *s.wanted);
    double *x = malloc(4 * s.texels * sizeof *x);
    const int good = s.footprint && s.solid_angle && s.wanted && x && prepare(&s, source, o, mip);
    for (int c = 0; good && c < 3; c++) {
        for (size_t i = 0; i < s.texels; i++)
            x[i] = (double)cube->rgb[mip][3 * i + (size_t)c];
        solve(&s, c, x, x + s.texels);
        for (size_t i = 0; i < s.texels; i++) {
            float *out = &cube->rgb[mip][3 * i + (size_t)c];
            *out = *out >= 0 && x[i] < 0 ? 0 : (float)x[i]; /* no light where there was none */
        }
    }
    free(s.footprint);
    free(s.solid_angle);
    free(s.wanted);
    free(x);
    return good;
}
