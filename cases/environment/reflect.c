#include "reflect.h"
#include <math.h>
#include <stdlib.h>

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

int lobe_light_texels_of(const lobe_environment *map, lobe_light_texels *texels)
{
    const size_t count = (size_t)map->width * (size_t)map->height;
    double *all = malloc(6 * count * sizeof *all);
    texels->count = (int)count;
    texels->x = all;
    if (!all)
        return 0;
    texels->y = all + count;
    texels->z = all + 2 * count;
    for (size_t k = 0; k < 3; k++)
        texels->light[k] = all + (3 + k) * count;
    size_t t = 0;
    for (int i = 0; i < map->height; i++) {
        const double angle = lobe_environment_solid_angle(map, i);
        for (int j = 0; j < map->width; j++, t++) {
            double d[3];
            lobe_environment_direction(map, i, j, d);
            texels->x[t] = d[0];
            texels->y[t] = d[1];
            texels->z[t] = d[2];
            for (size_t k = 0; k < 3; k++)
                texels->light[k][t] = (double)map->rgb[3 * t + k] * angle / LOBE_PI;
        }
    }
    return 1;
}

void lobe_light_texels_free(lobe_light_texels *texels)
{
    free(texels->x);
    texels->x = NULL;
}

enum { LANES = 4 }; /* sums a channel: one sum would wait for itself at every texel */

void lobe_reflect_texels(const lobe_light_texels *texels, double roughness, const double n[3], const double view[3],
                         double rgb[3])
{
    const double *x = texels->x, *y = texels->y, *z = texels->z;
    const double *red = texels->light[0], *green = texels->light[1], *blue = texels->light[2];
    const double n0 = n[0], n1 = n[1], n2 = n[2], v0 = view[0], v1 = view[1], v2 = view[2];
    const double out = 1 - fmin(1, fmax(0, dot(n, view))), grazing = out * out * out * out * out;
    double sum[3][LANES] = {{0}};
    int t = 0;
    for (; t + LANES <= texels->count; t += LANES)
        for (int k = 0; k < LANES; k++) {
            const double cosine = n0 * x[t + k] + n1 * y[t + k] + n2 * z[t + k];
            const double l = cosine > 0 ? cosine : 0;
            const double l_dot_v = v0 * x[t + k] + v1 * y[t + k] + v2 * z[t + k];
            const double f = roughness * (1 + l_dot_v) - 0.5; /* FD90 - 1, as 2 (L.H)^2 = 1 + L.V */
            const double in = 1 - l, in2 = in * in;
            const double value = (1 + f * (in2 * in2 * in)) * (1 + f * grazing) * l;
            sum[0][k] += value * red[t + k];
            sum[1][k] += value * green[t + k];
            sum[2][k] += value * blue[t + k];
        }
    for (int k = 0; k < 3; k++)
        rgb[k] = (sum[k][0] + sum[k][1]) + (sum[k][2] + sum[k][3]);
    for (; t < texels->count; t++) {
        const double d[3] = {x[t], y[t], z[t]};
        const double light[3] = {red[t] * LOBE_PI, green[t] * LOBE_PI, blue[t] * LOBE_PI};
        lobe_reflect_burley(d, light, roughness, n, view, rgb);
    }
}

void lobe_reflect_burley(const double direction[3], const double irradiance[3], double roughness, const double n[3],
                         const double view[3], double rgb[3])
{
    const double l = dot(n, direction), f = roughness * (1 + dot(direction, view)) - 0.5;
    if (!(l > 0))
        return;
    const double value = (1 + f * pow(1 - fmin(1, l), 5)) * (1 + f * pow(1 - fmin(1, fmax(0, dot(n, view))), 5));
    for (int k = 0; k < 3; k++)
        rgb[k] += irradiance[k] * value * l / LOBE_PI;
}

void lobe_reflect_lambert(const double direction[3], const double irradiance[3], const double n[3], double rgb[3])
{
    const double l = fmax(0, dot(n, direction));
    for (int k = 0; k < 3; k++)
        rgb[k] += irradiance[k] * l / LOBE_PI;
}
