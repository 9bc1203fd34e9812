/* The sums, tile by tile. Every texel adds its cells in the order of the list, so neither vectors nor threads change a
 * bit of it. */
#define LOBE_DOUBLE
#include "kernel.h"
#include "prefilter.h"
#include <math.h>
#include <string.h>

enum { MOST = LOBE_PREFILTER_TILE * LOBE_PREFILTER_TILE };

void lobe_prefilter_tile_directions(const lobe_prefilter_tile *tile, int cube_side, double *d)
{
    for (int i = 0; i < tile->height; i++)
        for (int j = 0; j < tile->width; j++, d += 3)
            lobe_cube_direction(cube_side, tile->face, tile->row + i + 0.5, tile->column + j + 0.5, d);
}

void lobe_prefilter_tile_store(const lobe_prefilter_tile *tile, const double *rgb, lobe_cube *cube)
{
    for (int i = 0; i < tile->height; i++)
        for (int j = 0; j < tile->width; j++) {
            const lobe_cube_texel at = {tile->face, tile->row + i, tile->column + j};
            float *out = lobe_cube_at(cube, tile->mip, at);
            for (int k = 0; k < 3; k++)
                out[k] = (float)*rgb++;
        }
}

void lobe_prefilter_bound(const double *d, int n, lobe_prefilter_group *group)
{
    double sum[3] = {0, 0, 0}, worst = 0;
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 3; k++)
            sum[k] += d[3 * i + k];
    const double length = sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    for (int k = 0; k < 3; k++)
        group->middle[k] = length > 1e-9 ? sum[k] / length : d[k];
    for (int i = 0; i < n; i++) {
        double square = 0;
        for (int k = 0; k < 3; k++)
            square += (d[3 * i + k] - group->middle[k]) * (d[3 * i + k] - group->middle[k]);
        worst = fmax(worst, square);
    }
    group->radius = sqrt(worst);
}

/* MOST directions side by side, so that the compiler makes vectors of them. */
typedef struct lanes {
    double x[MOST], y[MOST], z[MOST];
    double mass[MOST], red[MOST], green[MOST], blue[MOST];
} lanes;

/* The parts of a divided texel, and cells of one colour: half the work. */
static int one_point(const double *cell) { return cell[0] == cell[3] && cell[1] == cell[4] && cell[2] == cell[5]; }

static void add(const double *cell, const double w[MOST], const double v[MOST], lanes *l)
{
    for (int i = 0; i < MOST; i++) {
        l->mass[i] += v[i] * cell[6];
        l->red[i] += w[i] * cell[7];
        l->green[i] += w[i] * cell[8];
        l->blue[i] += w[i] * cell[9];
    }
}

static void sum_ggx(const lobe_prefilter_cells *cells, double parameter, lanes *l)
{
    const double *cell = cells->rows;
    for (size_t n = 0; n < cells->count; n++, cell += LOBE_PREFILTER_ROW) {
        double w[MOST], v[MOST];
        for (int i = 0; i < MOST; i++)
            v[i] = w[i] = lobe_prefilter_ggx(
                lobe_prefilter_below(l->x[i] - cell[0], l->y[i] - cell[1], l->z[i] - cell[2]), parameter);
        if (!one_point(cell))
            for (int i = 0; i < MOST; i++)
                v[i] = lobe_prefilter_ggx(lobe_prefilter_below(l->x[i] - cell[3], l->y[i] - cell[4], l->z[i] - cell[5]),
                                          parameter);
        add(cell, w, v, l);
    }
}

static void sum_sg(const lobe_prefilter_cells *cells, double parameter, lanes *l)
{
    const double *cell = cells->rows;
    for (size_t n = 0; n < cells->count; n++, cell += LOBE_PREFILTER_ROW) {
        double w[MOST], v[MOST];
        for (int i = 0; i < MOST; i++)
            v[i] = w[i] = lobe_prefilter_sg(
                lobe_prefilter_below(l->x[i] - cell[0], l->y[i] - cell[1], l->z[i] - cell[2]), parameter);
        if (!one_point(cell))
            for (int i = 0; i < MOST; i++)
                v[i] = lobe_prefilter_sg(lobe_prefilter_below(l->x[i] - cell[3], l->y[i] - cell[4], l->z[i] - cell[5]),
                                         parameter);
        add(cell, w, v, l);
    }
}

/* n <= MOST directions with the cells of their group. */
static void filter(const lobe_prefilter_cells *cells, lobe_prefilter_kernel kernel, double parameter, const double *d,
                   int n, double *rgb)
{
    lanes l;
    memset(&l, 0, sizeof l);
    for (int i = 0; i < MOST; i++) {
        const double *from = d + 3 * (i < n ? i : 0);
        l.x[i] = from[0];
        l.y[i] = from[1];
        l.z[i] = from[2];
    }
    if (kernel == LOBE_PREFILTER_GGX)
        sum_ggx(cells, parameter, &l);
    else
        sum_sg(cells, parameter, &l);
    for (int i = 0; i < n; i++) {
        rgb[3 * i] = l.red[i] / l.mass[i];
        rgb[3 * i + 1] = l.green[i] / l.mass[i];
        rgb[3 * i + 2] = l.blue[i] / l.mass[i];
    }
}

int lobe_prefilter_group_filter(const lobe_prefilter_source *source, const lobe_prefilter_group *group,
                                lobe_prefilter_cells *cells, const double *d, int n, double *rgb)
{
    if (!lobe_prefilter_gather(source, group, cells))
        return 0;
    filter(cells, group->kernel, group->parameter, d, n, rgb);
    return 1;
}

int lobe_prefilter_directions(const lobe_prefilter_source *source, lobe_prefilter_kernel kernel, double width,
                              double detail, const double *d, int n, double *rgb)
{
    lobe_prefilter_cells cells = {NULL, 0, 0};
    lobe_prefilter_group group = {kernel, lobe_prefilter_parameter(kernel, width), detail, {0, 0, 0}, 0};
    int good = 1;
    for (int i = 0; i < n && good; i++) {
        lobe_prefilter_bound(d + 3 * i, 1, &group);
        good = lobe_prefilter_group_filter(source, &group, &cells, d + 3 * i, 1, rgb + 3 * i);
    }
    lobe_prefilter_cells_free(&cells);
    return good;
}

/* As many samples a side as source texels go into one of the cube's. */
void lobe_prefilter_mirror(const lobe_prefilter_image *image, int size, lobe_cube_texel texel, double rgb[3])
{
    int charts, rows, columns;
    lobe_prefilter_image_size(image, &charts, &rows, &columns);
    const double ratio = image->map ? 2.0 * rows / (LOBE_PI * size) : (double)rows / size;
    const int n = (int)ceil(ratio - 1e-9) > 1 ? (int)ceil(ratio - 1e-9) : 1;
    double sum[3] = {0, 0, 0}, mass = 0;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            const double row = texel.row + (i + 0.5) / n, column = texel.column + (j + 0.5) / n;
            double d[3], value[3];
            lobe_cube_direction(size, texel.face, row, column, d);
            const double s = 2 * column / size - 1, t = 2 * row / size - 1, r2 = 1 + s * s + t * t;
            const double weight = 1 / (r2 * sqrt(r2)); /* solid angle */
            lobe_prefilter_image_sample(image, d, value);
            mass += weight;
            for (int k = 0; k < 3; k++)
                sum[k] += weight * value[k];
        }
    for (int k = 0; k < 3; k++)
        rgb[k] = sum[k] / mass;
}
