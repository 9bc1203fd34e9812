#include "cube_sample.h"
#include <math.h>

static void add(lobe_cube_footprint *f, lobe_cube_texel texel, double weight)
{
    f->texel[f->count] = texel;
    f->weight[f->count++] = weight;
}

/* A place of the grid that may lie beyond one edge, or beyond a corner, where three texels meet and no fourth. */
static void place(int side, lobe_cube_texel at, double weight, lobe_cube_footprint *f)
{
    const int row_out = at.row < 0 || at.row >= side, column_out = at.column < 0 || at.column >= side;
    if (row_out && column_out) {
        const lobe_cube_texel inside = {at.face, at.row < 0 ? 0 : side - 1, at.column < 0 ? 0 : side - 1};
        const lobe_cube_texel beside = {at.face, inside.row, at.column}, below = {at.face, at.row, inside.column};
        add(f, inside, weight / 3);
        add(f, lobe_cube_fold(side, beside), weight / 3);
        add(f, lobe_cube_fold(side, below), weight / 3);
    } else {
        add(f, row_out || column_out ? lobe_cube_fold(side, at) : at, weight);
    }
}

void lobe_cube_footprint_of(int side, const double d[3], lobe_cube_footprint *f)
{
    double row, column;
    const int face = lobe_cube_position(side, d, &row, &column);
    const double top = floor(row - 0.5), left = floor(column - 0.5);
    const double y = row - 0.5 - top, x = column - 0.5 - left;
    f->count = 0;
    for (int i = 0; i < 4; i++) {
        const lobe_cube_texel at = {face, (int)top + i / 2, (int)left + i % 2};
        const double weight = (i / 2 ? y : 1 - y) * (i % 2 ? x : 1 - x);
        if (weight != 0) /* exactly on a row or column the next one is not wanted */
            place(side, at, weight, f);
    }
}

void lobe_cube_sample_mip(const lobe_cube *cube, int mip, const double d[3], double rgb[3])
{
    lobe_cube_footprint f;
    lobe_cube_footprint_of(lobe_cube_side(cube->size, mip), d, &f);
    for (int k = 0; k < 3; k++)
        rgb[k] = 0;
    for (int i = 0; i < f.count; i++) {
        const float *texel = lobe_cube_at(cube, mip, f.texel[i]);
        for (int k = 0; k < 3; k++)
            rgb[k] += f.weight[i] * (double)texel[k];
    }
}

void lobe_cube_sample_lod(const lobe_cube *cube, const double d[3], double lod, double rgb[3])
{
    const double top = cube->mips - 1, level = lod > 0 ? (lod < top ? lod : top) : 0;
    const int fine = (int)level;
    const double f = level - fine;
    lobe_cube_sample_mip(cube, fine, d, rgb);
    if (f > 0) {
        double coarse[3];
        lobe_cube_sample_mip(cube, fine + 1, d, coarse);
        for (int k = 0; k < 3; k++)
            rgb[k] += f * (coarse[k] - rgb[k]);
    }
}

void lobe_cube_sample(const lobe_cube *cube, const lobe_prefilter_scale *scale, const double d[3], double width,
                      double rgb[3])
{
    lobe_cube_sample_lod(cube, d, lobe_prefilter_lod(scale, width), rgb);
}
