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
#include "../prefilter/cube_sample.h"
#include "../prefilter/half.h"
#include "../prefilter/source.h"

enum { W = 64, H = 32 };

static unsigned noise_state = 1;

static double noise(void)
{
    noise_state = noise_state * 1664525u + 1013904223u;
    return (noise_state >> 8) / 16777216.0;
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

/* Integral of the density over the sphere, by Simpson's rule in the chord's square, and in a variable that resolves the
 * peak: s = 1 - c = t^4 * 2. */
static void kernels_integrate_to_one(void **state)
{
    (void)state;
    const double widths[2][5] = {{0.1, 0.3, 0.6, 0.99, 1}, {0.01, 1, 17, 500, 10000}};
    for (int kernel = 0; kernel < 2; kernel++)
        for (int w = 0; w < 5; w++) {
            const double p = lobe_prefilter_parameter((lobe_prefilter_kernel)kernel, widths[kernel][w]);
            const double end = kernel == 0 ? sqrt(sqrt(0.5)) : 1; /* ggx ends at the horizon, s = 1 */
            double sum = 0;
            const int n = 4000;
            for (int i = 0; i <= n; i++) {
                const double t = end * i / n, s = 2 * t * t * t * t;
                const double f = lobe_prefilter_density((lobe_prefilter_kernel)kernel, p, 1 - s) * 8 * t * t * t;
                sum += f * (i == 0 || i == n ? 1 : i % 2 ? 4 : 2);
            }
            sum *= 2 * LOBE_PI * end / n / 3;
            if (fabs(sum - 1) > 1e-6)
                printf("# kernel %d width %g: %.9f\n", kernel, widths[kernel][w], sum);
            assert_true(fabs(sum - 1) < 1e-6);
        }
}

static void scale_both_ways(void **state)
{
    (void)state;
    for (int kernel = 0; kernel < 2; kernel++)
        for (double a = 1; a <= 2; a += 0.25) {
            const lobe_prefilter_scale scale = {(lobe_prefilter_kernel)kernel, 7, a};
            for (double lod = 0.01; lod <= 6; lod += 0.01)
                assert_true(fabs(lobe_prefilter_lod(&scale, lobe_prefilter_width(&scale, lod)) - lod) < 1e-6);
            for (double r = 0.01; r <= 1; r += 0.01) {
                const double width = kernel ? 1 / (r * r * r * r) : r;
                assert_true(fabs(lobe_prefilter_width(&scale, lobe_prefilter_lod(&scale, width)) / width - 1) < 1e-6);
            }
            assert_true(lobe_prefilter_lod(&scale, kernel ? INFINITY : 0) == 0);
            assert_true(lobe_prefilter_width(&scale, 0) == (kernel ? INFINITY : 0));
            assert_true(fabs(lobe_prefilter_width(&scale, 6) - 1) < 1e-12);
            assert_true(lobe_prefilter_lod(&scale, kernel ? 0.5 : 2) == 6);
            assert_true(lobe_prefilter_lod(&scale, NAN) == 6);
            assert_true(fabs(lobe_prefilter_width(&scale, 99) - 1) < 1e-12);
        }
    const lobe_prefilter_scale linear = {LOBE_PREFILTER_GGX, 7, 1}, one = {LOBE_PREFILTER_GGX, 1, 1.5};
    assert_true(fabs(lobe_prefilter_width(&linear, 3) - 0.5) < 1e-15);
    assert_true(fabs(lobe_prefilter_lod(&linear, 1 / 12.0) - 0.125) < 1e-15); /* half of mip 1's width: an eighth */
    assert_true(fabs(lobe_prefilter_lod(&linear, 0.1666) - 1) < 2e-3);
    assert_true(lobe_prefilter_lod(&one, 1) == 0 && lobe_prefilter_width(&one, 0) == 0);
}

static void cube_geometry(void **state)
{
    (void)state;
    double total = 0;
    for (int face = 0; face < 6; face++)
        for (int i = 0; i < 7; i++)
            for (int j = 0; j < 7; j++) {
                double d[3], row, column;
                lobe_cube_direction(7, face, i + 0.3, j + 0.6, d);
                assert_true(fabs(dot(d, d) - 1) < 1e-14);
                assert_int_equal(lobe_cube_position(7, d, &row, &column), face);
                assert_true(fabs(row - i - 0.3) < 1e-12 && fabs(column - j - 0.6) < 1e-12);
                total += lobe_cube_solid_angle(7, i, j, i + 1, j + 1);
            }
    assert_true(fabs(total - 4 * LOBE_PI) < 1e-12);
    /* Direct3D's table of faces: what lies in the middle of the right edge and of the lower edge. */
    static const double right[6][3] = {{1, 0, -1}, {-1, 0, 1}, {1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {-1, 0, -1}};
    static const double lower[6][3] = {{1, -1, 0}, {-1, -1, 0}, {0, 1, 1}, {0, -1, -1}, {0, -1, 1}, {0, -1, -1}};
    for (int face = 0; face < 6; face++) {
        double d[3];
        lobe_cube_direction(1, face, 0.5, 1, d);
        assert_true(fabs(dot(d, right[face]) - sqrt(2)) < 1e-12);
        lobe_cube_direction(1, face, 1, 0.5, d);
        assert_true(fabs(dot(d, lower[face]) - sqrt(2)) < 1e-12);
    }
}

/* The texel beyond an edge is the mirror image of the one before it. */
static void folds_to_the_neighbour(void **state)
{
    (void)state;
    for (int side = 1; side <= 8; side++)
        for (int face = 0; face < 6; face++)
            for (int edge = 0; edge < 4; edge++)
                for (int i = 0; i < side; i++) {
                    const int far = edge % 2 ? side : -1;
                    const lobe_cube_texel out = {face, edge < 2 ? far : i, edge < 2 ? i : far};
                    const lobe_cube_texel in = lobe_cube_fold(side, out);
                    const lobe_cube_texel rim = {face, edge < 2 ? (edge % 2 ? side - 1 : 0) : i,
                                                 edge < 2 ? i : (edge % 2 ? side - 1 : 0)};
                    double a[3], b[3];
                    assert_true(in.face != face && in.face != (face ^ 1));
                    assert_in_range(in.row, 0, side - 1);
                    assert_in_range(in.column, 0, side - 1);
                    /* Mirrored in the plane through the edge and the cube's middle. */
                    double here[3], there[3], across = 0;
                    lobe_cube_direction(side, rim.face, rim.row + 0.5, rim.column + 0.5, a);
                    lobe_cube_direction(side, in.face, in.row + 0.5, in.column + 0.5, b);
                    lobe_cube_direction(1, face, 0.5, 0.5, here);
                    lobe_cube_direction(1, in.face, 0.5, 0.5, there);
                    for (int k = 0; k < 3; k++)
                        across += a[k] * (here[k] - there[k]);
                    for (int k = 0; k < 3; k++)
                        assert_true(fabs(b[k] - a[k] + across * (here[k] - there[k])) < 1e-12);
                }
}

/* Values that are linear in the direction's cube coordinates near an edge are continuous over it. */
static void sampler_is_seamless(void **state)
{
    (void)state;
    lobe_cube cube;
    assert_true(lobe_cube_allocate(&cube, 8, 4));
    for (int m = 0; m < 4; m++)
        for (int i = 0; i < 18 * lobe_cube_side(8, m) * lobe_cube_side(8, m); i++)
            cube.rgb[m][i] = (float)noise();
    for (int n = 0; n < 20000; n++) {
        /* Two directions on both sides of an edge or, now and then, around a corner. */
        double d[3], a[3], b[3], left[3], right[3];
        const int k = n % 3, corner = n % 7 == 0;
        d[k] = noise() < 0.5 ? -1 : 1;
        d[(k + 1) % 3] = noise() < 0.5 ? -1 : 1;
        d[(k + 2) % 3] = corner ? (noise() < 0.5 ? -1 : 1) : 2 * noise() - 1;
        for (int i = 0; i < 3; i++) {
            a[i] = d[i] + (i == k ? 1e-9 : 0) * d[i];
            b[i] = d[i] - (i == k ? 1e-9 : 0) * d[i];
        }
        const double lod = corner ? floor(3 * noise()) : 3 * noise();
        lobe_cube_sample_lod(&cube, a, lod, left);
        lobe_cube_sample_lod(&cube, b, lod, right);
        for (int c = 0; c < 3; c++)
            assert_true(fabs(left[c] - right[c]) < 1e-6);
    }
    lobe_cube_free(&cube);
}

/* At a texel's centre bilinear filtering gives the texel, between two it gives their mean; lods mix. */
static void sampler_values(void **state)
{
    (void)state;
    lobe_cube cube;
    assert_true(lobe_cube_allocate(&cube, 4, 2));
    for (int i = 0; i < 18 * 16; i++)
        cube.rgb[0][i] = (float)i;
    for (int i = 0; i < 18 * 4; i++)
        cube.rgb[1][i] = 1000;
    for (int face = 0; face < 6; face++)
        for (int i = 0; i < 16; i++) {
            const lobe_cube_texel at = {face, i / 4, i % 4};
            const double here = (double)lobe_cube_at(&cube, 0, at)[1];
            double d[3], rgb[3];
            lobe_cube_direction(4, face, i / 4 + 0.5, i % 4 + 0.5, d);
            lobe_cube_sample_lod(&cube, d, 0, rgb);
            assert_true(fabs(rgb[1] - here) < 1e-9);
            lobe_cube_sample_lod(&cube, d, 0.25, rgb);
            assert_true(fabs(rgb[1] - (0.75 * here + 250)) < 1e-9);
            lobe_cube_sample_lod(&cube, d, 5, rgb);
            assert_true(fabs(rgb[1] - 1000) < 1e-9);
            if (i % 4 < 3) {
                lobe_cube_direction(4, face, i / 4 + 0.5, i % 4 + 1, d);
                lobe_cube_sample_lod(&cube, d, -1, rgb);
                assert_true(fabs(rgb[1] - here - 1.5) < 1e-9);
            }
        }
    lobe_cube_free(&cube);
}

/* All 65536 halves, there and back; then every float halfway between two neighbours and beside it. */
static void halves(void **state)
{
    (void)state;
    for (uint32_t h = 0; h < 65536; h++) {
        const int exponent = h >> 10 & 31, mantissa = h & 1023;
        const double size = exponent ? (1 + mantissa / 1024.0) * pow(2, exponent - 15) : mantissa * pow(2, -24);
        const float x = lobe_half_to_float((uint16_t)h);
        if (exponent == 31) {
            assert_true(mantissa ? isnan(x) : isinf(x));
            assert_int_equal(lobe_half_from_float(x), mantissa ? 0 : (h & 0x8000) | 0x7bff);
            continue;
        }
        assert_true((double)x == (h & 0x8000 ? -size : size) && !signbit(x) == !(h & 0x8000));
        assert_int_equal(lobe_half_from_float(x), h);
        if ((h & 0x7fff) >= 0x7bff)
            continue;
        const float next = lobe_half_to_float((uint16_t)(h + 1)), middle = x + (next - x) / 2;
        assert_int_equal(lobe_half_from_float(middle), h & 1 ? h + 1 : h); /* ties to even */
        assert_int_equal(lobe_half_from_float(nextafterf(middle, x)), h);
        assert_int_equal(lobe_half_from_float(nextafterf(middle, next)), h + 1);
    }
    assert_int_equal(lobe_half_from_float(65519.0f), 0x7bff);
    assert_int_equal(lobe_half_from_float(65520.0f), 0x7bff); /* infinity by the rule, the largest number here */
    assert_int_equal(lobe_half_from_float(-1e30f), 0xfbff);
    assert_int_equal(lobe_half_from_float(1e-30f), 0);
}

/* Equirectangular conventions: z up as `project` has it; with y up a turned world sees the same. */
static void worlds(void **state)
{
    (void)state;
    lobe_environment map = noisy();
    const lobe_prefilter_image z_up = {&map, NULL, 0}, y_up = {&map, NULL, 1};
    for (int i = 0; i < H; i++)
        for (int j = 0; j < W; j++) {
            double d[3], rgb[3], turned[3];
            lobe_environment_direction(&map, i, j, d);
            lobe_prefilter_image_sample(&z_up, d, rgb);
            for (int k = 0; k < 3; k++)
                assert_true(fabs(rgb[k] - (double)map.rgb[3 * (i * W + j) + k]) < 1e-9);
            turned[0] = -d[1];
            turned[1] = d[2];
            turned[2] = -d[0];
            lobe_prefilter_image_sample(&y_up, turned, rgb);
            for (int k = 0; k < 3; k++)
                assert_true(fabs(rgb[k] - (double)map.rgb[3 * (i * W + j) + k]) < 1e-9);
            double again[3], moment[3];
            lobe_prefilter_image_direction(&y_up, 0, i + 0.5, j + 0.5, again);
            assert_true(fabs(dot(again, turned) - 1) < 1e-12);
            /* The rectangle's moment: its length is close to the solid angle, it points close to the middle. */
            const double angle = lobe_prefilter_image_moment(&y_up, 0, i, j, i + 1, j + 1, moment);
            assert_true(fabs(angle / lobe_environment_solid_angle(&map, i) - 1) < 1e-12);
            assert_true(fabs(dot(moment, turned) / angle - 1) < 0.01);
        }
    lobe_environment_free(&map);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(kernels_integrate_to_one),
        cmocka_unit_test(scale_both_ways),
        cmocka_unit_test(cube_geometry),
        cmocka_unit_test(folds_to_the_neighbour),
        cmocka_unit_test(sampler_is_seamless),
        cmocka_unit_test(sampler_values),
        cmocka_unit_test(halves),
        cmocka_unit_test(worlds),
    };
    return cmocka_run_group_tests_name("prefilter", tests, NULL, NULL);
}
