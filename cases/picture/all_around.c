#include "all_around.h"
#include "../env_lobes/response.h"
#include "../env_lobes/visible_normals.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROW = 6, SHARE = 40 }; /* one texel in so many is bright, at most */

static int rising(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double sum_of(const float *rgb) { return (double)rgb[0] + (double)rgb[1] + (double)rgb[2]; }

int lobe_all_around_of(const lobe_cube *cube, lobe_all_around *light)
{
    const int side = cube->size;
    const size_t count = 6 * (size_t)side * (size_t)side;
    double *all = malloc(count * sizeof *all), most;
    memset(light, 0, sizeof *light);
    if (!all)
        return 0;
    for (size_t i = 0; i < count; i++)
        all[i] = sum_of(cube->rgb[0] + 3 * i);
    qsort(all, count, sizeof *all, rising);
    most = all[count - 1 - count / SHARE];
    free(all);
    light->bright = malloc((count / SHARE + 1) * ROW * sizeof *light->bright);
    if (!light->bright || !lobe_pyramid_of(cube, most, &light->rest)) {
        lobe_all_around_free(light);
        return 0;
    }
    for (size_t i = 0; i < count; i++) {
        const float *rgb = cube->rgb[0] + 3 * i;
        const int column = (int)(i % (size_t)side), row = (int)(i / (size_t)side) % side;
        const int face = (int)(i / ((size_t)side * (size_t)side));
        double *out = light->bright + ROW * light->count;
        if (!(sum_of(rgb) > most))
            continue;
        lobe_cube_direction(side, face, row + .5, column + .5, out);
        for (int k = 0; k < 3; k++)
            out[3 + k] = (double)rgb[k] * (1 - most / sum_of(rgb)) *
                         lobe_cube_solid_angle(side, row, column, row + 1, column + 1);
        light->count++;
    }
    return 1;
}

void lobe_all_around_free(lobe_all_around *light)
{
    lobe_pyramid_free(&light->rest);
    free(light->bright);
    light->bright = NULL;
}

void lobe_all_around_truth(const lobe_all_around *light, double alpha, double n_dot_v, double frame[3][3], int order,
                           double *nodes, double rgb[3])
{
    const int count = lobe_visible_nodes(alpha, n_dot_v, order, nodes);
    memset(rgb, 0, 3 * sizeof *rgb);
    for (int i = 0; i < count; i++) {
        const double *n = nodes + 5 * i, level = lobe_pyramid_level(&light->rest, n[4]);
        for (int side = -1; side <= 1; side += 2) {
            double d[3];
            float seen[4];
            for (int k = 0; k < 3; k++)
                d[k] = n[0] * frame[0][k] + side * n[1] * frame[1][k] + n[2] * frame[2][k];
            lobe_pyramid_at(&light->rest, d, level, seen);
            for (int k = 0; k < 3; k++)
                rgb[k] += .5 * n[3] * (double)seen[k];
        }
    }
    for (int i = 0; i < light->count; i++) {
        const double *b = light->bright + ROW * i;
        double l[3], response;
        for (int k = 0; k < 3; k++)
            l[k] = frame[k][0] * b[0] + frame[k][1] * b[1] + frame[k][2] * b[2];
        if (!(l[2] > 0))
            continue;
        response = lobe_response(alpha, n_dot_v, l);
        for (int k = 0; k < 3; k++)
            rgb[k] += response * b[3 + k];
    }
}
