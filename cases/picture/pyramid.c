#include "pyramid.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* row and column from -1 to side. */
static float *texel(const lobe_pyramid *p, int level, int face, int row, int column)
{
    const int wide = lobe_cube_side(p->size, level) + 2;
    return p->texel[level] + 4 * ((size_t)(face * wide + row + 1) * (size_t)wide + (size_t)column + 1);
}

/* The mean of four texels, by their solid angles. */
static void halve(const lobe_pyramid *p, int level, int face, int row, int column, float *out)
{
    const int side = lobe_cube_side(p->size, level - 1);
    double sum[4] = {0, 0, 0, 0}, all = 0;
    int i, k;
    for (i = 0; i < 4; i++) {
        const int r = 2 * row + i / 2, c = 2 * column + i % 2;
        const double angle = lobe_cube_solid_angle(side, r, c, r + 1, c + 1);
        for (k = 0; k < 3; k++)
            sum[k] += angle * (double)texel(p, level - 1, face, r, c)[k];
        all += angle;
    }
    for (k = 0; k < 4; k++)
        out[k] = (float)(sum[k] / all);
}

/* What bilinear lookups at a face's rim need; at the corners the mean of the three texels that meet. */
static void border(const lobe_pyramid *p, int level)
{
    const int side = lobe_cube_side(p->size, level);
    int face, i, k;
    for (face = 0; face < 6; face++) {
        for (i = 0; i < 4 * side; i++) {
            const int at = i / 4, edge = i % 4;
            const lobe_cube_texel out = {face, edge < 2 ? edge * (side + 1) - 1 : at,
                                         edge < 2 ? at : (edge - 2) * (side + 1) - 1};
            const lobe_cube_texel in = lobe_cube_fold(side, out);
            memcpy(texel(p, level, face, out.row, out.column), texel(p, level, in.face, in.row, in.column),
                   4 * sizeof(float));
        }
        for (i = 0; i < 4; i++) {
            const int row = i / 2 ? side : -1, column = i % 2 ? side : -1;
            const int inside = i / 2 ? side - 1 : 0, beside = i % 2 ? side - 1 : 0;
            float *out = texel(p, level, face, row, column);
            for (k = 0; k < 4; k++)
                out[k] = (texel(p, level, face, inside, beside)[k] + texel(p, level, face, row, beside)[k] +
                          texel(p, level, face, inside, column)[k]) /
                         3;
        }
    }
}

static void first(const lobe_cube *cube, lobe_cube_texel at, double most, float *out)
{
    const float *rgb = lobe_cube_at(cube, 0, at);
    const double sum = (double)rgb[0] + (double)rgb[1] + (double)rgb[2], part = sum > most ? most / sum : 1;
    int k;
    for (k = 0; k < 3; k++)
        out[k] = (float)(part * (double)rgb[k]);
    out[3] = 0;
}

int lobe_pyramid_of(const lobe_cube *cube, double most, lobe_pyramid *p)
{
    int level, face, row, column;
    memset(p, 0, sizeof *p);
    p->size = cube->size;
    /* a power of two goes down to one texel a face */
    for (p->levels = 1; lobe_cube_side(p->size, p->levels - 1) % 2 == 0; p->levels++)
        ;
    for (level = 0; level < p->levels; level++) {
        const int side = lobe_cube_side(p->size, level);
        p->texel[level] = malloc(24 * (size_t)(side + 2) * (size_t)(side + 2) * sizeof(float));
        if (!p->texel[level]) {
            lobe_pyramid_free(p);
            return 0;
        }
        for (face = 0; face < 6; face++)
            for (row = 0; row < side; row++)
                for (column = 0; column < side; column++) {
                    float *out = texel(p, level, face, row, column);
                    if (level > 0)
                        halve(p, level, face, row, column, out);
                    else
                        first(cube, (lobe_cube_texel){face, row, column}, most, out);
                }
        border(p, level);
    }
    return 1;
}

void lobe_pyramid_free(lobe_pyramid *p)
{
    int level;
    for (level = 0; level < LOBE_CUBE_MAX_MIPS; level++)
        free(p->texel[level]);
    memset(p, 0, sizeof *p);
}

double lobe_pyramid_level(const lobe_pyramid *p, double solid_angle)
{
    const double texel_angle = 4 * 3.14159265358979323846 / (6.0 * p->size * p->size);
    return 0.5 * log2(fmax(1e-12, solid_angle) / texel_angle);
}

void lobe_pyramid_at(const lobe_pyramid *p, const double d[3], double level, float rgb[4])
{
    const double at = fmin(p->levels - 1, fmax(0, level));
    const int fine = at < p->levels - 1 ? (int)at : p->levels - 2;
    double row, column;
    const int face = lobe_cube_position(1, d, &row, &column);
    int step, k;
    memset(rgb, 0, 4 * sizeof *rgb);
    for (step = p->levels > 1 ? 0 : 1; step < 2; step++) {
        const int which = fine + step, side = lobe_cube_side(p->size, which), next = 4 * (side + 2);
        const double y = row * side - 0.5, x = column * side - 0.5;
        const int j = (int)floor(y), i = (int)floor(x);
        const float *t = texel(p, which, face, j, i);
        const float b = (float)(y - j), a = (float)(x - i), part = (float)(step ? at - fine : 1 - (at - fine));
        const float w0 = part * (1 - b) * (1 - a), w1 = part * (1 - b) * a, w2 = part * b * (1 - a), w3 = part * b * a;
        for (k = 0; k < 4; k++)
            rgb[k] += w0 * t[k] + w1 * t[k + 4] + w2 * t[next + k] + w3 * t[next + 4 + k];
    }
}
