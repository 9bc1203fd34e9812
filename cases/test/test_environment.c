/* Maps of radiance: projection, turns, minimum, windows, the sun, full integration. Expected values come from
 * mathematics or from quadrature written here. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../environment/lobes.h"
#include "../environment/project.h"
#include "../environment/reflect.h"
#include "../environment/sky.h"
#include "../environment/sun.h"
#include "../environment/window.h"

enum { W = 64, H = 32 };

static lobe_environment black(void)
{
    lobe_environment map;
    assert_true(lobe_environment_allocate(&map, W, H));
    return map;
}

static float *texel(lobe_environment *map, int row, int column) { return map->rgb + 3 * (row * map->width + column); }

static void basis(double x, double y, double z, double b[9])
{
    const double pi = acos(-1), k1 = sqrt(3 / (4 * pi)), k2 = sqrt(15 / (4 * pi));
    const double all[9] = {sqrt(1 / (4 * pi)),
                           k1 * y,
                           k1 * z,
                           k1 * x,
                           k2 * x * y,
                           k2 * y * z,
                           sqrt(5 / (16 * pi)) * (3 * z * z - 1),
                           k2 * x * z,
                           k2 / 2 * (x * x - y * y)};
    memcpy(b, all, sizeof all);
}

/* Pseudo-random texels; the second map, if there is one, holds them turned by `turn` columns to the right. */
static void noise(lobe_environment *map, lobe_environment *turned, int turn)
{
    uint32_t state = 1;
    for (int i = 0; i < H; i++)
        for (int j = 0; j < W; j++)
            for (int k = 0; k < 3; k++) {
                state = state * 1664525u + 1013904223u;
                texel(map, i, j)[k] = (float)(state >> 8) / 1e6f;
                if (turned)
                    texel(turned, i, (j + turn) % W)[k] = (float)(state >> 8) / 1e6f;
            }
}

static void constant(void **state)
{
    (void)state;
    lobe_environment map;
    double sh[3][9];
    assert_true(lobe_environment_allocate(&map, 1024, 512));
    for (int i = 0; i < 3 * 1024 * 512; i++)
        map.rgb[i] = (float)(i % 3 + 1);
    assert_true(lobe_environment_project(&map, sh));
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < 9; k++)
            assert_true(fabs(sh[c][k] - (k == 0 ? (c + 1) * sqrt(4 * acos(-1)) : 0)) < 1e-11);
    lobe_environment_free(&map);
}

/* Simpson's rule over one texel, in angles. */
static void one_texel(void **state)
{
    (void)state;
    enum { N = 64 };
    const int row = 5, column = 11;
    const double pi = acos(-1);
    lobe_environment map = black();
    double sh[3][9], expected[9] = {0};
    texel(&map, row, column)[1] = 7;
    assert_true(lobe_environment_project(&map, sh));
    for (int i = 0; i <= N; i++)
        for (int j = 0; j <= N; j++) {
            const double theta = pi * (row + i / (double)N) / H, phi = pi * (1 - 2 * (column + j / (double)N) / W);
            const double a = i == 0 || i == N ? 1 : i % 2 ? 4 : 2, b = j == 0 || j == N ? 1 : j % 2 ? 4 : 2;
            double y[9];
            basis(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta), y);
            for (int k = 0; k < 9; k++)
                expected[k] += 7 * y[k] * sin(theta) * a * b * (pi / H / N / 3) * (2 * pi / W / N / 3);
        }
    for (int k = 0; k < 9; k++) {
        assert_true(fabs(expected[k] - sh[1][k]) < 1e-12);
        assert_true(sh[0][k] == 0 && sh[2][k] == 0);
    }
    lobe_environment_free(&map);
}

/* 16 of 64 columns to the left is +90 degrees about z: what shone along x shines along y, what along y along -x. */
static void quarter_turn(void **state)
{
    (void)state;
    lobe_environment map = black(), turned = black();
    double a[3][9], b[3][9];
    noise(&map, &turned, W - W / 4);
    assert_true(lobe_environment_project(&map, a) && lobe_environment_project(&turned, b));
    for (int c = 0; c < 3; c++) {
        const double *s = a[c];
        const double want[9] = {s[0], s[3], s[2], -s[1], -s[4], s[7], s[6], -s[5], -s[8]};
        for (int k = 0; k < 9; k++)
            assert_true(fabs(b[c][k] - want[k]) < 1e-12 * fabs(s[0]));
    }
    lobe_environment_free(&map);
    lobe_environment_free(&turned);
}

/* The lighting as a function of direction is the same in both worlds. */
static void y_up(void **state)
{
    (void)state;
    lobe_environment map = black();
    double sh[3][9], turned[9];
    noise(&map, NULL, 0);
    assert_true(lobe_environment_project(&map, sh));
    memcpy(turned, sh[0], sizeof turned);
    lobe_sh9_y_up(turned);
    for (int i = 0; i < 50; i++) {
        const double z = 1 - (2 * i + 1) / 50.0, phi = i * 2.399963, s = sqrt(1 - z * z);
        const double x = s * cos(phi), y = s * sin(phi);
        double here[9], there[9], a = 0, b = 0;
        basis(x, y, z, here);
        basis(-y, z, -x, there); /* right stays right: -y is +x there, +x is -z there */
        for (int k = 0; k < 9; k++) {
            a += here[k] * sh[0][k];
            b += there[k] * turned[k];
        }
        assert_true(fabs(a - b) < 1e-12 * sh[0][0]);
    }
    lobe_environment_free(&map);
}

/* The least of many directions is never below the exact minimum, and close to it. */
static double sampled_minimum(const double c[9])
{
    double least = 1e300;
    for (int i = 0; i < 200000; i++) {
        const double z = 1 - (2 * i + 1) / 200000.0, phi = i * 2.399963229728653, s = sqrt(1 - z * z);
        double b[9], value = 0;
        basis(s * cos(phi), s * sin(phi), z, b);
        for (int k = 0; k < 9; k++)
            value += b[k] * c[k];
        least = fmin(least, value);
    }
    return least;
}

static void minimum(void **state)
{
    (void)state;
    static const double some[3][9] = {
        {1, 0.3, -0.2, 0.5, 0.7, -0.4, 0.2, 0.1, -0.6}, {1, 0, 0, 0, 0, 0, -0.5, 0, 0}, {2, 0, 1, 0, 0, 0, 0, 0, 0}};
    for (int i = 0; i < 3; i++) {
        const double exact = lobe_sh9_minimum(some[i]), seen = sampled_minimum(some[i]);
        assert_true(exact <= seen + 1e-12 && seen - exact < 1e-4);
    }
}

/* A lone sun makes the irradiance negative behind it: the window lifts it to 0 and leaves band 0. */
static void windows(void **state)
{
    (void)state;
    lobe_environment map = black();
    double sh[3][9], before[3][9], seen[9];
    for (int k = 0; k < 3; k++)
        texel(&map, 9, 20)[k] = 5;
    assert_true(lobe_environment_project(&map, sh));
    memcpy(before, sh, sizeof sh);
    const double k = lobe_sh9_window_positive(sh);
    assert_true(k > 0);
    for (int c = 0; c < 3; c++) {
        assert_true(sh[c][0] == before[c][0]);
        for (int i = 0; i < 9; i++) {
            const double l = i == 0 ? 0 : i < 4 ? 1 : 2, q = l * (l + 1);
            assert_true(fabs(sh[c][i] * (1 + k * q * q) - before[c][i]) < 1e-12);
            seen[i] = sh[c][i] * (i == 0 ? 1 : i < 4 ? 2 / 3.0 : 0.25);
        }
        const double least = sampled_minimum(seen);
        assert_true(least > -1e-12 && least < 1e-5);
    }
    memcpy(sh, before, sizeof sh);
    lobe_sh9_window_hanning(sh[0], 5);
    assert_true(sh[0][0] == before[0][0]);
    assert_true(fabs(sh[0][2] - before[0][2] * (1 + cos(acos(-1) / 5)) / 2) < 1e-15);
    assert_true(fabs(sh[0][6] - before[0][6] * (1 + cos(2 * acos(-1) / 5)) / 2) < 1e-15);
    for (int i = 0; i < W * H * 3; i++)
        map.rgb[i] = 1;
    assert_true(lobe_environment_project(&map, sh));
    assert_true(lobe_sh9_window_positive(sh) == 0);
    for (int i = 0; i < W * H * 3; i++)
        map.rgb[i] = -1;
    assert_true(lobe_environment_project(&map, sh));
    assert_true(lobe_sh9_window_positive(sh) < 0);
    lobe_environment_free(&map);
}

static void total(const lobe_environment *map, double sum[3])
{
    sum[0] = sum[1] = sum[2] = 0;
    for (int i = 0; i < map->height; i++)
        for (int j = 0; j < map->width; j++)
            for (int k = 0; k < 3; k++)
                sum[k] += (double)map->rgb[3 * (i * map->width + j) + k] * lobe_environment_solid_angle(map, i);
}

static void sun_is_taken(void **state)
{
    (void)state;
    lobe_environment map = black();
    lobe_sun sun;
    double d[3], before[3], after[3];
    for (int i = 0; i < W * H * 3; i++)
        map.rgb[i] = 1;
    for (int k = 0; k < 3; k++)
        texel(&map, 5, 11)[k] = 1001 + (float)k;
    lobe_environment_direction(&map, 5, 11, d);
    total(&map, before);
    assert_true(lobe_environment_take_sun(&map, 0.5, &sun));
    total(&map, after);
    for (int k = 0; k < 3; k++) {
        assert_true(fabs(sun.irradiance[k] - (1000 + k) * lobe_environment_solid_angle(&map, 5)) < 1e-9);
        assert_true(fabs(before[k] - after[k] - sun.irradiance[k]) < 1e-9);
        assert_true(fabs(sun.direction[k] - d[k]) < 1e-12);
        assert_true(texel(&map, 5, 11)[k] == 1);
    }
    assert_false(lobe_environment_take_sun(&map, 0.5, &sun)); /* an even sky has none */
    for (int k = 0; k < 3; k++)
        texel(&map, 5, 11)[k] = 101;
    assert_false(lobe_environment_take_sun(&map, 0.5, &sun)); /* a lamp of .15 of the mean irradiance stays */
    assert_true(texel(&map, 5, 11)[0] == 101);
    assert_true(lobe_environment_take_sun(&map, 0.05, &sun)); /* unless it is asked for */
    lobe_environment_free(&map);
}

/* A sun of many texels over an uneven sky, also at the zenith, where its disc holds a whole row. */
static void sun_conserves(void **state)
{
    (void)state;
    for (int zenith = 0; zenith < 2; zenith++) {
        lobe_environment map;
        lobe_sun sun;
        double centre[3], d[3], before[3], after[3];
        assert_true(lobe_environment_sky(&map, 512, 256, 4));
        lobe_environment_direction(&map, zenith ? 0 : 70, 100, centre);
        for (int i = 0; i < 256; i++)
            for (int j = 0; j < 512; j++) {
                lobe_environment_direction(&map, i, j, d);
                const double c = d[0] * centre[0] + d[1] * centre[1] + d[2] * centre[2];
                for (int k = 0; k < 3; k++)
                    texel(&map, i, j)[k] += c > cos(0.03) ? (float)(5000 - 500 * k) : 0;
            }
        total(&map, before);
        assert_true(lobe_environment_take_sun(&map, 0.5, &sun));
        total(&map, after);
        for (int k = 0; k < 3; k++)
            assert_true(fabs(before[k] - after[k] - sun.irradiance[k]) < 1e-6 * before[k]);
        assert_true(sun.direction[0] * centre[0] + sun.direction[1] * centre[1] + sun.direction[2] * centre[2] >
                    cos(0.015));
        lobe_environment_free(&map);
    }
}

/* Under order-3 lighting the exact lobe and the sum over all texels agree to the map's resolution. */
static void full_integration(void **state)
{
    (void)state;
    static const double light[9] = {2, 0.3, -0.2, 0.5, 0.4, -0.3, 0.2, 0.1, -0.4};
    static const double n[3] = {0.48, 0.6, 0.64}, v[3] = {-0.6, 0.64, 0.48};
    lobe_environment map;
    lobe_light_texels texels;
    double sh[3][9], lobe[9], want[3], got[3];
    assert_true(lobe_environment_allocate(&map, 512, 256));
    for (int i = 0; i < 256; i++)
        for (int j = 0; j < 512; j++) {
            double d[3], b[9], value = 0;
            lobe_environment_direction(&map, i, j, d);
            basis(d[0], d[1], d[2], b);
            for (int k = 0; k < 9; k++)
                value += b[k] * light[k];
            for (int k = 0; k < 3; k++)
                texel(&map, i, j)[k] = (float)(value * (k + 1));
        }
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < 9; k++)
            sh[c][k] = light[k] * (c + 1);
    assert_true(lobe_light_texels_of(&map, &texels));
    for (int r = 0; r <= 2; r++) {
        lobe_diffuse_lobe(LOBE_DIFFUSE_EXACT, r / 2.0, n, v, lobe);
        lobe_diffuse_light(lobe, sh, want);
        lobe_reflect_texels(&texels, r / 2.0, n, v, got);
        for (int k = 0; k < 3; k++)
            assert_true(fabs(got[k] - want[k]) < 1e-4 * want[k]);
    }
    lobe_light_texels_free(&texels);
    lobe_environment_free(&map);
}

/* Shrinking keeps what the map sends in all, and refuses sides that do not divide. */
static void shrink(void **state)
{
    (void)state;
    lobe_environment map = black(), small;
    double before[3], after[3];
    noise(&map, NULL, 0);
    assert_true(lobe_environment_shrink(&map, 4, &small));
    assert_int_equal(small.width, W / 4);
    total(&map, before);
    total(&small, after);
    for (int k = 0; k < 3; k++)
        assert_true(fabs(before[k] - after[k]) < 1e-6 * before[k]);
    lobe_environment_free(&small);
    assert_false(lobe_environment_shrink(&map, 3, &small));
    lobe_environment_free(&map);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(constant),     cmocka_unit_test(one_texel),     cmocka_unit_test(quarter_turn),
        cmocka_unit_test(y_up),         cmocka_unit_test(minimum),       cmocka_unit_test(windows),
        cmocka_unit_test(sun_is_taken), cmocka_unit_test(sun_conserves), cmocka_unit_test(full_integration),
        cmocka_unit_test(shrink),
    };
    return cmocka_run_group_tests_name("environment", tests, NULL, NULL);
}
