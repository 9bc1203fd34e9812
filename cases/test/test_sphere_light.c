/* The truth of sphere_light: two integrators agree, a small light is a punctual one, the whole hemisphere is the energy
 * case, a larger light is never darker; and the explored forms keep what README.md says of them. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <math.h>
#include "../split_sum/truth_split_sum.h"
#include "../fit/random.h"
#include "../sphere_light/candidates.h"
#include "../sphere_light/truth_sphere.h"

static const double pi = 3.14159265358979323846;

/* A third near the mirror direction, a third anywhere above -sigma, a third through the horizon. */
static lobe_sphere_scene scene_of(lobe_random *r, int i, double sigma_lo, double sigma_hi)
{
    lobe_sphere_scene s = {.f0 = i & 1 ? 1 : .04};
    double reach;
    s.alpha = .0025 * pow(400, lobe_random_unit(r));
    s.v_z = cos(1.55 * lobe_random_unit(r));
    s.sigma = sigma_lo * pow(sigma_hi / sigma_lo, lobe_random_unit(r));
    reach = s.sigma + s.alpha;
    if (i % 3 == 0) {
        s.l_z = cos(acos(s.v_z) + reach * (2 * lobe_random_unit(r) - 1));
        s.azimuth = pi - reach * lobe_random_unit(r);
    } else {
        const double u = lobe_random_unit(r);
        s.l_z = i % 3 == 1 ? (1 + sin(s.sigma)) * u - sin(s.sigma) : sin(s.sigma * (1.9 * u - .95));
        s.azimuth = pi * lobe_random_unit(r);
    }
    s.l_z = fmin(1, fmax(s.l_z, -.99 * sin(s.sigma)));
    s.azimuth = fabs(s.azimuth);
    return s;
}

static void agree(uint64_t seed, int count, double sigma_lo, double sigma_hi)
{
    lobe_random r;
    double most = 0, square = 0;
    int i, through = 0, behind = 0;
    lobe_random_seed(&r, seed, 0);
    for (i = 0; i < count; i++) {
        const lobe_sphere_scene s = scene_of(&r, i, sigma_lo, sigma_hi);
        const double x = lobe_truth_sphere_stretched(&s, 1e-7), y = lobe_truth_sphere_cone(&s, 1e-7);
        const double c = s.v_z * s.l_z + sqrt((1 - s.v_z * s.v_z) * (1 - s.l_z * s.l_z)) * cos(s.azimuth);
        const double error = fabs(x - y) / fmax(y, 1e-300);
        through += fabs(s.l_z) < sin(s.sigma);
        behind += c + cos(s.sigma) < 0;
        assert_true(x > 0 && y > 0);
        most = fmax(most, error);
        square += error * error;
    }
    print_message("# %d scenes, half angle %g to %g: %d through the horizon, %d hold -v; worst %.1e, rms %.1e\n", count,
                  sigma_lo, sigma_hi, through, behind, most, sqrt(square / count));
    assert_true(through > count / 4);
    assert_true(sigma_hi < 1 || behind > count / 20);
    assert_true(most <= 5e-6);
}

static void two_integrators_agree(void **state)
{
    (void)state;
    agree(41, 450, .01, pi / 4);
    agree(42, 300, .8, pi / 2);
    agree(43, 300, 1e-4, .01);
}

/* Its own second order is left: with the light's centre moved by sigma the lobe changes by some (sigma / alpha)^2. */
static void small_light_is_punctual(void **state)
{
    lobe_random r;
    double before = 0, most = 0;
    int i;
    (void)state;
    lobe_random_seed(&r, 44, 0);
    for (i = 0; i < 200; i++) {
        lobe_sphere_scene s = {.alpha = .05 + .95 * lobe_random_unit(&r),
                               .v_z = .1 + .9 * lobe_random_unit(&r),
                               .l_z = .1 + .9 * lobe_random_unit(&r),
                               .azimuth = pi * lobe_random_unit(&r),
                               .f0 = 1};
        double large, small;
        s.sigma = .01;
        large = fabs(lobe_truth_sphere_stretched(&s, 1e-8) / lobe_truth_sphere_punctual(&s) - 1);
        s.sigma = .001;
        small = fabs(lobe_truth_sphere_stretched(&s, 1e-8) / lobe_truth_sphere_punctual(&s) - 1);
        before = fmax(before, large);
        most = fmax(most, small);
    }
    print_message("# against the punctual light: %.1e at half angle .01, %.1e at .001\n", before, most);
    assert_true(before > 1e-4 && most <= .011 * before + 1e-7);
}

/* A light of half angle 90 degrees overhead is the whole sky: E of another integrator. */
static void hemisphere_is_energy(void **state)
{
    double most = 0;
    int i, j;
    (void)state;
    for (i = 1; i <= 10; i++) {
        for (j = 1; j <= 10; j++) {
            const double in[2] = {i / 10.0, j / 10.0};
            const lobe_sphere_scene s = {in[0] * in[0], in[1], 1, 0, pi / 2, 1};
            double energy;
            lobe_truth_energy_rows(in, &energy, 1);
            most = fmax(most, fabs(lobe_truth_sphere_stretched(&s, 1e-7) / energy - 1));
            most = fmax(most, fabs(lobe_truth_sphere_cone(&s, 1e-7) / energy - 1));
        }
    }
    print_message("# whole sky against the energy case: %.1e\n", most);
    assert_true(most <= 5e-7);
}

static void larger_is_never_darker(void **state)
{
    lobe_random r;
    int i, k;
    (void)state;
    lobe_random_seed(&r, 45, 0);
    for (i = 0; i < 40; i++) {
        lobe_sphere_scene s = scene_of(&r, i, .3, 1);
        double before = 0;
        for (k = 1; k <= 15; k++) {
            double y;
            s.sigma = .1 * k;
            y = lobe_truth_sphere_stretched(&s, 1e-7);
            assert_true(y >= before * (1 - 1e-6) && y <= 1 + 1e-7);
            before = y;
        }
    }
}

static void set_light_is_dark(void **state)
{
    const double in[10] = {.5, .5, -.5, 1, .5, .5, .5, -1, 1, 1.5};
    double out[2] = {1, 1};
    const lobe_sphere_scene s = {.25, .5, -.5, 1, .5, 1};
    (void)state;
    lobe_truth_sphere_rows(in, out, 2);
    assert_true(out[0] == 0 && out[1] == 0);
    assert_true(lobe_truth_sphere_cone(&s, 1e-7) == 0);
}

/* At the zenith nothing is clipped and the cone gives sin^2 of it; a light that is half set, by Snyder (1996). */
static void irradiance(void **state)
{
    int i;
    (void)state;
    for (i = 1; i <= 15; i++) {
        const double sigma = .1 * i, sine = sin(sigma);
        assert_true(fabs(lobe_truth_sphere_irradiance(1, sigma, 1e-9) - sine * sine) <= 1e-9);
        assert_true(fabs(lobe_truth_sphere_irradiance(0, sigma, 1e-9) - (sigma - sine * cos(sigma)) / pi) <= 1e-9);
    }
}

/* point, low, medium and high where the light is small; high is a radiance, so at most 1. */
static void forms_meet_the_punctual_light(void **state)
{
    lobe_random r;
    int i, k, forms = 0;
    (void)state;
    for (k = 0; lobe_sphere_candidate_at(k); k++) {
        const lobe_sphere_candidate *form = lobe_sphere_candidate_at(k);
        const char *name = form->name;
        if (name[0] != 'l' && name[0] != 'm' && name[0] != 'h' && name[0] != 'p')
            continue;
        forms++;
        lobe_random_seed(&r, 46, 0);
        for (i = 0; i < 300; i++) {
            const double row[5] = {.23 + .77 * lobe_random_unit(&r), .1 + .9 * lobe_random_unit(&r),
                                   .1 + .9 * lobe_random_unit(&r), pi * lobe_random_unit(&r), .01 * pi / 180};
            const lobe_sphere_scene s = {row[0] * row[0], row[1], row[2], row[3], row[4], 1};
            assert_true(fabs(form->call(row) / lobe_truth_sphere_punctual(&s) - 1) <= 1e-3);
        }
    }
    assert_int_equal(forms, 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_integrators_agree),
        cmocka_unit_test(small_light_is_punctual),
        cmocka_unit_test(hemisphere_is_energy),
        cmocka_unit_test(larger_is_never_darker),
        cmocka_unit_test(set_light_is_dark),
        cmocka_unit_test(irradiance),
        cmocka_unit_test(forms_meet_the_punctual_light),
    };
    return cmocka_run_group_tests_name("sphere_light truth", tests, NULL, NULL);
}
