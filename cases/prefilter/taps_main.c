/* What the cube itself costs a shader: the split sum and env_lobes with 1, 2, 4 and 8 taps against the integral of
 * light times response, once with every tap filtered exactly and once read from the half-float cube by the reference
 * sampler.
 *
 * prefilter_taps SIZE [FILE...]     a room with lamps, then the files
 * 30 points of (alpha, n_dot_v), 64 random orientations each; the mean of the colours is compared. */
#define LOBE_DOUBLE 1
#include "cube_sample.h"
#include "half.h"
#include "prefilter.h"
#include "../../models/env_lobes1.h"
#include "../../models/env_lobes2.h"
#include "../../models/env_lobes4.h"
#include "../../models/env_lobes8.h"
#include "../env_lobes/response.h"
#include "../env_lobes/rooms.h"
#include "../fit/parallel.h"
#include "../fit/random.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ALPHAS = 6, VIEWS = 5, POINTS = ALPHAS * VIEWS, ORIENTATIONS = 64, MODELS = 5, SOURCES = 3, MOST_TAPS = 8 };
/* Of the response's own scale; .1 changes no printed digit by more than 1. */
#define DETAIL 0.3

static const double alphas[ALPHAS] = {.04, .08, .16, .32, .6, 1}, views[VIEWS] = {.05, .25, .5, .75, 1};
static const char *const model_name[MODELS] = {"split sum", "1 tap", "2 taps", "4 taps", "8 taps"};

/* What a texel is: its direction (not of unit length: the integral of the direction over it) and solid angle. */
typedef struct texel {
    double moment[3], angle, light;
} texel;

typedef struct scene {
    const lobe_prefilter_source *source;
    const lobe_prefilter_scale *scale;
    const lobe_cube *cube[SOURCES]; /* NULL: filtered exactly */
    const texel *texels;
    size_t count;
    double frame[ORIENTATIONS][3][3]; /* x y z in the world */
} scene;

static int bad(const char *why)
{
    fprintf(stderr, "prefilter_taps: %s\n", why);
    return 2;
}

static int taps_of(int model, double alpha, double v, lobe_env_tap *t)
{
    const double r = sqrt(alpha);
    if (model == 4) {
        const lobe_env_fan8 f = lobe_env_lobes_lobes8(r, v, 1);
        const lobe_env_tap all[8] = {f.t0, f.t1, f.t2, f.t3, f.t4, f.t5, f.t6, f.t7};
        memcpy(t, all, sizeof all);
        return 8;
    }
    if (model == 3) {
        const lobe_env_fan4 f = lobe_env_lobes_lobes4(r, v, 1);
        const lobe_env_tap all[4] = {f.t0, f.t1, f.t2, f.t3};
        memcpy(t, all, sizeof all);
        return 4;
    }
    if (model == 2) {
        const lobe_env_fan2 f = lobe_env_lobes_lobes2(r, v, 1);
        t[0] = f.t0;
        t[1] = f.t1;
        return 2;
    }
    if (model == 1) {
        t[0] = lobe_env_lobes_lobes1(r, v, 1);
    } else {
        t->angle = acos(v);
        t->width = r;
        t->weight = 1;
    }
    return 1;
}

static void to_frame(const double frame[3][3], const double world[3], double local[3])
{
    for (int i = 0; i < 3; i++)
        local[i] = frame[i][0] * world[0] + frame[i][1] * world[1] + frame[i][2] * world[2];
}

/* How far the light may move before the response changes much: the half vector's own scale, seen through the
 * reflection, which squeezes it at grazing angles. */
static double response_scale(double alpha, double v, const double l[3])
{
    const double x = sqrt(1 - v * v) + l[0], z = v + l[2], across = x * x + l[1] * l[1], square = across + z * z;
    return sqrt(square * (alpha * alpha + across / square));
}

/* Light times response over light-free response: both by the same sum, so that a constant map is exact. */
static double truth(const scene *s, double alpha, double v, int orientation)
{
    const lobe_prefilter_image *image = &s->source->image;
    const double(*frame)[3] = (const double(*)[3])s->frame[orientation];
    double sum = 0, mass = 0;
    for (size_t n = 0; n < s->count; n++) {
        const texel *t = &s->texels[n];
        double l[3], part = 0;
        to_frame(frame, t->moment, l);
        const double size = sqrt(t->angle);
        if (l[2] < -size * t->angle)
            continue;
        const double length = t->angle; /* of the moment, within a thousandth */
        for (int k = 0; k < 3; k++)
            l[k] /= length;
        const int parts = (int)fmin(ceil(size / (DETAIL * response_scale(alpha, v, l))), 16);
        if (parts <= 1) {
            part = t->angle * lobe_response(alpha, v, l);
        } else {
            const double row = (double)(n / (size_t)s->source->columns),
                         column = (double)(n % (size_t)s->source->columns);
            for (int i = 0; i < parts * parts; i++) {
                const double top = row + (double)(i / parts) / parts, left = column + (double)(i % parts) / parts;
                double moment[3];
                const double angle =
                    lobe_prefilter_image_moment(image, 0, top, left, top + 1.0 / parts, left + 1.0 / parts, moment);
                to_frame(frame, moment, l);
                for (int k = 0; k < 3; k++)
                    l[k] /= angle;
                part += angle * lobe_response(alpha, v, l);
            }
        }
        sum += part * t->light;
        mass += part;
    }
    return sum / mass;
}

/* values: square errors relative to the truth, square errors, of every model from every source; the square of the
 * truth; whether there was memory. */
enum { COLUMNS = 2 * MODELS * SOURCES + 2 };

static void ask(void *ctx, const double *params, size_t count, double *values)
{
    const scene *s = ctx;
    for (size_t i = 0; i < count; i++, values += COLUMNS) {
        const int point = (int)params[i] / ORIENTATIONS, orientation = (int)params[i] % ORIENTATIONS;
        const double alpha = alphas[point / VIEWS], v = views[point % VIEWS], want = truth(s, alpha, v, orientation);
        const double(*frame)[3] = (const double(*)[3])s->frame[orientation];
        values[COLUMNS - 2] = want * want;
        values[COLUMNS - 1] = 1;
        for (int m = 0; m < MODELS; m++) {
            lobe_env_tap taps[MOST_TAPS];
            double got[SOURCES] = {0, 0, 0};
            const int n = taps_of(m, alpha, v, taps);
            for (int t = 0; t < n; t++) {
                double d[3], rgb[3];
                for (int k = 0; k < 3; k++)
                    d[k] = cos(taps[t].angle) * frame[2][k] - sin(taps[t].angle) * frame[0][k];
                for (int from = 0; from < SOURCES; from++) {
                    if (s->cube[from])
                        lobe_cube_sample(s->cube[from], s->scale, d, taps[t].width, rgb);
                    else if (!lobe_prefilter_directions(s->source, LOBE_PREFILTER_GGX, taps[t].width, 0.2, d, 1, rgb))
                        values[COLUMNS - 1] = 0;
                    got[from] += taps[t].weight * (rgb[0] + rgb[1] + rgb[2]) / 3;
                }
            }
            for (int from = 0; from < SOURCES; from++) {
                const double off = got[from] - want;
                values[2 * (m * SOURCES + from)] = off / want * off / want;
                values[2 * (m * SOURCES + from) + 1] = off * off;
            }
        }
    }
}

/* A frame that is as likely as any other: the columns of a random rotation. */
static void turn(lobe_random *random, double f[3][3])
{
    double z = 2 * lobe_random_unit(random) - 1, phi = 2 * LOBE_PI * lobe_random_unit(random),
           spin = 2 * LOBE_PI * lobe_random_unit(random), r = sqrt(1 - z * z);
    const double n[3] = {r * cos(phi), r * sin(phi), z}, a[3] = {z * cos(phi), z * sin(phi), -r},
                 b[3] = {-sin(phi), cos(phi), 0};
    for (int k = 0; k < 3; k++) {
        f[0][k] = cos(spin) * a[k] + sin(spin) * b[k];
        f[1][k] = cos(spin) * b[k] - sin(spin) * a[k];
        f[2][k] = n[k];
    }
}

/* One model's errors over some points, as README.md names them. */
static void print_errors(const double *values, int model, int first, int count)
{
    for (int kind = 0; kind < 2; kind++)
        for (int from = 0; from < SOURCES; from++) {
            double mean = 0;
            for (int p = first; p < first + count; p++) {
                double sum = 0, square = 0;
                for (int o = 0; o < ORIENTATIONS; o++) {
                    const double *row = values + (size_t)(p * ORIENTATIONS + o) * COLUMNS;
                    sum += row[2 * (model * SOURCES + from) + kind];
                    square += kind ? row[COLUMNS - 2] : 1;
                }
                mean += sum / square / count;
            }
            printf("%s %.2f", from ? "" : kind ? " | rms" : " relative", 100 * sqrt(mean));
        }
    putchar('\n');
}

static void print(const char *name, const double *values)
{
    for (int m = 0; m < MODELS; m++) {
        printf("%s, %s:", name, model_name[m]);
        print_errors(values, m, 0, POINTS);
    }
    for (int i = 0; i < ALPHAS; i++) {
        printf("%s, %s, alpha %g:", name, model_name[MODELS - 1], alphas[i]);
        print_errors(values, MODELS - 1, i * VIEWS, VIEWS);
    }
    fflush(stdout);
}

static int measure(const char *name, const lobe_environment *map, int size)
{
    const lobe_prefilter_image image = {map, NULL, 0};
    const int texels = map->width * map->height, entries = POINTS * ORIENTATIONS;
    lobe_prefilter_options o = lobe_prefilter_options_default(LOBE_PREFILTER_GGX, size);
    lobe_prefilter_source source;
    lobe_cube cube[2];
    lobe_random random;
    scene s;
    char error[1024];
    texel *t = malloc((size_t)texels * sizeof *t);
    double *number = malloc((size_t)entries * sizeof *number),
           *values = malloc((size_t)entries * COLUMNS * sizeof *values);
    if (!t || !number || !values || !lobe_prefilter_source_build(&source, image, 1e-9))
        return bad("no memory");
    for (int i = 0; i < texels; i++) {
        const float *rgb = map->rgb + 3 * (size_t)i;
        const int row = i / map->width, column = i % map->width;
        t[i].angle = lobe_prefilter_image_moment(&image, 0, row, column, row + 1, column + 1, t[i].moment);
        t[i].light = ((double)rgb[0] + (double)rgb[1] + (double)rgb[2]) / 3;
    }
    for (int fit = 0; fit < 2; fit++) {
        o.fit = fit;
        if (lobe_prefilter(&image, &o, &cube[fit], error, sizeof error) != LOBE_PREFILTER_DONE)
            return bad("no memory");
        for (int m = 0; m < cube[fit].mips; m++)
            for (int i = 0; i < 18 * lobe_cube_side(size, m) * lobe_cube_side(size, m); i++)
                cube[fit].rgb[m][i] = lobe_half_to_float(lobe_half_from_float(cube[fit].rgb[m][i]));
    }
    s.source = &source;
    s.scale = &o.scale;
    s.cube[0] = NULL;
    s.cube[1] = &cube[0];
    s.cube[2] = &cube[1];
    s.texels = t;
    s.count = (size_t)texels;
    lobe_random_seed(&random, 1, 0);
    for (int i = 0; i < ORIENTATIONS; i++)
        turn(&random, s.frame[i]);
    for (int i = 0; i < entries; i++)
        number[i] = i;
    lobe_parallel parallel = {ask, &s, 1, COLUMNS, (size_t)o.threads};
    lobe_parallel_eval(&parallel, number, (size_t)entries, values);
    for (int i = 0; i < entries; i++)
        if (values[i * COLUMNS + COLUMNS - 1] == 0)
            return bad("no memory");
    print(name, values);
    lobe_cube_free(&cube[0]);
    lobe_cube_free(&cube[1]);
    lobe_prefilter_source_free(&source);
    free(values);
    free(number);
    free(t);
    return 0;
}

int main(int argc, char **argv)
{
    lobe_environment map;
    const int size = argc > 1 ? atoi(argv[1]) : 0;
    if (size < 4 || size > 4096)
        return bad("usage: prefilter_taps SIZE [FILE...]");
    printf("per cent; every error three times: taps filtered exactly, from the cube, from the cube with --fit\n");
    if (!lobe_room_make(&map, LOBE_ROOM_LAMPS, 1024, 101))
        return bad("no memory");
    int status = measure("lamps 101", &map, size);
    lobe_environment_free(&map);
    for (int i = 2; i < argc && !status; i++) {
        const char *slash = strrchr(argv[i], '/');
        if (!lobe_environment_load(argv[i], &map))
            return 2;
        status = measure(slash ? slash + 1 : argv[i], &map, size);
        lobe_environment_free(&map);
    }
    return status;
}
