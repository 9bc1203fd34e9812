#include "environments.h"
#include "../../models/lobe.h"
#include "../prefilter/cube_sample.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *const lobe_around_column[LOBE_AROUND_COLUMNS] = {"truth",  "split sum", "1 tap",
                                                             "2 taps", "4 taps",    "8 taps"};
const double lobe_around_alpha[LOBE_AROUND_ALPHAS] = {.05, .12, .3, .7};

/* The ball stands on the floor z = 0; the eye looks along +y. */
static const double eye[3] = {0, -5, 1.6}, target[3] = {0, 0, .55}, ball[3] = {-1.1, .4, .95};
static const double ball_radius = .95, half_width = .58;

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* out = a + t b, of unit length */
static void unit_sum(const double a[3], double t, const double b[3], double out[3])
{
    double sum[3], length;
    for (int k = 0; k < 3; k++)
        sum[k] = a[k] + t * b[k];
    length = sqrt(dot(sum, sum));
    for (int k = 0; k < 3; k++)
        out[k] = sum[k] / length;
}

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

int lobe_around_of(const lobe_environment *map, int side, double turn, int threads, lobe_around *around)
{
    lobe_prefilter_options options = lobe_prefilter_options_default(LOBE_PREFILTER_GGX, side);
    const lobe_prefilter_image image = {map, NULL, 0};
    char error[200];
    memset(around, 0, sizeof *around);
    options.threads = threads;
    around->scale = options.scale;
    around->turn = turn;
    around->order = LOBE_AROUND_ORDER;
    if (lobe_prefilter(&image, &options, &around->cube, error, sizeof error) != LOBE_PREFILTER_DONE)
        return 0;
    if (!lobe_all_around_of(&around->cube, &around->light)) {
        lobe_cube_free(&around->cube);
        return 0;
    }
    return 1;
}

void lobe_around_free(lobe_around *around)
{
    lobe_cube_free(&around->cube);
    lobe_all_around_free(&around->light);
}

double lobe_around_brightest(const lobe_environment *map)
{
    double most = -1, d[3], azimuth = 0;
    for (int i = 0; i < map->height; i++)
        for (int j = 0; j < map->width; j++) {
            const float *t = map->rgb + 3 * ((size_t)i * (size_t)map->width + (size_t)j);
            const double bright = (double)t[0] + (double)t[1] + (double)t[2];
            if (bright > most) {
                most = bright;
                lobe_environment_direction(map, i, j, d);
                azimuth = atan2(d[1], d[0]);
            }
        }
    return azimuth;
}

/* From the picture's world to the map's. */
static void to_map(const lobe_around *around, const double d[3], double out[3])
{
    const double c = cos(around->turn), s = sin(around->turn);
    out[0] = c * d[1] + s * d[0];
    out[1] = s * d[1] - c * d[0];
    out[2] = d[2];
}

/* 1 and the surface's view and normal, or 0; the ray in either case. */
static int hit(double x, double y, double ray[3], double view[3], double normal[3])
{
    static const double up[3] = {0, 0, 1};
    double forward[3], right[3], above[3], to[3], b, d, on_ball, on_floor;
    unit_sum(target, -1, eye, forward);
    cross(forward, up, right);
    unit_sum(right, 0, right, right);
    cross(right, forward, above);
    for (int k = 0; k < 3; k++) {
        ray[k] = forward[k] + half_width * (x * right[k] + y * above[k]);
        to[k] = ball[k] - eye[k];
    }
    unit_sum(ray, 0, ray, ray);
    b = dot(ray, to);
    d = b * b - dot(to, to) + ball_radius * ball_radius;
    on_ball = d < 0 ? INFINITY : b - sqrt(d);
    on_floor = ray[2] < 0 ? -eye[2] / ray[2] : INFINITY;
    for (int k = 0; k < 3; k++) {
        view[k] = -ray[k];
        normal[k] = on_ball < on_floor ? (on_ball * ray[k] - to[k]) / ball_radius : up[k];
    }
    return on_ball < INFINITY || on_floor < INFINITY;
}

int lobe_around_see(const lobe_around *around, double x, double y, double rgb[3])
{
    double ray[3], view[3], normal[3], d[3];
    const int surface = hit(x, y, ray, view, normal);
    to_map(around, ray, d);
    if (!surface)
        lobe_cube_sample_mip(&around->cube, 0, d, rgb);
    return surface;
}

static int taps_of(int column, float roughness, float v, lobe_env_tap_f32 taps[8])
{
    static const int count[LOBE_AROUND_COLUMNS] = {0, 1, 1, 2, 4, 8};
    if (column == 1) {
        /* the mirror direction, and the kernel that is the lobe at normal view */
        taps[0].angle = acosf(v);
        taps[0].width = roughness;
        taps[0].weight = lobe_energy_high_f32(roughness, v);
    } else if (column == 2) {
        lobe_env_lobes1_f32(roughness, v, taps);
    } else if (column == 3) {
        lobe_env_lobes2_f32(roughness, v, taps);
    } else if (column == 4) {
        lobe_env_lobes4_f32(roughness, v, taps);
    } else {
        lobe_env_lobes8_f32(roughness, v, taps);
    }
    return count[column];
}

void lobe_around_reflect(const lobe_around *around, double alpha, const double view[3], const double normal[3],
                         double *nodes, double rgb[LOBE_AROUND_COLUMNS][3])
{
    static const double across[3] = {0, 1, 0};
    const double v = fmin(1, fmax(.002, dot(view, normal)));
    const double roughness = sqrt(alpha);
    double frame[3][3], *x = frame[0], *z = frame[2], side[3];
    /* the view's side; any where there is none */
    unit_sum(view, -dot(view, normal), normal, x);
    if (!(dot(x, x) > .5)) {
        cross(across, normal, side);
        unit_sum(side, 0, side, x);
    }
    to_map(around, x, side);
    memcpy(x, side, sizeof side);
    to_map(around, normal, z);
    cross(z, x, frame[1]);
    lobe_all_around_truth(&around->light, alpha, v, frame, around->order, nodes, rgb[0]);
    for (int c = 1; c < LOBE_AROUND_COLUMNS; c++) {
        lobe_env_tap_f32 taps[8];
        const int count = taps_of(c, (float)roughness, (float)v, taps);
        memset(rgb[c], 0, sizeof rgb[c]);
        for (int i = 0; i < count; i++) {
            double d[3], light[3];
            for (int k = 0; k < 3; k++)
                d[k] = cos((double)taps[i].angle) * z[k] - sin((double)taps[i].angle) * x[k];
            lobe_cube_sample(&around->cube, &around->scale, d, (double)taps[i].width, light);
            for (int k = 0; k < 3; k++)
                rgb[c][k] += (double)taps[i].weight * light[k];
        }
    }
}

void lobe_around_shade(void *context, const double *points, size_t count, double *rgb)
{
    const lobe_around *around = context;
    double *nodes = malloc(5 * (size_t)around->order * (size_t)around->order * sizeof *nodes);
    for (size_t i = 0; i < count; i++, points += 2, rgb += LOBE_AROUND_VALUES) {
        double ray[3], view[3], normal[3];
        memset(rgb, 0, LOBE_AROUND_VALUES * sizeof *rgb);
        if (!nodes)
            rgb[0] = NAN;
        else if (hit(points[0], points[1], ray, view, normal))
            for (int a = 0; a < LOBE_AROUND_ALPHAS; a++) {
                double out[LOBE_AROUND_COLUMNS][3];
                lobe_around_reflect(around, lobe_around_alpha[a], view, normal, nodes, out);
                memcpy(rgb + 3 * LOBE_AROUND_COLUMNS * a, out, sizeof out);
            }
    }
    free(nodes);
}
