/* A clear sky without its disc, for scenes that must not depend on a file: Perez's luminance distribution with
 * Preetham's coefficients for the turbidity, coloured by height, over a ground that reflects a seventh. The seed
 * chooses turbidity 2 to 6, elevation 10 to 70 degrees and azimuth of the sun. */
#include "sky.h"
#include <math.h>

static double next(unsigned *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (*state >> 8) / 16777216.0;
}

int lobe_environment_sky(lobe_environment *map, int width, int height, unsigned seed)
{
    unsigned state = seed * 2654435761u + 12345u;
    next(&state);
    const double t = 2 + 4 * next(&state), elevation = (10 + 60 * next(&state)) * LOBE_PI / 180;
    const double azimuth = 2 * LOBE_PI * next(&state);
    const double sun[3] = {cos(elevation) * cos(azimuth), cos(elevation) * sin(azimuth), sin(elevation)};
    const double a = 0.1787 * t - 1.4630, b = -0.3554 * t + 0.4275, c = -0.0227 * t + 5.3251, e = 0.1206 * t - 2.5771,
                 f = -0.0670 * t + 0.3703;
    const double zenith = (1 + a * exp(b)) * (1 + c * exp(e * (LOBE_PI / 2 - elevation)) + f * sun[2] * sun[2]);
    const double low[3] = {1.00, 0.96, 0.88}, high[3] = {0.42, 0.62, 1.00}, ground[3] = {0.15, 0.14, 0.12};
    if (!lobe_environment_allocate(map, width, height))
        return 0;
    for (int i = 0; i < height; i++)
        for (int j = 0; j < width; j++) {
            double d[3];
            float *out = map->rgb + 3 * ((size_t)i * (size_t)width + (size_t)j);
            lobe_environment_direction(map, i, j, d);
            if (d[2] > 0) {
                const double cosine = fmax(-1, fmin(1, d[0] * sun[0] + d[1] * sun[1] + d[2] * sun[2]));
                const double gamma = acos(cosine), up = fmax(d[2], 0.02);
                const double y = (1 + a * exp(b / up)) * (1 + c * exp(e * gamma) + f * cosine * cosine) / zenith;
                const double mix = sqrt(d[2]);
                for (int k = 0; k < 3; k++)
                    out[k] = (float)(y * (low[k] + (high[k] - low[k]) * mix));
            } else {
                for (int k = 0; k < 3; k++)
                    out[k] = (float)(2 * ground[k]);
            }
        }
    return 1;
}
