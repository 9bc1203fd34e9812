/* The brightest texel is the sun's core. What a disc of 5 degrees around it holds above four times the mean of the ring
 * from 5 to 8 degrees is the sun; the map keeps the ring's mean there. Its direction is the centroid of what was
 * taken. */
#include "sun.h"
#include <math.h>
#include <string.h>

#define DISC (5 * LOBE_PI / 180)
#define RING (8 * LOBE_PI / 180)
#define ABOVE 4

static double luminance(const float *t)
{
    return 0.2126 * (double)t[0] + 0.7152 * (double)t[1] + 0.0722 * (double)t[2];
}

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static float *texel(const lobe_environment *map, int i, int j)
{
    return map->rgb + 3 * ((size_t)i * (size_t)map->width + (size_t)j);
}

/* The direction of the brightest texel. */
static void find_core(const lobe_environment *map, double core[3])
{
    double peak = -1;
    for (int i = 0; i < map->height; i++)
        for (int j = 0; j < map->width; j++) {
            const double y = luminance(texel(map, i, j));
            if (y > peak) {
                peak = y;
                lobe_environment_direction(map, i, j, core);
            }
        }
}

/* The irradiance of all directions, summed over channels, that a surface sees on average (pi times the mean radiance),
 * and the mean radiance of the ring. 0 where no texel lies in the ring. */
static int survey(const lobe_environment *map, const double core[3], double *mean, float level[3])
{
    double sum[3] = {0, 0, 0}, ring = 0, d[3];
    *mean = 0;
    for (int i = 0; i < map->height; i++) {
        const double angle = lobe_environment_solid_angle(map, i);
        for (int j = 0; j < map->width; j++) {
            const float *t = texel(map, i, j);
            *mean += ((double)t[0] + (double)t[1] + (double)t[2]) * angle / 4;
            lobe_environment_direction(map, i, j, d);
            const double c = dot(d, core);
            if (c > cos(DISC) || c <= cos(RING))
                continue;
            ring += angle;
            for (int k = 0; k < 3; k++)
                sum[k] += (double)t[k] * angle;
        }
    }
    for (int k = 0; k < 3 && ring > 0; k++)
        level[k] = (float)(sum[k] / ring);
    return ring > 0;
}

/* Sums up the sun, or takes it out of the map: the same texels. */
static void visit(lobe_environment *map, const double core[3], const float level[3], lobe_sun *sun, int take)
{
    double d[3];
    for (int i = 0; i < map->height; i++) {
        const double angle = lobe_environment_solid_angle(map, i);
        for (int j = 0; j < map->width; j++) {
            float *t = texel(map, i, j);
            lobe_environment_direction(map, i, j, d);
            if (dot(d, core) <= cos(DISC) || luminance(t) <= ABOVE * luminance(level))
                continue;
            sun->solid_angle += take ? 0 : angle;
            for (int k = 0; k < 3; k++) {
                if (take) {
                    t[k] = fminf(t[k], level[k]);
                } else {
                    sun->direction[k] += d[k] * (luminance(t) - luminance(level)) * angle;
                    sun->irradiance[k] += fmax(0, (double)t[k] - (double)level[k]) * angle;
                }
            }
        }
    }
}

int lobe_environment_take_sun(lobe_environment *map, double share, lobe_sun *sun)
{
    double core[3] = {0, 0, 1}, mean;
    float level[3];
    memset(sun, 0, sizeof *sun);
    find_core(map, core);
    if (!survey(map, core, &mean, level))
        return 0;
    visit(map, core, level, sun, 0);
    const double length = sqrt(dot(sun->direction, sun->direction));
    if (!(length > 0) || sun->irradiance[0] + sun->irradiance[1] + sun->irradiance[2] < share * mean)
        return 0;
    for (int k = 0; k < 3; k++)
        sun->direction[k] /= length;
    visit(map, core, level, sun, 1);
    return 1;
}
