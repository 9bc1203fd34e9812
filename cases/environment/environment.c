#include "environment.h"
#include <math.h>
#include <stdlib.h>

int lobe_environment_allocate(lobe_environment *map, int width, int height)
{
    map->width = width;
    map->height = height;
    map->rgb = calloc((size_t)width * (size_t)height * 3, sizeof *map->rgb);
    return map->rgb != NULL;
}

void lobe_environment_free(lobe_environment *map)
{
    free(map->rgb);
    map->rgb = NULL;
}

double lobe_environment_solid_angle(const lobe_environment *map, int row)
{
    const double middle = LOBE_PI * (row + 0.5) / map->height, half = LOBE_PI * 0.5 / map->height;
    return 2 * sin(middle) * sin(half) * 2 * LOBE_PI / map->width; /* cos top - cos bottom, without cancellation */
}

void lobe_environment_direction(const lobe_environment *map, int row, int column, double d[3])
{
    const double theta = LOBE_PI * (row + 0.5) / map->height;
    const double phi = LOBE_PI * (1 - 2 * (column + 0.5) / map->width);
    d[0] = sin(theta) * cos(phi);
    d[1] = sin(theta) * sin(phi);
    d[2] = cos(theta);
}

/* One block of the map, whose top left texel this is. */
static void average(const lobe_environment *map, int row, int column, int factor, float out[3])
{
    double sum[3] = {0, 0, 0}, weight = 0;
    for (int y = row; y < row + factor; y++) {
        const double angle = lobe_environment_solid_angle(map, y);
        const float *t = map->rgb + 3 * ((size_t)y * (size_t)map->width + (size_t)column);
        weight += angle * factor;
        for (int x = 0; x < factor; x++, t += 3)
            for (int k = 0; k < 3; k++)
                sum[k] += angle * (double)t[k];
    }
    for (int k = 0; k < 3; k++)
        out[k] = (float)(sum[k] / weight);
}

int lobe_environment_shrink(const lobe_environment *map, int factor, lobe_environment *small)
{
    if (factor < 1 || map->width % factor || map->height % factor ||
        !lobe_environment_allocate(small, map->width / factor, map->height / factor))
        return 0;
    for (int i = 0; i < small->height; i++)
        for (int j = 0; j < small->width; j++)
            average(map, i * factor, j * factor, factor,
                    small->rgb + 3 * ((size_t)i * (size_t)small->width + (size_t)j));
    return 1;
}
