/* A sphere light as nine spherical harmonics, and lighting made of such lights: against integrals that are known, and
 * through the radiance that the library makes of it. How far order 3 is from the light itself is measured in
 * cases/test/test_sphere_diffuse.c. */
#define LOBE_DOUBLE 1
#include "../../models/diffuse_sh.h"
#include "../../models/lobe.h"
#include "cmocka_first.h"
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979323846;
static uint64_t state_of_random = 1;

static double random_unit(void)
{
    state_of_random = state_of_random * 6364136223846793005u + 1442695040888963407u;
    return (double)(state_of_random >> 11) * 0x1p-53;
}

static int32_t q30(double x) { return (int32_t)floor(x * 1073741824.0 + 0.5); }

static void random_direction(double d[3])
{
    const double z = 2 * random_unit() - 1, a = 2 * pi * random_unit(), s = sqrt(1 - z * z);
    d[0] = s * cos(a);
    d[1] = s * sin(a);
    d[2] = z;
}

static void basis(const double d[3], double b[9])
{
    const double k1 = sqrt(3 / (4 * pi)), k2 = sqrt(15 / (4 * pi));
    const double all[9] = {sqrt(1 / (4 * pi)),
                           k1 * d[1],
                           k1 * d[2],
                           k1 * d[0],
                           k2 * d[0] * d[1],
                           k2 * d[1] * d[2],
                           k2 * (3 * d[2] * d[2] - 1) / sqrt(12.0),
                           k2 * d[0] * d[2],
                           k2 * (d[0] * d[0] - d[1] * d[1]) / 2};
    memcpy(b, all, sizeof all);
}

/* By the addition theorem: the integral of a basis function over a cone is its value at the axis times the cone's
 * integral of the Legendre polynomial of its band. */
static void cone(double sine, const double d[3], double c[9])
{
    const double cosine = sqrt((1 - sine) * (1 + sine)), s2 = sine * sine;
    const double band[3] = {2 * pi * s2 / (1 + cosine), pi * s2, pi * cosine * s2};
    int k;
    basis(d, c);
    for (k = 0; k < 9; k++)
        c[k] *= band[k == 0 ? 0 : k < 4 ? 1 : 2];
}

static lobe_vec3_f32 vec_f32(const double d[3]) { return (lobe_vec3_f32){(float)d[0], (float)d[1], (float)d[2]}; }
static lobe_vec3_q30 vec_q30(const double d[3]) { return (lobe_vec3_q30){q30(d[0]), q30(d[1]), q30(d[2])}; }

static void cones_are_cones(void **state)
{
    static const double axes[6][3] = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
    int i, k;
    (void)state;
    for (i = 0; i < 20000; i++) {
        const double sine = i % 7 == 0 ? 1 : i % 2 ? random_unit() : pow(10, -3.7 * random_unit());
        double d[3], want[9];
        lobe_sh9_f32 f;
        lobe_sh9_q30 q;
        random_direction(d);
        if (i < 6)
            memcpy(d, axes[i], sizeof d);
        f = lobe_sphere_sh_f32((float)sine, vec_f32(d));
        cone((double)(float)sine, (const double[3]){(double)(float)d[0], (double)(float)d[1], (double)(float)d[2]},
             want);
        for (k = 0; k < 9; k++)
            if (!(fabs((double)f.c[k] - want[k]) <= 4e-7 * pi * sine * sine))
                fail_msg("f32 c%d of sine %.9g about %g %g %g: %.9g, not %.9g", k, sine, d[0], d[1], d[2],
                         (double)f.c[k], want[k]);
        q = lobe_sphere_sh_q30(q30(sine), vec_q30(d));
        cone(q30(sine) / 1073741824.0, d, want);
        for (k = 0; k < 9; k++)
            if (!(fabs(q.c[k] / 1073741824.0 - want[k]) <= 6e-9))
                fail_msg("q30 c%d of sine %.9g about %g %g %g: %.12g, not %.12g", k, sine, d[0], d[1], d[2],
                         q.c[k] / 1073741824.0, want[k]);
    }
}

/* Half the sky by hand: 2 pi over the four pi of c0, the vector pi, no band 2. And a light of no size is none. */
static void half_the_sky_by_hand(void **state)
{
    const lobe_sh9_f32 half = lobe_sphere_sh_f32(1.0f, (lobe_vec3_f32){0, 0, 1});
    const lobe_sh9_f32 none = lobe_sphere_sh_f32(0.0f, (lobe_vec3_f32){0, 0, 1});
    int k;
    (void)state;
    assert_true(fabs((double)half.c[0] - sqrt(pi)) <= 2e-7 && fabs((double)half.c[2] - sqrt(3 * pi / 4)) <= 2e-7);
    for (k = 0; k < 9; k++) {
        assert_true(none.c[k] == 0.0f);
        assert_true(k == 0 || k == 2 || half.c[k] == 0.0f);
    }
}

/* Two lights and what was there before, through the radiance in world space, against the local coefficients in double
 * and the light turned into their frame by hand. */
static void lighting_adds_up(void **state)
{
    int i, k;
    (void)state;
    for (i = 0; i < 2000; i++) {
        const double roughness = random_unit(), v = random_unit(), tall = sqrt(1 - v * v);
        const double sine[2] = {random_unit(), 0.01 + random_unit() / 10}, power[2] = {3 * random_unit(), 100};
        const double view[3] = {tall, 0, v};
        lobe_lighting_f32 light;
        lobe_lighting_q16 light_q;
        lobe_vec3_f32 rgb;
        lobe_vec3_q16 rgb_q;
        double want = 0, d[3], c[9];
        const lobe_sh9 lobe = lobe_diffuse_sh_exact(roughness, v);
        const double weight[9] = {lobe.c0, lobe.c1, lobe.c2, lobe.c3, lobe.c4, lobe.c5, lobe.c6, lobe.c7, lobe.c8};
        memset(&light, 0, sizeof light);
        memset(&light_q, 0, sizeof light_q);
        light.green.c[0] = 0.5f;
        light_q.green.c[0] = 1 << 15;
        want += 0.5 * lobe.c0;
        for (k = 0; k < 2; k++) {
            int j;
            const double half = power[k] / 2;
            random_direction(d);
            cone(sine[k], d, c);
            for (j = 0; j < 9; j++)
                want += weight[j] * c[j] * power[k];
            lobe_lighting_add_sphere_f32(&light, (lobe_vec3_f32){(float)half, (float)power[k], 0}, (float)sine[k],
                                         vec_f32(d));
            lobe_lighting_add_sphere_q16(
                &light_q, (lobe_vec3_q16){(int32_t)(half * 65536), (int32_t)(power[k] * 65536), -1048576}, q30(sine[k]),
                vec_q30(d));
        }
        rgb = lobe_diffuse_sh_radiance_exact_f32((float)roughness, (lobe_vec3_f32){0, 0, 1}, vec_f32(view), &light);
        rgb_q = lobe_diffuse_sh_radiance_exact_q30(q30(roughness), (lobe_vec3_q30){0, 0, LOBE_ONE_Q30}, vec_q30(view),
                                                   &light_q);
        want = fmax(want, 0);
        assert_true(fabs((double)rgb.y - want) <= 1e-5 + 1e-5 * (power[0] + 1) && rgb.z == 0.0f);
        assert_true(fabs(rgb_q.y / 65536.0 - want) <= 25.0 / 65536 && rgb_q.z == 0);
        if (want > 1)
            assert_true(fabs((double)rgb.x - (want - 0.5 * lobe.c0) / 2) <= 1e-4);
    }
}

/* What is added stays finite whatever it is. */
static void bad_numbers(void **state)
{
    static const float odd[] = {NAN, INFINITY, -INFINITY, FLT_MAX, -FLT_MAX, 0.0f, -1.0f, 1e-40f};
    enum { ODD = sizeof odd / sizeof odd[0] };
    lobe_lighting_q16 q;
    int i, k;
    (void)state;
    for (i = 0; i < ODD * ODD * ODD; i++) {
        const float a = odd[i % ODD], b = odd[i / ODD % ODD], c = odd[i / ODD / ODD];
        lobe_lighting_f32 f;
        memset(&f, 0, sizeof f);
        for (k = 0; k < 9; k++)
            f.red.c[k] = odd[(i + k) % ODD];
        lobe_lighting_add_sphere_f32(&f, (lobe_vec3_f32){a, b, c}, b, (lobe_vec3_f32){c, a, b});
        lobe_lighting_add_sphere_f32(&f, (lobe_vec3_f32){a, b, c}, 1.0f, (lobe_vec3_f32){c, a, b});
        for (k = 0; k < 9; k++)
            assert_true(fabsf(f.red.c[k]) <= FLT_MAX && fabsf(f.green.c[k]) <= FLT_MAX &&
                        fabsf(f.blue.c[k]) <= FLT_MAX);
    }
    memset(&q, 0, sizeof q);
    for (i = 0; i < 4; i++)
        lobe_lighting_add_sphere_q16(&q, (lobe_vec3_q16){INT32_MAX, INT32_MIN, 1 << 16}, INT32_MAX,
                                     (lobe_vec3_q30){INT32_MIN, INT32_MIN, INT32_MAX});
    assert_int_equal(q.red.c[0], INT32_MAX);
    assert_int_equal(q.red.c[3], INT32_MIN);
    assert_int_equal(q.green.c[0], 0);
    assert_true(abs(q.blue.c[0] - (int32_t)(4 * sqrt(pi) * 65536)) <= 8);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cones_are_cones),
        cmocka_unit_test(half_the_sky_by_hand),
        cmocka_unit_test(lighting_adds_up),
        cmocka_unit_test(bad_numbers),
    };
    return cmocka_run_group_tests_name("sphere_sh", tests, NULL, NULL);
}
