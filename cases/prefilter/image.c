/* Where the texels of what is filtered look: an equirectangular map, or a cube. */
#include "cube_sample.h"
#include "source.h"
#include <math.h>

void lobe_prefilter_image_size(const lobe_prefilter_image *image, int *charts, int *rows, int *columns)
{
    *charts = image->map ? 1 : 6;
    *rows = image->map ? image->map->height : image->cube->size;
    *columns = image->map ? image->map->width : image->cube->size;
}

const float *lobe_prefilter_image_texel(const lobe_prefilter_image *image, int chart, int row, int column)
{
    const lobe_cube_texel t = {chart, row, column};
    if (image->map)
        return image->map->rgb + 3 * ((size_t)row * (size_t)image->map->width + (size_t)column);
    return lobe_cube_at(image->cube, 0, t);
}

/* From the map's world, z up, to that of the directions. */
static void turn(const lobe_prefilter_image *image, double d[3])
{
    if (image->map && image->y_up) {
        const double x = d[0], y = d[1], z = d[2];
        d[0] = -y;
        d[1] = z;
        d[2] = -x;
    }
}

void lobe_prefilter_image_direction(const lobe_prefilter_image *image, int chart, double row, double column,
                                    double d[3])
{
    if (!image->map) {
        lobe_cube_direction(image->cube->size, chart, row, column, d);
        return;
    }
    const double theta = LOBE_PI * row / image->map->height, phi = LOBE_PI * (1 - 2 * column / image->map->width);
    d[0] = sin(theta) * cos(phi);
    d[1] = sin(theta) * sin(phi);
    d[2] = cos(theta);
    turn(image, d);
}

double lobe_prefilter_image_moment(const lobe_prefilter_image *image, int chart, double top, double left, double bottom,
                                   double right, double moment[3])
{
    if (!image->map) {
        const double angle = lobe_cube_solid_angle(image->cube->size, top, left, bottom, right);
        lobe_cube_direction(image->cube->size, chart, (top + bottom) / 2, (left + right) / 2, moment);
        for (int k = 0; k < 3; k++)
            moment[k] *= angle;
        return angle;
    }
    /* Differences of trigonometric functions as products: no cancellation for a small rectangle. */
    const double t = LOBE_PI * (top + bottom) / 2 / image->map->height,
                 dt = LOBE_PI * (bottom - top) / 2 / image->map->height;
    const double p = LOBE_PI * (1 - (left + right) / image->map->width),
                 dp = LOBE_PI * (right - left) / image->map->width;
    const double inward = dt - cos(2 * t) * sin(dt) * cos(dt); /* integral of sin^2 over the polar angle */
    moment[0] = inward * 2 * cos(p) * sin(dp);
    moment[1] = inward * 2 * sin(p) * sin(dp);
    moment[2] = sin(2 * t) * sin(dt) * cos(dt) * 2 * dp; /* integral of sin cos = sin(2t) sin(2dt) / 2 */
    turn(image, moment);
    return 2 * sin(t) * sin(dt) * 2 * dp;
}

void lobe_prefilter_image_sample(const lobe_prefilter_image *image, const double d[3], double rgb[3])
{
    const lobe_environment *map = image->map;
    if (!map) {
        lobe_cube_sample_mip(image->cube, 0, d, rgb);
        return;
    }
    const double x = image->y_up ? -d[2] : d[0], y = image->y_up ? -d[0] : d[1], z = image->y_up ? d[1] : d[2];
    const double row = atan2(sqrt(x * x + y * y), z) / LOBE_PI * map->height - 0.5;
    const double column = (1 - atan2(y, x) / LOBE_PI) / 2 * map->width - 0.5;
    const double top = floor(row), left = floor(column), v = row - top, u = column - left;
    for (int k = 0; k < 3; k++)
        rgb[k] = 0;
    for (int i = 0; i < 4; i++) {
        int r = (int)top + i / 2, c = (int)left + i % 2;
        const double weight = (i / 2 ? v : 1 - v) * (i % 2 ? u : 1 - u);
        if (r < 0 || r >= map->height) { /* over the pole: the same row, half way round */
            r = r < 0 ? 0 : map->height - 1;
            c += map->width / 2;
        }
        const float *texel = lobe_prefilter_image_texel(image, 0, r, (c + map->width) % map->width);
        for (int k = 0; k < 3; k++)
            rgb[k] += weight * (double)texel[k];
    }
}
