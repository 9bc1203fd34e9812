/* The fan of spherical Gaussians: its integrals against brute force, the solver, what the kernel promises, the floors.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <string.h>
#include "../env_lobes/kernels.h"
#include "../env_lobes/response.h"
#include "../env_lobes/rooms.h"
#include "../env_lobes_sg/lights.h"
#include "../env_lobes_sg/newton.h"
#include "../env_lobes_sg/scenes.h"
#include "../env_lobes_sg/shipped.h"
#include "../fit/random.h"

static const double pi = 3.14159265358979323846;
static const int counts[4] = {1, 2, 4, 8};

static void assert_near(double got, double want, double tolerance)
{
    if (!(fabs(got - want) <= tolerance))
        fail_msg("got %.12g, want %.12g within %.3g", got, want, tolerance);
}

/* Over the whole sphere, by the midpoint rule in angle and azimuth; ctx is what f needs. */
static double over_sphere(double (*f)(const void *ctx, const double l[3]), const void *ctx)
{
    enum { RINGS = 900, TURNS = 900 };
    double sum = 0;
    int i, j;
    for (i = 0; i < RINGS; i++) {
        const double angle = pi * (i + 0.5) / RINGS;
        for (j = 0; j < TURNS; j++) {
            const double turn = 2 * pi * (j + 0.5) / TURNS;
            const double l[3] = {sin(angle) * cos(turn), sin(angle) * sin(turn), cos(angle)};
            sum += f(ctx, l) * sin(angle) * (pi / RINGS) * (2 * pi / TURNS);
        }
    }
    return sum;
}

static double product(const void *ctx, const double l[3])
{
    const lobe_sg *pair = ctx;
    return lobe_sg_at(&pair[0], l) * lobe_sg_at(&pair[1], l);
}

static void test_products_of_lobes(void **state)
{
    const lobe_sg pairs[][2] = {
        {{0.3, 4, 0.7}, {1.1, 30, 0.5}}, {{-0.4, 0.3, 1}, {1.5, 0.9, -2}}, {{1, 90, 1}, {1, 90, 1}}};
    size_t i;
    (void)state;
    for (i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        const double want = over_sphere(product, pairs[i]);
        assert_near(lobe_sg_product(&pairs[i][0], &pairs[i][1]), want, 1e-4 * fabs(want));
    }
}

typedef struct difference {
    const lobe_sg *lobes;
    double alpha, n_dot_v;
} difference;

static double squared_difference(const void *ctx, const double l[3])
{
    const difference *d = ctx;
    const double e = lobe_response(d->alpha, d->n_dot_v, l) - lobe_sg_at(&d->lobes[0], l) - lobe_sg_at(&d->lobes[1], l);
    return e * e;
}

static double squared(const void *ctx, const double l[3])
{
    const difference *d = ctx;
    const double e = lobe_response(d->alpha, d->n_dot_v, l);
    return e * e;
}

static void test_distance_from_the_response(void **state)
{
    static const double points[][2] = {{0.3, 0.6}, {0.7, 0.2}, {1, 1}};
    const lobe_sg lobes[2] = {{0.5, 12, 0.6}, {1, 5, 0.2}};
    size_t i;
    (void)state;
    for (i = 0; i < sizeof points / sizeof points[0]; i++) {
        const difference d = {lobes, points[i][0], points[i][1]};
        lobe_sg_target t;
        assert_true(lobe_sg_target_make(&t, d.alpha, d.n_dot_v, 96));
        assert_near(lobe_sg_target_error(&t, lobes, 2),
                    sqrt(over_sphere(squared_difference, &d) / over_sphere(squared, &d)), 1e-3);
        lobe_sg_target_free(&t);
    }
}

static void test_bands_of_a_lobe(void **state)
{
    static const double sharpness[] = {0.2, 3, 60, 900};
    static const int bands[] = {1, 2, 7, 25};
    size_t i, b;
    (void)state;
    for (i = 0; i < 4; i++) {
        double factor[64];
        lobe_sg_bands(sharpness[i], 64, factor);
        assert_near(factor[0], 1, 0);
        for (b = 0; b < 4; b++) {
            enum { STEPS = 1000000 };
            double sum = 0;
            int k, l;
            for (k = 0; k < STEPS; k++) {
                const double c = -1 + 2 * (k + 0.5) / STEPS;
                double p0 = 1, p1 = c;
                for (l = 1; l < bands[b]; l++) {
                    const double p2 = ((2 * l + 1) * c * p1 - l * p0) / (l + 1);
                    p0 = p1;
                    p1 = p2;
                }
                sum += 2 * pi * lobe_sg_kernel(sharpness[i], c) * p1 * 2 / STEPS;
            }
            assert_near(factor[bands[b]], sum, 2e-6);
        }
    }
}

/* Where the light has band 1 alone, radiance is a vector's: the response's first moment. */
static void test_radiance_in_band_1(void **state)
{
    const lobe_sg lobes[2] = {{0.5, 12, 0.6}, {1, 5, 0.2}};
    lobe_env_spectrum light = {{0, 1}};
    lobe_sg_scene s;
    double moment[3] = {0}, own = 0, error = 0, square;
    size_t i;
    int k;
    (void)state;
    assert_true(lobe_sg_scene_make(&s, 0.3, 0.6, 48, &light, 1, 0));
    for (i = 0; i < s.target.count; i++)
        for (k = 0; k < 3; k += 2)
            moment[k] += s.target.nodes[4 * i + 3] * s.target.nodes[4 * i + (size_t)k];
    own = moment[0] * moment[0] + moment[2] * moment[2];
    for (k = 0; k < 2; k++) {
        const double g = 1 / tanh(lobes[k].sharpness) - 1 / lobes[k].sharpness;
        moment[0] += lobes[k].weight * g * sin(lobes[k].angle);
        moment[2] -= lobes[k].weight * g * cos(lobes[k].angle);
    }
    error = (moment[0] * moment[0] + moment[2] * moment[2]) / own;
    assert_true(lobe_sg_scene_errors(&s, &light, 1, lobes, 2, NULL, &square));
    assert_near(square, error, 1e-4);
    assert_near(lobe_sg_scene_error(&s, lobes, 2), error, 1e-3);
    lobe_sg_scene_free(&s);
}

/* A rotation, by three numbers that are even in [0, 1) (Shoemake). */
static void rotation(lobe_random *random, double m[3][3])
{
    const double u = lobe_random_unit(random), a = 2 * pi * lobe_random_unit(random),
                 b = 2 * pi * lobe_random_unit(random);
    const double x = sqrt(1 - u) * sin(a), y = sqrt(1 - u) * cos(a), z = sqrt(u) * sin(b), w = sqrt(u) * cos(b);
    const double r[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                            {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                            {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
    memcpy(m, r, sizeof r);
}

/* The norm against what it stands for: an environment, turned 300 times, summed over its texels. */
static void test_radiance_over_orientations(void **state)
{
    enum { TURNS = 300 };
    lobe_environment map;
    lobe_env_spectrum light;
    lobe_sg_scene s;
    lobe_sg lobes[LOBE_SG_MOST];
    lobe_random random;
    double exact, error = 0, truth = 0, m[3][3];
    int turn, i, j, k;
    (void)state;
    assert_true(lobe_room_make(&map, LOBE_ROOM_LAMPS, 128, 5));
    assert_true(lobe_sg_light_of(&map, &light));
    assert_true(lobe_sg_scene_make(&s, 0.3, 0.3, 48, &light, 1, 0));
    lobe_sg_shipped(2, sqrt(0.3), 0.3, s.target.albedo, lobes);
    assert_true(lobe_sg_scene_errors(&s, &light, 1, lobes, 2, NULL, &exact));
    lobe_random_seed(&random, 9, 0);
    for (turn = 0; turn < TURNS; turn++) {
        double want = 0, got = 0;
        rotation(&random, m);
        for (i = 0; i < map.height; i++)
            for (j = 0; j < map.width; j++) {
                const float *rgb = map.rgb + 3 * (i * map.width + j);
                const double area = lobe_environment_solid_angle(&map, i) / 3 * (double)(rgb[0] + rgb[1] + rgb[2]);
                double d[3], l[3];
                lobe_environment_direction(&map, i, j, d);
                for (k = 0; k < 3; k++)
                    l[k] = m[k][0] * d[0] + m[k][1] * d[1] + m[k][2] * d[2];
                want += area * lobe_response(0.3, 0.3, l);
                got += area * (lobe_sg_at(&lobes[0], l) + lobe_sg_at(&lobes[1], l));
            }
        truth += want * want;
        error += (got - want) * (got - want);
    }
    assert_near(sqrt(error / truth) / sqrt(exact), 1, 0.1);
    lobe_sg_scene_free(&s);
    lobe_environment_free(&map);
}

static double bowl(const void *ctx, size_t point, const double *q)
{
    const double x = (double)point / 10, u = q[0] - (1 + 2 * x), v = q[1] - (x * x - 3) - 0.5 * u;
    (void)ctx;
    return u * u + 3 * v * v + 0.1 * u * u * u * u;
}

static void test_newton_finds_surfaces(void **state)
{
    double feature[10 * 3], c[6] = {0}, value;
    const double want[6] = {1, 2, 0, -3, 0, 1};
    lobe_newton n = {.value = bowl,
                     .points = 10,
                     .quantities = 2,
                     .features = 3,
                     .feature = feature,
                     .step = 0.01,
                     .rounds = 40,
                     .threads = 2};
    int i;
    (void)state;
    for (i = 0; i < 10; i++) {
        feature[3 * i] = 1;
        feature[3 * i + 1] = i / 10.0;
        feature[3 * i + 2] = i * i / 100.0;
    }
    assert_true(lobe_newton_run(&n, c, &value));
    assert_true(value < 1e-9);
    for (i = 0; i < 6; i++)
        assert_near(c[i], want[i], 1e-3);
}

/* Weights sum to the albedo, every number is finite, and a fan has closed at n.v = 1. */
static void test_kernel(void **state)
{
    static const double roughness[] = {0, 0.001, 0.1, 0.2, 0.5, 0.8, 1, 2, -1, NAN, INFINITY};
    static const double view[] = {0, 0.001, 0.05, 0.3, 0.7, 1, 1.5, -2, NAN, -INFINITY};
    size_t r, v, c;
    (void)state;
    for (c = 0; c < 4; c++)
        for (r = 0; r < sizeof roughness / sizeof roughness[0]; r++)
            for (v = 0; v < sizeof view / sizeof view[0]; v++) {
                lobe_sg lobes[LOBE_SG_MOST];
                double sum = 0;
                int i;
                lobe_sg_shipped(counts[c], roughness[r], view[v], 0.8, lobes);
                for (i = 0; i < counts[c]; i++) {
                    sum += lobes[i].weight;
                    assert_true(fabs(lobes[i].angle) <= 6 && fabs(lobes[i].weight) <= 3);
                    assert_true(lobes[i].sharpness > 0 && lobes[i].sharpness < 1e8);
                    if (view[v] >= 1)
                        assert_near(lobes[i].angle, 0, 1e-15);
                    if (i > 0)
                        assert_true(lobes[i].angle >= lobes[i - 1].angle);
                }
                assert_near(sum, 0.8, 1e-12);
            }
}

/* Neighbours are near: no lobe turns by more than a step's worth, nothing jumps. */
static void test_kernel_is_continuous(void **state)
{
    int i, j, k;
    size_t c;
    (void)state;
    for (c = 0; c < 4; c++)
        for (i = 4; i <= 20; i++)
            for (j = 1; j < 2000; j++) {
                lobe_sg a[LOBE_SG_MOST], b[LOBE_SG_MOST];
                const double v = 0.02 + 0.98 * j / 2000, w = v + 1e-6;
                lobe_sg_shipped(counts[c], i / 20.0, v, 1, a);
                lobe_sg_shipped(counts[c], i / 20.0, fmin(w, 1), 1, b);
                for (k = 0; k < counts[c]; k++) {
                    assert_near(a[k].angle, b[k].angle, 1e-3);
                    assert_near(log(a[k].sharpness), log(b[k].sharpness), 1e-3);
                    assert_near(a[k].weight, b[k].weight, 1e-3);
                }
            }
}

static int shipped(const void *ctx, double alpha, double n_dot_v, double energy, lobe_sg *lobes)
{
    return lobe_sg_shipped(*(const int *)ctx, sqrt(alpha), n_dot_v, energy, lobes);
}

/* In all orientations of environments that the fit has not seen, against the split sum in the same run. */
static void test_floors(void **state)
{
    lobe_env_spectrum spectra[LOBE_SG_HELD];
    lobe_sg_scenes s;
    double split, error[4], shape;
    int i;
    (void)state;
    assert_true(lobe_sg_lights_held(spectra));
    assert_true(lobe_sg_scenes_make(&s, true, spectra, LOBE_SG_HELD, 0.02, 2));
    split = lobe_sg_scenes_error(&s, spectra, LOBE_SG_HELD, lobe_sg_split_sum, NULL, NULL, NULL);
    for (i = 0; i < 4; i++) {
        double by_light[LOBE_SG_HELD];
        int e;
        error[i] = lobe_sg_scenes_error(&s, spectra, LOBE_SG_HELD, shipped, &counts[i], by_light, &shape);
        print_message("# lobes%d: %.4f, %.3f of the split sum's %.4f; shape %.3f; by light", counts[i], error[i],
                      error[i] / split, split, shape);
        for (e = 0; e < LOBE_SG_HELD; e++)
            print_message(" %.4f", by_light[e]);
        print_message("\n");
        assert_true(error[i] < (i ? error[i - 1] : 0.7 * split));
    }
    assert_true(error[3] <= 0.25 * split);
    lobe_sg_scenes_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_products_of_lobes),
                                       cmocka_unit_test(test_distance_from_the_response),
                                       cmocka_unit_test(test_bands_of_a_lobe),
                                       cmocka_unit_test(test_radiance_in_band_1),
                                       cmocka_unit_test(test_radiance_over_orientations),
                                       cmocka_unit_test(test_newton_finds_surfaces),
                                       cmocka_unit_test(test_kernel),
                                       cmocka_unit_test(test_kernel_is_continuous),
                                       cmocka_unit_test(test_floors)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
