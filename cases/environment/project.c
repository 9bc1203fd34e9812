/* Projection of a map that is constant on each texel, without any quadrature: every basis function is a product of a
 * function of the polar angle and one of the azimuth, and both have antiderivatives. A row needs five sums a channel,
 * so this costs less than sampling the basis, and a constant map gives (sqrt(4 pi), 0, ..., 0) to rounding. */
#include "project.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Antiderivatives in theta of sin theta times 1, cos, sin, 3 cos^2 - 1, sin cos, sin^2. */
static void polar(double theta, double a[6])
{
    const double c = cos(theta), s = sin(theta);
    a[0] = -c;
    a[1] = s * s / 2;
    a[2] = theta / 2 - s * c / 2;
    a[3] = c - c * c * c;
    a[4] = s * s * s / 3;
    a[5] = c * c * c / 3 - c;
}

/* Integrals over each column of 1, cos, sin, cos 2, sin 2. */
static void azimuthal(double *table, int w)
{
    for (int j = 0; j < w; j++) {
        const double right = LOBE_PI * (1 - 2 * (j + 1.0) / w), left = LOBE_PI * (1 - 2 * (double)j / w);
        double *t = table + 5 * j;
        t[0] = 2 * LOBE_PI / w;
        t[1] = sin(left) - sin(right);
        t[2] = cos(right) - cos(left);
        t[3] = (sin(2 * left) - sin(2 * right)) / 2;
        t[4] = (cos(2 * right) - cos(2 * left)) / 2;
    }
}

/* One channel of one row: polar integrals times the row's sums. */
static void add_row(double a[9], const double p[6], const double s[5])
{
    a[0] += p[0] * s[0];
    a[1] += p[2] * s[2];
    a[2] += p[1] * s[0];
    a[3] += p[2] * s[1];
    a[4] += p[5] * s[4] / 2;
    a[5] += p[4] * s[2];
    a[6] += p[3] * s[0];
    a[7] += p[4] * s[1];
    a[8] += p[5] * s[3];
}

int lobe_environment_project(const lobe_environment *map, double sh[3][9])
{
    const int w = map->width;
    double *table = malloc(5 * (size_t)w * sizeof *table);
    const double k1 = sqrt(3 / (4 * LOBE_PI)), k2 = sqrt(15 / (4 * LOBE_PI));
    const double scale[9] = {sqrt(1 / (4 * LOBE_PI)), k1, k1, k1, k2, k2, sqrt(5 / (16 * LOBE_PI)), k2, k2 / 2};
    memset(sh, 0, 27 * sizeof(double));
    if (!table)
        return 0;
    azimuthal(table, w);
    for (int i = 0; i < map->height; i++) {
        double top[6], p[6], sum[3][5] = {{0}};
        const float *texel = map->rgb + 3 * (size_t)i * (size_t)w;
        polar(LOBE_PI * i / map->height, top);
        polar(LOBE_PI * (i + 1) / map->height, p);
        for (int k = 0; k < 6; k++)
            p[k] -= top[k];
        for (int j = 0; j < w; j++, texel += 3)
            for (int c = 0; c < 3; c++)
                for (int k = 0; k < 5; k++)
                    sum[c][k] += (double)texel[c] * table[5 * j + k];
        for (int c = 0; c < 3; c++)
            add_row(sh[c], p, sum[c]);
    }
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < 9; k++)
            sh[c][k] *= scale[k];
    free(table);
    return 1;
}

void lobe_sh9_y_up(double c[9])
{
    const double h = sqrt(0.75);
    const double turned[9] = {
        c[0], c[2], -c[3], -c[1], -c[5], -c[7], h * c[8] - 0.5 * c[6], c[4], -h * c[6] - 0.5 * c[8]};
    memcpy(c, turned, sizeof turned);
}
