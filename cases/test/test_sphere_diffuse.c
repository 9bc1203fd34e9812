/* The truth of sphere_diffuse: the closed form is what quadrature gives, and both meet what is known by hand. Then
 * Burley's diffuse under a sphere light by quadrature, and how far from it nine spherical harmonics are. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <math.h>
#include "../../models/lobe.h"
#include "../diffuse_sh/truth_diffuse.h"
#include "../fit/random.h"
#include "../sphere_diffuse/burley_cone.h"
#include "../sphere_diffuse/truth_sphere_diffuse.h"

static const double pi = 3.14159265358979323846;

/* Half angles of 1e-4 to all but a right angle, half of them through the horizon. */
static void closed_form_is_the_integral(void **state)
{
    lobe_random random;
    double most = 0;
    int i;
    (void)state;
    lobe_random_seed(&random, 1, 0);
    for (i = 0; i < 6000; i++) {
        const double u = lobe_random_unit(&random), v = lobe_random_unit(&random);
        const double s = i % 3 == 0   ? pow(10, -4 * u)
                         : i % 3 == 1 ? sin(pi / 2 * u) + 1e-4 * (1 - u)
                                      : 1 - pow(10, -9 * u);
        const double sine = fmin(1, fmax(1e-4, s)), n_dot_l = i & 1 ? sine * sin(pi * (v - 0.5)) : 2 * v - 1;
        const double closed = lobe_truth_sphere_diffuse(n_dot_l, sine);
        const double sum = lobe_truth_sphere_diffuse_heights(n_dot_l, sine, 1e-12);
        most = fmax(most, fabs(closed - sum) / (sine * sine));
    }
    print_message("# closed form to quadrature: %.1e of sine^2\n", most);
    assert_true(most <= 1e-12);
}

/* A tolerance that is not asked for is not delivered: the quadrature does the work, not a formula behind it. */
static void tolerance_matters(void **state)
{
    double most = 0;
    int i;
    (void)state;
    for (i = 1; i < 40; i++)
        most = fmax(most, fabs(lobe_truth_sphere_diffuse_heights(0.9 * (i / 20.0 - 1), 0.9, 1e-3) -
                               lobe_truth_sphere_diffuse(0.9 * (i / 20.0 - 1), 0.9)));
    assert_true(most > 1e-12 && most < 1e-3);
}

/* Half the sky is (1 + c) / 2; half a small disc 2 / (3 pi) s^3; what is up and what is down make a whole light, in
 * which the difference of the two is s^2 c. */
static void known_by_hand(void **state)
{
    int i, k;
    (void)state;
    for (i = -16; i <= 16; i++)
        assert_true(fabs(lobe_truth_sphere_diffuse(i / 16.0, 1) - (1 + i / 16.0) / 2) <= 2e-15);
    for (i = 0; i < 30; i++) {
        const double s = ldexp(1, -i) * 0.1, want = 2 / (3 * pi) * s * s * s;
        assert_true(fabs(lobe_truth_sphere_diffuse(0, s) / want - 1) <= 0.31 * s * s + 2e-15);
        for (k = 0; k <= 32; k++) {
            const double c = s * k / 32, both = lobe_truth_sphere_diffuse(c, s) - lobe_truth_sphere_diffuse(-c, s);
            assert_true(fabs(both - s * s * c) <= 2e-15 * s * s);
        }
    }
    assert_true(lobe_truth_sphere_diffuse(-0.5, 0.5) == 0 && lobe_truth_sphere_diffuse(1, 0) == 0);
}

/* The whole sky overhead is the white furnace, which c0 of the projection knows; a small light is a punctual one. */
static void burley_meets_its_ends(void **state)
{
    int i, k;
    (void)state;
    for (i = 0; i <= 4; i++)
        for (k = 0; k <= 4; k++) {
            const double in[2] = {i / 4.0, k / 4.0}, tall = sqrt(1 - in[1] * in[1]), sine = 1e-3;
            double c[9], punctual;
            lobe_truth_diffuse_rows(in, c, 1);
            assert_true(fabs(lobe_truth_burley_cone(in[0], in[1], 1, 0, 1) - c[0] * sqrt(4 * pi)) <= 1e-7);
            punctual = 0.8 * lobe_burley_2012(0.8, in[1], 0.6 * cos(1) * tall + 0.8 * in[1], in[0]);
            assert_true(fabs(lobe_truth_burley_cone(in[0], in[1], 0.8, 1, sine) / (pi * sine * sine * punctual) - 1) <=
                        4e-6);
        }
}

/* What README.md says of order 3, by half angle in degrees: the relative rms over random roughness, view, height and
 * azimuth, and the largest error as a part of sine^2, which is what a white Lambert makes of the light overhead; and
 * the rms of exact irradiance times Burley at the light's centre, which is the better of the two for small lights. */
static const struct row {
    double degrees, rms, max, centre_rms;
} rows[] = {
    {1, 0.087, 0.20, 0.0002},  {10, 0.076, 0.14, 0.0076}, {20, 0.057, 0.11, 0.024},  {30, 0.036, 0.067, 0.042},
    {45, 0.011, 0.029, 0.076}, {60, 0.0102, 0.018, 0.12}, {75, 0.0097, 0.027, 0.17}, {90, 0.0046, 0.025, 0.22},
};

static double by_harmonics(double roughness, double n_dot_v, double n_dot_l, double azimuth, double sine)
{
    const double across = sqrt(1 - n_dot_l * n_dot_l);
    const lobe_vec3_f32 d = {(float)(across * cos(azimuth)), (float)(across * sin(azimuth)), (float)n_dot_l};
    const lobe_sh9_f32 lobe = lobe_diffuse_sh_exact_f32((float)roughness, (float)n_dot_v);
    const lobe_sh9_f32 light = lobe_sphere_sh_f32((float)sine, d);
    double sum = 0;
    int k;
    for (k = 0; k < 9; k++)
        sum += (double)lobe.c[k] * (double)light.c[k];
    return fmax(sum, 0);
}

static void order_three_blurs_as_stated(void **state)
{
    enum { DRAWS = 1000 };
    size_t r;
    int i;
    (void)state;
    for (r = 0; r < sizeof rows / sizeof rows[0]; r++) {
        const double sine = rows[r].degrees < 90 ? sin(rows[r].degrees * pi / 180) : 1;
        double square = 0, total = 0, most = 0, centre = 0;
        lobe_random random;
        lobe_random_seed(&random, 7, 0);
        for (i = 0; i < DRAWS; i++) {
            const double roughness = lobe_random_unit(&random), v = lobe_random_unit(&random);
            const double c = 2 * lobe_random_unit(&random) - 1, azimuth = pi * lobe_random_unit(&random);
            const double truth = lobe_truth_burley_cone(roughness, v, c, azimuth, sine);
            const double error = by_harmonics(roughness, v, c, azimuth, sine) - truth;
            const double l_dot_v = sqrt((1 - c * c) * (1 - v * v)) * cos(azimuth) + c * v;
            const double other =
                pi * lobe_truth_sphere_diffuse(c, sine) * lobe_burley_2012(fmax(c, 0), v, l_dot_v, roughness) - truth;
            square += error * error;
            centre += other * other;
            total += truth * truth;
            most = fmax(most, fabs(error) / (sine * sine));
        }
        square = sqrt(square / total);
        centre = sqrt(centre / total);
        print_message("# %2g degrees: rms %.4f, max %.4f; irradiance times Burley at the centre %.5f\n",
                      rows[r].degrees, square, most, centre);
        assert_true(square <= rows[r].rms && square >= 0.8 * rows[r].rms);
        assert_true(most <= rows[r].max && centre <= rows[r].centre_rms);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closed_form_is_the_integral),
        cmocka_unit_test(tolerance_matters),
        cmocka_unit_test(known_by_hand),
        cmocka_unit_test(burley_meets_its_ends),
        cmocka_unit_test(order_three_blurs_as_stated),
    };
    return cmocka_run_group_tests_name("sphere_diffuse truth", tests, NULL, NULL);
}
