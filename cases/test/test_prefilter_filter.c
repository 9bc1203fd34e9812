/* The prefilter's parts and the whole: kernels, scale, cube geometry, sampler, half floats, and the filter against
 * closed forms and brute force. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "../environment/sky.h"
#include "../prefilter/brute.h"
#include "../prefilter/cube_sample.h"
#include "../prefilter/prefilter.h"

enum { W = 64, H = 32 };

static unsigned noise_state = 1;

static double noise(void)
{
    noise_state = noise_state * 1664525u + 1013904223u;
    return (noise_state >> 8) / 16777216.0;
}

static void direction(double d[3])
{
    const double z = 2 * noise() - 1, phi = 2 * LOBE_PI * noise(), r = sqrt(1 - z * z);
    d[0] = r * cos(phi);
    d[1] = r * sin(phi);
    d[2] = z;
}

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static lobe_environment noisy(void)
{
    lobe_environment map;
    assert_true(lobe_environment_allocate(&map, W, H));
    for (int i = 0; i < 3 * W * H; i++)
        map.rgb[i] = (float)pow(noise(), 4);
    return map;
}

static lobe_cube filtered(const lobe_environment *map, const lobe_cube *from, const lobe_prefilter_options *o)
{
    const lobe_prefilter_image image = {map, from, 0};
    lobe_cube cube;
    char error[256];
    assert_int_equal(lobe_prefilter(&image, o, &cube, error, sizeof error), LOBE_PREFILTER_DONE);
    return cube;
}

static lobe_prefilter_options options(lobe_prefilter_kernel kernel, int size, int mips)
{
    lobe_prefilter_options o = lobe_prefilter_options_default(kernel, size);
    o.scale.mips = mips;
    o.progress = 0;
    return o;
}

static void constant_stays_constant(void **state)
{
    (void)state;
    lobe_environment map;
    assert_true(lobe_environment_allocate(&map, W, H));
    for (int i = 0; i < W * H; i++) {
        map.rgb[3 * i] = 1;
        map.rgb[3 * i + 1] = 300;
        map.rgb[3 * i + 2] = 0.001f;
    }
    for (int kernel = 0; kernel < 2; kernel++) {
        lobe_prefilter_options o = options((lobe_prefilter_kernel)kernel, 12, 4);
        lobe_cube cube = filtered(&map, NULL, &o), again = filtered(NULL, &cube, &o);
        for (int m = 0; m < 4; m++)
            for (int i = 0; i < 18 * lobe_cube_side(12, m) * lobe_cube_side(12, m); i++) {
                const double want = i % 3 == 0 ? 1 : i % 3 == 1 ? 300 : (double)0.001f;
                assert_true(fabs((double)cube.rgb[m][i] / want - 1) < 2e-6);
                assert_true(fabs((double)again.rgb[m][i] / want - 1) < 4e-6);
            }
        lobe_cube_free(&cube);
        lobe_cube_free(&again);
    }
    lobe_environment_free(&map);
}

/* The kernel is even in its two directions and integrates to 1, so the mean over the sphere stays: a cube of 64
 * integrates its own texels to a few 1e-4. */
static void energy_stays(void **state)
{
    (void)state;
    lobe_environment map;
    assert_true(lobe_environment_sky(&map, W, H, 3));
    double want[3] = {0, 0, 0};
    for (int i = 0; i < H; i++)
        for (int j = 0; j < W; j++)
            for (int k = 0; k < 3; k++)
                want[k] += lobe_environment_solid_angle(&map, i) * (double)map.rgb[3 * (i * W + j) + k];
    for (int kernel = 0; kernel < 2; kernel++) {
        lobe_prefilter_options o = options((lobe_prefilter_kernel)kernel, 64, 4);
        lobe_cube cube = filtered(&map, NULL, &o);
        for (int m = 0; m < 4; m++) {
            const int side = lobe_cube_side(64, m);
            double sum[3] = {0, 0, 0};
            for (int i = 0; i < 6 * side * side; i++) {
                const int row = i / side % side, column = i % side;
                for (int k = 0; k < 3; k++)
                    sum[k] +=
                        lobe_cube_solid_angle(side, row, column, row + 1, column + 1) * (double)cube.rgb[m][3 * i + k];
            }
            for (int k = 0; k < 3; k++) {
                if (fabs(sum[k] / want[k] - 1) > 2e-3)
                    printf("# kernel %d mip %d: %.6f\n", kernel, m, sum[k] / want[k]);
                assert_true(fabs(sum[k] / want[k] - 1) < 2e-3);
            }
        }
        lobe_cube_free(&cube);
    }
    lobe_environment_free(&map);
}

/* One lit texel is seen as the kernel itself, times the light that it holds. */
static void bright_texel_shows_the_kernel(void **state)
{
    (void)state;
    lobe_environment map;
    const int row = 35, column = 167;
    assert_true(lobe_environment_allocate(&map, 512, 256));
    map.rgb[3 * (row * 512 + column) + 1] = 1e6f;
    double l[3];
    lobe_environment_direction(&map, row, column, l);
    const double light = 1e6 * lobe_environment_solid_angle(&map, row);
    for (int kernel = 0; kernel < 2; kernel++) {
        lobe_prefilter_options o = options((lobe_prefilter_kernel)kernel, 16, 4);
        o.scale.curve = 1;
        lobe_cube cube = filtered(&map, NULL, &o);
        for (int m = 1; m < 4; m++) {
            const int side = lobe_cube_side(16, m);
            const double p = lobe_prefilter_parameter(o.scale.kernel, lobe_prefilter_width(&o.scale, m));
            for (int i = 0; i < 6 * side * side; i++) {
                double d[3];
                lobe_cube_direction(side, i / side / side, i / side % side + 0.5, i % side + 0.5, d);
                const double want = light * lobe_prefilter_density(o.scale.kernel, p, dot(d, l));
                const double got = (double)cube.rgb[m][3 * i + 1];
                /* Cells may hide the far tail of an sg and the last of the horizon. */
                if (fabs(got - want) > 0.01 * want + 1e-5 * light)
                    printf("# kernel %d mip %d texel %d: %g, want %g\n", kernel, m, i, got, want);
                assert_true(fabs(got - want) <= 0.01 * want + 1e-5 * light);
                assert_true(cube.rgb[m][3 * i] == 0 && cube.rgb[m][3 * i + 2] == 0);
            }
        }
        lobe_cube_free(&cube);
    }
    lobe_environment_free(&map);
}

/* The floor, on maps that hide nothing: white noise to the fourth power, and a sky with one texel of 5e4. */
static void brute_force(void **state)
{
    (void)state;
    lobe_environment maps[2] = {noisy(), {0, 0, NULL}};
    assert_true(lobe_environment_sky(&maps[1], 2 * W, 2 * H, 1));
    maps[1].rgb[3 * (20 * 2 * W + 30)] = 5e4f;
    for (int n = 0; n < 4; n++) {
        const lobe_environment *map = &maps[n / 2];
        const lobe_prefilter_image image = {map, NULL, 0};
        lobe_prefilter_options o = options((lobe_prefilter_kernel)(n % 2), 32, 5);
        lobe_cube cube = filtered(map, NULL, &o);
        for (int m = 1; m < 5; m++) {
            const int side = lobe_cube_side(32, m), count = 8;
            double square = 0;
            for (int i = 0; i < count; i++) {
                const lobe_cube_texel at = {i % 6, (int)(noise() * side), (int)(noise() * side)};
                const float *got = lobe_cube_at(&cube, m, at);
                double d[3], want[3], off = 0, size = 0;
                lobe_cube_direction(side, at.face, at.row + 0.5, at.column + 0.5, d);
                lobe_prefilter_brute(&image, o.scale.kernel, lobe_prefilter_width(&o.scale, m), 0.1, d, want);
                for (int k = 0; k < 3; k++) {
                    off += ((double)got[k] - want[k]) * ((double)got[k] - want[k]);
                    size += want[k] * want[k];
                }
                square += off / size / count;
            }
            if (sqrt(square) > 0.003)
                printf("# map %d kernel %d mip %d: %.4f %% rms\n", n / 2, n % 2, m, 100 * sqrt(square));
            assert_true(sqrt(square) <= 0.003); /* the floor is .01 */
        }
        lobe_cube_free(&cube);
    }
    lobe_environment_free(&maps[0]);
    lobe_environment_free(&maps[1]);
}

/* And the tree of a cube against brute force over the cube's texels. */
static void brute_force_of_a_cube(void **state)
{
    (void)state;
    lobe_cube from;
    assert_true(lobe_cube_allocate(&from, 20, 1));
    for (int i = 0; i < 18 * 400; i++)
        from.rgb[0][i] = (float)pow(noise(), 4);
    const lobe_prefilter_image image = {NULL, &from, 0};
    lobe_prefilter_options o = options(LOBE_PREFILTER_GGX, 20, 4);
    lobe_cube cube = filtered(NULL, &from, &o);
    for (int i = 0; i < 18 * 400; i++) /* a mirror of the same size */
        assert_true(fabsf(cube.rgb[0][i] - from.rgb[0][i]) <= 1e-6f * from.rgb[0][i] + 1e-9f);
    for (int m = 1; m < 4; m++)
        for (int i = 0; i < 12; i++) {
            const int side = lobe_cube_side(20, m);
            const lobe_cube_texel at = {i % 6, (int)(noise() * side), (int)(noise() * side)};
            double d[3], want[3];
            lobe_cube_direction(side, at.face, at.row + 0.5, at.column + 0.5, d);
            lobe_prefilter_brute(&image, LOBE_PREFILTER_GGX, lobe_prefilter_width(&o.scale, m), 0.1, d, want);
            for (int k = 0; k < 3; k++)
                assert_true(fabs((double)lobe_cube_at(&cube, m, at)[k] / want[k] - 1) < 0.01);
        }
    lobe_cube_free(&cube);
    lobe_cube_free(&from);
}

/* Brute force is converged itself. */
static void brute_force_has_converged(void **state)
{
    (void)state;
    lobe_environment map = noisy();
    const lobe_prefilter_image image = {&map, NULL, 0};
    for (int i = 0; i < 8; i++) {
        const lobe_prefilter_kernel kernel = (lobe_prefilter_kernel)(i % 2);
        double d[3], coarse[3], fine[3];
        direction(d);
        lobe_prefilter_brute(&image, kernel, kernel ? 60 : 0.36, 0.05, d, coarse);
        lobe_prefilter_brute(&image, kernel, kernel ? 60 : 0.36, 0.02, d, fine);
        for (int k = 0; k < 3; k++)
            assert_true(fabs(coarse[k] / fine[k] - 1) < 3e-4);
    }
    lobe_environment_free(&map);
}

/* rms error of lookups at a width, relative to the rms of the truth. */
static double lookup_error(const lobe_environment *map, const lobe_cube *cube, const lobe_prefilter_scale *scale,
                           double width)
{
    const lobe_prefilter_image image = {map, NULL, 0};
    lobe_prefilter_source source;
    double off = 0, size = 0;
    noise_state = 5;
    assert_true(lobe_prefilter_source_build(&source, image, 1e-9));
    for (int i = 0; i < 120; i++) {
        double d[3], want[3], got[3];
        direction(d);
        assert_true(lobe_prefilter_directions(&source, scale->kernel, width, 0.2, d, 1, want));
        lobe_cube_sample(cube, scale, d, width, got);
        for (int k = 0; k < 3; k++) {
            off += (got[k] - want[k]) * (got[k] - want[k]);
            size += want[k] * want[k];
        }
    }
    lobe_prefilter_source_free(&source);
    return sqrt(off / size);
}

/* Fitting the small mips to trilinear lookups makes them better, by a quarter at least, and keeps a constant. */
static void fit_helps_lookups(void **state)
{
    (void)state;
    lobe_environment map;
    assert_true(lobe_environment_sky(&map, W, H, 4));
    for (int kernel = 0; kernel < 2; kernel++) {
        lobe_prefilter_options o = options((lobe_prefilter_kernel)kernel, 8, 3);
        lobe_cube exact = filtered(&map, NULL, &o);
        o.fit = 1;
        lobe_cube fitted = filtered(&map, NULL, &o);
        double before = 0, after = 0;
        for (double lod = 0.75; lod <= 2; lod += 0.5) {
            const double width = lobe_prefilter_width(&o.scale, lod), a = lookup_error(&map, &exact, &o.scale, width),
                         b = lookup_error(&map, &fitted, &o.scale, width);
            before += a * a;
            after += b * b;
        }
        if (sqrt(after / before) > 0.75)
            printf("# kernel %d: %.5f to %.5f\n", kernel, sqrt(before / 3), sqrt(after / 3));
        assert_true(sqrt(after / before) <= 0.75);
        lobe_cube_free(&exact);
        lobe_cube_free(&fitted);
    }
    for (int i = 0; i < 3 * W * H; i++)
        map.rgb[i] = 5;
    lobe_prefilter_options o = options(LOBE_PREFILTER_GGX, 8, 2);
    o.fit = 1;
    lobe_cube cube = filtered(&map, NULL, &o);
    for (int i = 0; i < 18 * 16; i++)
        assert_true(fabs((double)cube.rgb[1][i] - 5) < 1e-5);
    lobe_cube_free(&cube);
    lobe_environment_free(&map);
}

/* Under a sky, lookups at widths between the mips are within 3 % rms. */
static void lookups_between_mips(void **state)
{
    (void)state;
    lobe_environment map;
    assert_true(lobe_environment_sky(&map, 2 * W, 2 * H, 4));
    lobe_prefilter_options o = options(LOBE_PREFILTER_GGX, 32, 4);
    lobe_cube cube = filtered(&map, NULL, &o);
    for (double r = 0.25; r < 1; r += 0.1) {
        const double error = lookup_error(&map, &cube, &o.scale, r);
        if (error > 0.03)
            printf("# roughness %.2f: %.4f\n", r, error);
        assert_true(error <= 0.03);
    }
    lobe_cube_free(&cube);
    lobe_environment_free(&map);
}

/* Between the mirror and mip 1 the cubed fraction is better than the plain one, by a third at least. */
static void lookups_above_the_first_mip(void **state)
{
    (void)state;
    lobe_environment map;
    assert_true(lobe_environment_sky(&map, 2 * W, 2 * H, 4));
    const lobe_prefilter_image image = {&map, NULL, 0};
    lobe_prefilter_options o = options(LOBE_PREFILTER_GGX, 32, 4);
    lobe_cube cube = filtered(&map, NULL, &o);
    lobe_prefilter_source source;
    assert_true(lobe_prefilter_source_build(&source, image, 1e-9));
    for (double part = 0.4; part < 0.9; part += 0.2) {
        const double width = part * lobe_prefilter_width(&o.scale, 1), lod = lobe_prefilter_lod(&o.scale, width);
        double bent = 0, plain = 0;
        for (int i = 0; i < 120; i++) {
            double d[3], want[3], got[2][3];
            direction(d);
            assert_true(lobe_prefilter_directions(&source, o.scale.kernel, width, 0.1, d, 1, want));
            lobe_cube_sample(&cube, &o.scale, d, width, got[0]);
            lobe_cube_sample_lod(&cube, d, cbrt(lod), got[1]);
            for (int k = 0; k < 3; k++) {
                bent += (got[0][k] - want[k]) * (got[0][k] - want[k]);
                plain += (got[1][k] - want[k]) * (got[1][k] - want[k]);
            }
        }
        if (sqrt(bent / plain) > 2 / 3.0)
            printf("# %.1f of mip 1's width: %.3f of the plain error\n", part, sqrt(bent / plain));
        assert_true(sqrt(bent / plain) <= 2 / 3.0);
    }
    lobe_prefilter_source_free(&source);
    lobe_cube_free(&cube);
    lobe_environment_free(&map);
}

static void threads_do_not_matter(void **state)
{
    (void)state;
    lobe_environment map = noisy();
    for (int kernel = 0; kernel < 2; kernel++) {
        lobe_prefilter_options o = options((lobe_prefilter_kernel)kernel, 18, 4);
        o.threads = 1;
        lobe_cube one = filtered(&map, NULL, &o);
        o.threads = 7;
        lobe_cube seven = filtered(&map, NULL, &o);
        for (int m = 0; m < 4; m++) {
            const size_t side = (size_t)lobe_cube_side(18, m);
            assert_memory_equal(one.rgb[m], seven.rgb[m], 18 * side * side * sizeof(float));
        }
        lobe_cube_free(&one);
        lobe_cube_free(&seven);
    }
    lobe_environment_free(&map);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(constant_stays_constant),
        cmocka_unit_test(energy_stays),
        cmocka_unit_test(bright_texel_shows_the_kernel),
        cmocka_unit_test(brute_force),
        cmocka_unit_test(brute_force_of_a_cube),
        cmocka_unit_test(brute_force_has_converged),
        cmocka_unit_test(fit_helps_lookups),
        cmocka_unit_test(lookups_between_mips),
        cmocka_unit_test(lookups_above_the_first_mip),
        cmocka_unit_test(threads_do_not_matter),
    };
    return cmocka_run_group_tests_name("prefilter_filter", tests, NULL, NULL);
}
