#include "blurred_cubes.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 160, ROW = SIDE + 1, FACE = ROW * ROW, LEVEL = 6 * FACE, HEIGHT = 384 };

/* Bilinear, between the middles of texels; the poles' rows are held. */
static double map_at(const float *map, int height, const double d[3])
{
    const int width = 2 * height;
    const double x = 0.5 * width * (1 - atan2(d[1], d[0]) / LOBE_PI) - 0.5;
    const double y = fmin(height - 1, fmax(0, height * acos(fmin(1, fmax(-1, d[2]))) / LOBE_PI - 0.5));
    const int i = (int)floor(x), j = y < height - 2 ? (int)y : height - 2;
    const double a = x - i, b = y - j;
    const int left = (i + width) % width, right = (i + 1) % width;
    const double top = (1 - a) * (double)map[j * width + left] + a * (double)map[j * width + right];
    const double below = (1 - a) * (double)map[(j + 1) * width + left] + a * (double)map[(j + 1) * width + right];
    return top + b * (below - top);
}

static void fill_cube(const float *map, int height, float *out)
{
    for (int face = 0; face < 6; face++)
        for (int row = 0; row < ROW; row++)
            for (int column = 0; column < ROW; column++) {
                const int axis = face / 2;
                double d[3], n;
                d[axis] = face % 2 ? 1 : -1;
                d[(axis + 1) % 3] = 2.0 * column / SIDE - 1;
                d[(axis + 2) % 3] = 2.0 * row / SIDE - 1;
                n = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
                for (int k = 0; k < 3; k++)
                    d[k] /= n;
                out[face * FACE + row * ROW + column] = (float)map_at(map, height, d);
            }
}

int lobe_blurred_cubes_of(const lobe_harmonics *harmonics, lobe_blurred_cubes *cubes)
{
    float *map = malloc(sizeof *map * HEIGHT * HEIGHT * 2);
    lobe_harmonics h = *harmonics;
    const size_t bytes = sizeof(double) * 4 * LOBE_ENV_BANDS * LOBE_ENV_BANDS;
    h.coefficient = malloc(bytes);
    cubes->texel = malloc(sizeof *cubes->texel * LOBE_BLUR_LEVELS * LEVEL);
    if (!map || !h.coefficient || !cubes->texel) {
        free(map);
        free(h.coefficient);
        lobe_blurred_cubes_free(cubes);
        return 0;
    }
    memcpy(h.coefficient, harmonics->coefficient, bytes);
    for (int level = 0; level < LOBE_BLUR_LEVELS; level++) {
        /* from the level before: the squares of blurs add */
        const double blur = LOBE_BLUR_FINEST * (1 << level), more = level ? 0.75 * blur * blur : 0;
        const int bands = level < 1 ? LOBE_ENV_BANDS : (int)fmin(LOBE_ENV_BANDS, 4.5 / blur);
        const int height = level < 2 ? HEIGHT : HEIGHT / 2;
        double factor[LOBE_ENV_BANDS];
        for (int l = 0; l < LOBE_ENV_BANDS; l++)
            factor[l] = exp(-0.5 * more * l * (l + 1));
        lobe_harmonics_scale(&h, factor);
        lobe_harmonics_synthesise(&h, bands, height, map);
        fill_cube(map, height, cubes->texel + level * LEVEL);
    }
    free(map);
    free(h.coefficient);
    return 1;
}

void lobe_blurred_cubes_free(lobe_blurred_cubes *cubes)
{
    free(cubes->texel);
    cubes->texel = NULL;
}

double lobe_blurred_cubes_level(double solid_angle)
{
    const double level = log2(fmax(1e-9, 0.7 * sqrt(solid_angle) / LOBE_BLUR_FINEST));
    return fmin(LOBE_BLUR_LEVELS - 1, fmax(0, level));
}

double lobe_blurred_cubes_at(const lobe_blurred_cubes *cubes, const double d[3], double level)
{
    const double x = fabs(d[0]), y = fabs(d[1]), z = fabs(d[2]);
    const int axis = x >= y && x >= z ? 0
                     : y >= z         ? 1
                                      : 2,
              low = level < LOBE_BLUR_LEVELS - 1 ? (int)level : (int)level - 1;
    const double scale = 0.5 * SIDE / fabs(d[axis]), u = d[(axis + 1) % 3] * scale + 0.5 * SIDE,
                 v = d[(axis + 2) % 3] * scale + 0.5 * SIDE, c = level - low;
    const int i = u < SIDE - 1 ? (int)u : SIDE - 1, j = v < SIDE - 1 ? (int)v : SIDE - 1;
    const double a = u - i, b = v - j;
    const float *t = cubes->texel + low * LEVEL + (2 * axis + (d[axis] > 0)) * FACE + j * ROW + i;
    double sum = 0;
    for (int k = 0; k < 2; k++, t += LEVEL) {
        const double top = (double)t[0] + a * ((double)t[1] - (double)t[0]);
        const double below = (double)t[ROW] + a * ((double)t[ROW + 1] - (double)t[ROW]);
        sum += (k ? c : 1 - c) * (top + b * (below - top));
    }
    return sum;
}
