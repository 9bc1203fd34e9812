#include "metric.h"
#include "../fit/random.h"
#include "project.h"
#include "reflect.h"
#include "window.h"
#include <math.h>
#include <stdlib.h>

lobe_environment_metric_options lobe_environment_metric_default(void)
{
    const lobe_environment_metric_options options = {600, 1, 0, 256};
    return options;
}

/* From two numbers in [0, 1), uniform over the sphere. */
static void direction(const double u[2], double d[3])
{
    const double z = 2 * u[0] - 1, phi = 2 * LOBE_PI * u[1], s = sqrt(1 - z * z);
    d[0] = s * cos(phi);
    d[1] = s * sin(phi);
    d[2] = z;
}

/* Adds one orientation's squared errors, and the squared truth. u: roughness, normal, view. */
static void orientation(const lobe_light_texels *texels, double sh[3][9], const double u[5], double *error,
                        double *square)
{
    double n[3], v[3], truth[3], lobe[9], rgb[3];
    direction(u + 1, n);
    direction(u + 3, v);
    const double side = n[0] * v[0] + n[1] * v[1] + n[2] * v[2] < 0 ? -1 : 1;
    for (int k = 0; k < 3; k++)
        v[k] *= side;
    lobe_reflect_texels(texels, u[0], n, v, truth);
    for (int k = 0; k < 3; k++)
        *square += truth[k] * truth[k];
    for (int t = 0; t < LOBE_DIFFUSE_TIERS; t++) {
        lobe_diffuse_lobe((lobe_diffuse_tier)t, u[0], n, v, lobe);
        lobe_diffuse_light(lobe, sh, rgb);
        for (int k = 0; k < 3; k++)
            error[t] += (rgb[k] - truth[k]) * (rgb[k] - truth[k]);
    }
}

/* The sums over all orientations. 0 where there is no memory. */
static int survey(const lobe_light_texels *texels, double sh[3][9], const lobe_environment_metric_options *options,
                  double *error, double *square)
{
    static const double lower[5] = {0, 0, 0, 0, 0}, upper[5] = {1, 1, 1, 1, 1};
    const size_t count = (size_t)options->orientations;
    double *points = malloc(5 * count * sizeof *points);
    lobe_random random;
    if (!points)
        return 0;
    lobe_random_seed(&random, options->seed, 0);
    lobe_random_latin(&random, lower, upper, 5, count, points);
    for (size_t o = 0; o < count; o++)
        orientation(texels, sh, points + 5 * o, error, square);
    free(points);
    return 1;
}

int lobe_environment_metric(const lobe_environment *map, const lobe_environment_metric_options *options,
                            double error[LOBE_DIFFUSE_TIERS])
{
    const int factor = map->width > options->width ? map->width / options->width : 1;
    lobe_environment small;
    lobe_light_texels texels;
    double sh[3][9], square = 0;
    int good = lobe_environment_project(map, sh);
    /* Sides that do not divide keep every texel. */
    if (!good || !lobe_environment_shrink(map, map->width % factor || map->height % factor ? 1 : factor, &small))
        return 0;
    for (int c = 0; c < 3 && options->hanning > 0; c++)
        lobe_sh9_window_hanning(sh[c], options->hanning);
    good = lobe_light_texels_of(&small, &texels);
    lobe_environment_free(&small);
    if (!good)
        return 0;
    for (int t = 0; t < LOBE_DIFFUSE_TIERS; t++)
        error[t] = 0;
    good = survey(&texels, sh, options, error, &square);
    for (int t = 0; t < LOBE_DIFFUSE_TIERS; t++)
        error[t] = square > 0 ? sqrt(error[t] / square) : 0;
    lobe_light_texels_free(&texels);
    return good;
}
