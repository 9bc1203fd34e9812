/* What the tables of README.md hold: the filter against brute force, a mip, and lookups against the kernel itself.
 *
 * prefilter_error filter SIZE [FILE...]     rms and worst relative error a mip over sampled texels
 * prefilter_error bilinear SIZE [FILE...]   rms error of lookups within a mip
 * prefilter_error trilinear SIZE [FILE...]  rms error a curve and a width; the standard curve also with the fraction
 * above mip 1 as it is (plain), and with --fit Without files: a procedural sky and one bright texel under a dim sky. */
#include "brute.h"
#include "cube_sample.h"
#include "prefilter.h"
#include "../environment/sky.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TEXELS = 48, DIRECTIONS = 600, WIDTHS = 39, ROWS = 256 };

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

/* Widths at equal steps of r = roughness, or sharpness^(-1/4), from .05 on. */
static double width_at(int kernel, int i)
{
    const double r = 0.05 + 0.025 * i;
    return kernel == LOBE_PREFILTER_GGX ? r : 1 / (r * r * r * r);
}

/* A line: some widths, and all together. plain: without the cube of the fraction above mip 1. */
static void curve_errors(const lobe_cube *cube, const lobe_prefilter_scale *scale, int plain, const double *d,
                         const double *want)
{
    double all = 0;
    for (int i = 0; i < WIDTHS; i++) {
        double sum = 0, square = 0, lod = lobe_prefilter_lod(scale, width_at((int)scale->kernel, i));
        lod = plain && lod < 1 ? cbrt(lod) : lod;
        for (int j = 0; j < DIRECTIONS; j++) {
            const double *truth = want + 3 * (i * DIRECTIONS + j);
            double got[3];
            lobe_cube_sample_lod(cube, d + 3 * j, lod, got);
            for (int k = 0; k < 3; k++) {
                sum += (got[k] - truth[k]) * (got[k] - truth[k]);
                square += truth[k] * truth[k];
            }
        }
        if (i <= 4 || (i <= 14 && i % 2 == 0) || (i - 2) % 8 == 4)
            printf(" %.3g: %.1f", 0.05 + 0.025 * i, 100 * sqrt(sum / square));
        all += sum / square / WIDTHS;
    }
    printf("  all %.2f %%\n", 100 * sqrt(all));
    fflush(stdout);
}

static int trilinear_error(const char *name, const lobe_environment *map, int size, int kernel)
{
    static const double curves[] = {1, 1.4, 1.5, 1.6, 1.7, 1.8, 1.9, 2};
    const lobe_prefilter_image image = {map, NULL, 0};
    double *d = malloc(3 * DIRECTIONS * sizeof *d), *want = malloc(3 * WIDTHS * DIRECTIONS * sizeof *want);
    lobe_prefilter_source source;
    unsigned state = 7;
    if (!d || !want || !lobe_prefilter_source_build(&source, image, 1e-9))
        return bad("no memory");
    for (int i = 0; i < DIRECTIONS; i++)
        direction(&state, d + 3 * i);
    for (int i = 0; i < WIDTHS; i++)
        if (!lobe_prefilter_directions(&source, (lobe_prefilter_kernel)kernel, width_at(kernel, i), 0.2, d, DIRECTIONS,
                                       want + 3 * i * DIRECTIONS))
            return bad("no memory");
    for (int step = 0; step < 9; step++) {
        lobe_prefilter_options o = lobe_prefilter_options_default((lobe_prefilter_kernel)kernel, size);
        const double standard = o.scale.curve;
        lobe_cube cube;
        char error[1024];
        o.scale.curve = step < 8 ? curves[step] : standard;
        o.fit = step == 8;
        o.detail = 0.35; /* a tenth of a per cent */
        if (lobe_prefilter(&image, &o, &cube, error, sizeof error) != LOBE_PREFILTER_DONE)
            return bad("no memory");
        for (int plain = o.scale.curve == standard && !o.fit; plain >= 0; plain--) {
            printf("%s %s a %.1f%s:", name, kernel_name[kernel], o.scale.curve, plain ? " plain" : o.fit ? " fit" : "");
            curve_errors(&cube, &o.scale, plain, d, want);
        }
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
    lobe_prefilter_options o = lobe_prefilter_options_default((lobe_prefilter_kernel)kernel, size);
    lobe_cube cube;
    char error[1024];
    if (lobe_prefilter(&image, &o, &cube, error, sizeof error) != LOBE_PREFILTER_DONE)
        return bad("no memory");
    printf("%s %s, a mip:", name, kernel_name[kernel]);
    for (int m = 1; m < cube.mips; m++) {
        double sum = 0, square = 0;
        if (!lobe_prefilter_directions(&source, (lobe_prefilter_kernel)kernel, lobe_prefilter_width(&o.scale, m), 0.15,
                                       d, DIRECTIONS, want))
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
    lobe_prefilter_source_free(&source);
    free(d);
    free(want);
    return 0;
}

/* Between two mips: what the fraction costs, what the best one would, and what a mip of the cube's largest side would
 * whose width is just this. */
static int fraction_error(const char *name, const lobe_environment *map, int size, int kernel)
{
    static const double widths[] = {0.03, 0.04, 0.05, 0.06, 0.07, 0.08, 0.09, 0.12, 0.15, 0.18, 0.26};
    const lobe_prefilter_image image = {map, NULL, 0};
    lobe_prefilter_options o = lobe_prefilter_options_default((lobe_prefilter_kernel)kernel, size);
    lobe_prefilter_source source;
    lobe_cube cube;
    char error[1024];
    if (lobe_prefilter(&image, &o, &cube, error, sizeof error) != LOBE_PREFILTER_DONE ||
        !lobe_prefilter_source_build(&source, image, 1e-9))
        return bad("no memory");
    for (size_t i = 0; i < sizeof widths / sizeof widths[0]; i++) {
        const double r = widths[i], width = kernel == LOBE_PREFILTER_GGX ? r : 1 / (r * r * r * r);
        const double lod = lobe_prefilter_lod(&o.scale, width), f = lod - floor(lod);
        unsigned state = 7;
        /* of the truth; of its distance d from the finer mip; of s, the step to the coarser; s d; of the own mip's
         * error */
        double truth = 0, far = 0, step = 0, along = 0, own = 0;
        for (int j = 0; j < DIRECTIONS; j++) {
            double d[3], want[3], fine[3], coarse[3], sum[3] = {0, 0, 0};
            lobe_cube_footprint at;
            direction(&state, d);
            if (!lobe_prefilter_directions(&source, o.scale.kernel, width, 0.2, d, 1, want))
                return bad("no memory");
            lobe_cube_sample_mip(&cube, (int)lod, d, fine);
            lobe_cube_sample_mip(&cube, (int)lod + 1, d, coarse);
            lobe_cube_footprint_of(size, d, &at);
            for (int q = 0; q < at.count; q++) {
                double e[3], texel[3];
                lobe_cube_direction(size, at.texel[q].face, at.texel[q].row + 0.5, at.texel[q].column + 0.5, e);
                if (!lobe_prefilter_directions(&source, o.scale.kernel, width, 0.2, e, 1, texel))
                    return bad("no memory");
                for (int k = 0; k < 3; k++)
                    sum[k] += at.weight[q] * texel[k];
            }
            for (int k = 0; k < 3; k++) {
                const double off = want[k] - fine[k], s = coarse[k] - fine[k];
                truth += want[k] * want[k];
                far += off * off;
                step += s * s;
                along += off * s;
                own += (sum[k] - want[k]) * (sum[k] - want[k]);
            }
        }
        const double best = fmin(fmax(along / step, 0), 1), plain = lod < 1 ? cbrt(lod) : f;
        printf("%s %s r %.2f: plain %.3f %.1f %%, here %.3f %.1f %%, best %.3f %.1f %%, own mip %.1f %%\n", name,
               kernel_name[kernel], r, plain, 100 * sqrt((far - 2 * plain * along + plain * plain * step) / truth), f,
               100 * sqrt((far - 2 * f * along + f * f * step) / truth), best,
               100 * sqrt((far - 2 * best * along + best * best * step) / truth), 100 * sqrt(own / truth));
        fflush(stdout);
    }
    lobe_prefilter_source_free(&source);
    lobe_cube_free(&cube);
    return 0;
}

static int measure(const char *what, const char *name, const lobe_environment *map, int size)
{
    if (strcmp(what, "filter") == 0)
        return filter_error(name, map, size);
    int (*error)(const char *, const lobe_environment *, int, int) = strcmp(what, "bilinear") == 0   ? bilinear_error
                                                                     : strcmp(what, "fraction") == 0 ? fraction_error
                                                                                                     : trilinear_error;
    const int status = error(name, map, size, 0);
    return status ? status : error(name, map, size, 1);
}

int main(int argc, char **argv)
{
    lobe_environment map;
    const int size = argc > 2 ? atoi(argv[2]) : 0;
    int status = 0;
    if (size < 4 || size > 4096 ||
        (strcmp(argv[1], "filter") != 0 && strcmp(argv[1], "bilinear") != 0 && strcmp(argv[1], "trilinear") != 0 &&
         strcmp(argv[1], "fraction") != 0))
        return bad("usage: prefilter_error filter|bilinear|trilinear|fraction SIZE [FILE...]");
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
