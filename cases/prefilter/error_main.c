/* What the tables of README.md hold: the filter against brute force, a mip, and trilinear lookups against the kernel
 * itself, over all widths, for several curves.
 *
 * prefilter_error filter SIZE [FILE...]     rms and worst relative error a mip over sampled texels
 * prefilter_error bilinear SIZE [FILE...]   rms error of lookups within a mip, texels exact and fitted (--fit)
 * prefilter_error trilinear SIZE [FILE...]  rms error a curve and a width
 * Without files: a procedural sky and one bright texel under a dim sky. */
#include "brute.h"
#include "cube_sample.h"
#include "prefilter.h"
#include "../environment/sky.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TEXELS = 48, DIRECTIONS = 800, WIDTHS = 16, ROWS = 256 };

static const char *const kernel_name[] = {"ggx", "sg"};

/* Uniform numbers in [0, 1): the same for every run. */
static double next(unsigned *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (*state >> 8) / 16777216.0;
}

static double length(const double v[3]) { return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

static int bad(const char *why)
{
    fprintf(stderr, "prefilter_error: %s\n", why);
    return 2;
}

static int filter_error(const char *name, const lobe_environment *map, int size)
{
    const lobe_prefilter_image image = {map, NULL, 0};
    for (int kernel = 0; kernel < 2; kernel++) {
        lobe_prefilter_options o = lobe_prefilter_options_default((lobe_prefilter_kernel)kernel, size);
        lobe_cube cube;
        char error[1024];
        if (lobe_prefilter(&image, &o, &cube, error, sizeof error) != LOBE_PREFILTER_DONE)
            return bad("no memory");
        for (int m = 1; m < cube.mips; m++) {
            const int side = lobe_cube_side(size, m);
            unsigned state = 1;
            double sum = 0, worst = 0, relative = 0, mean = 0;
            for (int i = 0; i < TEXELS; i++) {
                const lobe_cube_texel at = {i % 6, (int)(next(&state) * side), (int)(next(&state) * side)};
                const float *got = lobe_cube_at(&cube, m, at);
                double d[3], want[3], off[3];
                lobe_cube_direction(side, at.face, at.row + 0.5, at.column + 0.5, d);
                lobe_prefilter_brute(&image, (lobe_prefilter_kernel)kernel, lobe_prefilter_width(&o.scale, m), 0.05, d,
                                     want);
                for (int k = 0; k < 3; k++)
                    off[k] = (double)got[k] - want[k];
                sum += length(off) * length(off);
                mean += length(want);
                relative += length(off) / length(want) * length(off) / length(want);
                worst = fmax(worst, length(off) / length(want));
            }
            printf("%s %s mip %d width %.4g: rms %.4f %% of the mean, relative rms %.4f %%, worst %.4f %%\n", name,
                   kernel_name[kernel], m, lobe_prefilter_width(&o.scale, m),
                   100 * sqrt(sum / TEXELS) / (mean / TEXELS), 100 * sqrt(relative / TEXELS), 100 * worst);
            fflush(stdout);
        }
        lobe_cube_free(&cube);
    }
    return 0;
}

static void direction(unsigned *state, double d[3])
{
    const double z = 2 * next(state) - 1, phi = 2 * LOBE_PI * next(state), r = sqrt(1 - z * z);
    d[0] = r * cos(phi);
    d[1] = r * sin(phi);
    d[2] = z;
}

/* Widths at equal steps of r = roughness, or sharpness^(-1/4). */
static double width_at(int kernel, int i)
{
    const double r = (i + 1.0) / WIDTHS;
    return kernel == LOBE_PREFILTER_GGX ? r : 1 / (r * r * r * r);
}

static int trilinear_error(const char *name, const lobe_environment *map, int size, int kernel)
{
    const lobe_prefilter_image image = {map, NULL, 0};
    double *d = malloc(3 * DIRECTIONS * sizeof *d), *want = malloc(3 * WIDTHS * DIRECTIONS * sizeof *want);
    lobe_prefilter_source source;
    unsigned state = 7;
    if (!d || !want || !lobe_prefilter_source_build(&source, image, 1e-9))
        return bad("no memory");
    for (int i = 0; i < DIRECTIONS; i++)
        direction(&state, d + 3 * i);
    for (int i = 0; i < WIDTHS; i++)
        if (!lobe_prefilter_directions(&source, (lobe_prefilter_kernel)kernel, width_at(kernel, i), 0.15, d, DIRECTIONS,
                                       want + 3 * i * DIRECTIONS))
            return bad("no memory");
    static const double curves[] = {1, 1.4, 1.6, 1.7, 1.8, 1.9, 2};
    for (int step = 0; step < 7; step++) {
        lobe_prefilter_options o = lobe_prefilter_options_default((lobe_prefilter_kernel)kernel, size);
        lobe_cube cube;
        char error[1024];
        double all = 0;
        o.scale.curve = curves[step];
        o.detail = 0.35; /* a tenth of a per cent */
        if (lobe_prefilter(&image, &o, &cube, error, sizeof error) != LOBE_PREFILTER_DONE)
            return bad("no memory");
        printf("%s %s a %.1f:", name, kernel_name[kernel], o.scale.curve);
        for (int i = 0; i < WIDTHS; i++) {
            double sum = 0, square = 0;
            for (int j = 0; j < DIRECTIONS; j++) {
                const double *truth = want + 3 * (i * DIRECTIONS + j);
                double got[3];
                lobe_cube_sample(&cube, &o.scale, d + 3 * j, width_at(kernel, i), got);
                for (int k = 0; k < 3; k++) {
                    sum += (got[k] - truth[k]) * (got[k] - truth[k]);
                    square += truth[k] * truth[k];
                }
            }
            printf(" %.2f", 100 * sqrt(sum / square));
            all += sum / square / WIDTHS;
        }
        printf("  all %.3f %%\n", 100 * sqrt(all));
        fflush(stdout);
        lobe_cube_free(&cube);
    }
    lobe_prefilter_source_free(&source);
    free(d);
    free(want);
    return 0;
}

static int bilinear_error(const char *name, const lobe_environment *map, int size, int kernel)
{
    const lobe_prefilter_image image = {map, NULL, 0};
    double *d = malloc(3 * DIRECTIONS * sizeof *d), *want = malloc(3 * DIRECTIONS * sizeof *want);
    lobe_prefilter_source source;
    unsigned state = 7;
    if (!d || !want || !lobe_prefilter_source_build(&source, image, 1e-9))
        return bad("no memory");
    for (int i = 0; i < DIRECTIONS; i++)
        direction(&state, d + 3 * i);
    for (int fit = 0; fit < 2; fit++) {
        lobe_prefilter_options o = lobe_prefilter_options_default((lobe_prefilter_kernel)kernel, size);
        lobe_cube cube;
        char error[1024];
        o.fit = fit;
        if (lobe_prefilter(&image, &o, &cube, error, sizeof error) != LOBE_PREFILTER_DONE)
            return bad("no memory");
        printf("%s %s %s, a mip:", name, kernel_name[kernel], fit ? "fitted" : "exact");
        for (int m = 1; m < cube.mips; m++) {
            double sum = 0, square = 0;
            if (!lobe_prefilter_directions(&source, (lobe_prefilter_kernel)kernel, lobe_prefilter_width(&o.scale, m),
                                           0.15, d, DIRECTIONS, want))
                return bad("no memory");
            for (int j = 0; j < DIRECTIONS; j++) {
                double got[3];
                lobe_cube_sample_mip(&cube, m, d + 3 * j, got);
                for (int k = 0; k < 3; k++) {
                    sum += (got[k] - want[3 * j + k]) * (got[k] - want[3 * j + k]);
                    square += want[3 * j + k] * want[3 * j + k];
                }
            }
            printf(" %.2f", 100 * sqrt(sum / square));
        }
        putchar('\n');
        fflush(stdout);
        lobe_cube_free(&cube);
    }
    lobe_prefilter_source_free(&source);
    free(d);
    free(want);
    return 0;
}

static int measure(const char *what, const char *name, const lobe_environment *map, int size)
{
    if (strcmp(what, "filter") == 0)
        return filter_error(name, map, size);
    int (*error)(const char *, const lobe_environment *, int, int) =
        strcmp(what, "bilinear") == 0 ? bilinear_error : trilinear_error;
    const int status = error(name, map, size, 0);
    return status ? status : error(name, map, size, 1);
}

int main(int argc, char **argv)
{
    lobe_environment map;
    const int size = argc > 2 ? atoi(argv[2]) : 0;
    int status = 0;
    if (size < 1 || size > 4096 ||
        (strcmp(argv[1], "filter") != 0 && strcmp(argv[1], "bilinear") != 0 && strcmp(argv[1], "trilinear") != 0))
        return bad("usage: prefilter_error filter|bilinear|trilinear SIZE [FILE...]");
    if (argc == 3) {
        if (!lobe_environment_sky(&map, 2 * ROWS, ROWS, 1))
            return bad("no memory");
        status = measure(argv[1], "sky", &map, size);
        for (int k = 0; k < 3; k++)
            map.rgb[3 * (100 * 2 * ROWS + 200) + k] = 5e4f;
        status = status ? status : measure(argv[1], "texel", &map, size);
        lobe_environment_free(&map);
    }
    for (int i = 3; i < argc && !status; i++) {
        const char *slash = strrchr(argv[i], '/');
        if (!lobe_environment_load(argv[i], &map))
            return 2;
        status = measure(argv[1], slash ? slash + 1 : argv[i], &map, size);
        lobe_environment_free(&map);
    }
    return status;
}
