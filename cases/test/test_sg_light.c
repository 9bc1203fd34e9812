/* The truth of spherical Gaussian lights: three integrators agree, and it has the limits that are known in closed form.
 * The published forms at the place where they are 0/0 in print. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <math.h>
#include <string.h>
#include "../fit/random.h"
#include "../sg_light/candidates.h"
#include "../sg_light/ndf.h"
#include "../sg_light/truth_sg.h"

static const double pi = 3.14159265358979323846;

/* Every second one near the mirror direction. */
static lobe_sg_scene any_scene(lobe_random *random, int i)
{
    lobe_sg_scene s;
    s.alpha = pow(10, -1.3 * lobe_random_unit(random));
    s.v_z = .02 + .98 * lobe_random_unit(random);
    s.sharpness = pow(4, 6 * lobe_random_unit(random));
    if (i & 1) {
        const double t = fmin(pi / 2, (2 / sqrt(s.sharpness) + 3 * s.alpha) * lobe_random_unit(random));
        const double turn = 2 * pi * lobe_random_unit(random), sv = sqrt(1 - s.v_z * s.v_z);
        s.l_z = fmin(1, s.v_z * cos(t) + sv * sin(t) * cos(turn));
        s.azimuth = fabs(atan2(sin(t) * sin(turn), -sv * cos(t) + s.v_z * sin(t) * cos(turn)));
    } else {
        const double low = -fmin(1, 1.5 / sqrt(s.sharpness));
        s.l_z = low + (1 - low) * lobe_random_unit(random);
        s.azimuth = pi * lobe_random_unit(random);
    }
    return s;
}

static void check(const lobe_sg_scene *s, double got, double want, double relative, double absolute)
{
    if (!(fabs(got - want) <= relative * want + absolute))
        fail_msg("alpha %.9g v %.9g l %.9g azimuth %.9g sharpness %.9g: %.12g and %.12g", s->alpha, s->v_z, s->l_z,
                 s->azimuth, s->sharpness, got, want);
}

static void two_integrators_agree(void **state)
{
    lobe_random random;
    int i;
    (void)state;
    lobe_random_seed(&random, 1, 0);
    for (i = 0; i < 600; i++) {
        const lobe_sg_scene s = any_scene(&random, i);
        check(&s, lobe_truth_sg_axis(&s, 1e-8), lobe_truth_sg_stretched(&s, 1e-8), 2e-7, 1e-15);
    }
}

static void the_sum_of_sphere_lights_agrees(void **state)
{
    lobe_random random;
    int i;
    (void)state;
    lobe_random_seed(&random, 2, 0);
    for (i = 0; i < 6; i++) {
        const lobe_sg_scene s = any_scene(&random, 1 + i % 3);
        check(&s, lobe_truth_sg_cones(&s, 1e-5), lobe_truth_sg_stretched(&s, 1e-7), 1e-5, 1e-12);
    }
}

/* Views and axes on the normal, along each other, on the horizon and opposite to each other. */
static void special_places_agree(void **state)
{
    static const double places[][3] = {{1, 1, 0},    {1, .5, 0},   {.5, 1, 0},      {.5, .5, 0},
                                       {.3, .3, pi}, {.3, 0, 2},   {.02, .02, pi},  {.2, -.2, pi},
                                       {1, -.05, 0}, {.6, -.1, 3}, {1e-3, .1, 3.1}, {.6, .6 - 1e-9, 0}};
    size_t i, k;
    (void)state;
    for (i = 0; i < sizeof places / sizeof places[0]; i++)
        for (k = 0; k < 12; k++) {
            static const double sharpnesses[] = {1, 4, 64, 4096};
            static const double alphas[] = {.0025, .05, 1};
            const lobe_sg_scene s = {alphas[k % 3], places[i][0], places[i][1], places[i][2], sharpnesses[k / 3]};
            check(&s, lobe_truth_sg_axis(&s, 1e-8), lobe_truth_sg_stretched(&s, 1e-8), 1e-6, 1e-15);
        }
}

/* A sharp light is a punctual one, to second order in its width; an even one gives the albedo, which is 1 - ln 2 at
 * alpha 1 and normal view. */
static void limits(void **state)
{
    const lobe_sg_scene sharp = {.5, .7, .6, 2.5, 65536}, sharper = {.5, .7, .6, 2.5, 4 * 65536};
    const lobe_sg_scene even = {1, 1, .3, 1, 1e-9};
    const double off = lobe_truth_sg_axis(&sharp, 1e-9) / lobe_truth_sg_punctual(&sharp) - 1;
    const double less = lobe_truth_sg_axis(&sharper, 1e-9) / lobe_truth_sg_punctual(&sharper) - 1;
    (void)state;
    assert_true(fabs(off) < 3e-4);
    assert_true(fabs(less - .25 * off) < .01 * fabs(off));
    assert_true(fabs(lobe_truth_sg_axis(&even, 1e-9) - (1 - log(2))) < 1e-8);
    assert_true(fabs(lobe_truth_sg_stretched(&even, 1e-9) - (1 - log(2))) < 1e-8);
}

/* Overhead the diffuse integral is elementary; and it falls as the axis sinks. */
static void irradiance(void **state)
{
    static const double sharpnesses[] = {.5, 4, 100, 4096};
    size_t i;
    (void)state;
    for (i = 0; i < 4; i++) {
        const double s = sharpnesses[i], want = 2 / s + 2 * expm1(-s) / (s * s);
        double last = want;
        int k;
        assert_true(fabs(lobe_truth_sg_irradiance(1, s, 1e-10) - want) < 1e-9 * want);
        for (k = 9; k >= -10; k--) {
            const double now = lobe_truth_sg_irradiance(.1 * k, s, 1e-8);
            assert_true(now <= last && now >= 0);
            last = now;
        }
    }
}

/* The published frame is 0/0 where the view stands on the normal; these are continuous there. */
static void peers_on_the_normal(void **state)
{
    const double on[5] = {.5, 1, .8, 1, 64}, beside[5] = {.5, 1 - 1e-12, .8, 1, 64};
    int i;
    (void)state;
    for (i = 1; i <= 3; i++) { /* behind the punctual light */
        const lobe_sg_candidate *peer = lobe_sg_candidate_at(i);
        assert_non_null(strstr(peer->name, "SG warp"));
        assert_true(peer->call(on) > 0 && peer->call(on) < 1);
        assert_true(fabs(peer->call(on) / peer->call(beside) - 1) < 1e-4);
    }
}

/* Simpson's rule in the cosine, which is not how they are fitted. */
static void judge_again(lobe_ndf kind, int count, double alpha, const lobe_ndf_fit *fit, double *error, double *sum)
{
    enum { STEPS = 40000 };
    double off = 0, square = 0;
    int i, k;
    *sum = 0;
    for (i = 1; i <= STEPS; i++) { /* both distributions times the cosine are 0 at its 0 */
        const double c = (double)i / STEPS, w = (i == STEPS ? 1 : i & 1 ? 4 : 2) / (3.0 * STEPS) * c;
        const double d = lobe_ndf_value(kind, alpha, c);
        double y = 0;
        for (k = 0; k < count; k++)
            y += fit->amplitude[k] / (pi * alpha * alpha) * exp(fit->sharpness[k] / (alpha * alpha) * (c - 1));
        off += w * (y - d) * (y - d);
        square += w * d * d;
        *sum += 2 * pi * w * y;
    }
    *error = sqrt(off / square);
}

/* What README.md says of normals as sums of Gaussians, at the worst alpha up to .5. */
static void normals_as_gaussians(void **state)
{
    static const double most[2][LOBE_NDF_MOST] = {{.151, .034, .0094, .003, .0011}, {.105, .041, .021, .023, .021}};
    lobe_ndf_fit fits[LOBE_NDF_ALPHAS];
    int kind, count, k;
    (void)state;
    for (kind = 0; kind < 2; kind++)
        for (count = 1; count <= LOBE_NDF_MOST; count++) {
            assert_true(lobe_ndf_fit_all((lobe_ndf)kind, count, fits));
            for (k = 0; k < LOBE_NDF_ALPHAS && lobe_ndf_alpha(k) <= .5; k++) {
                double error, sum;
                judge_again((lobe_ndf)kind, count, lobe_ndf_alpha(k), &fits[k], &error, &sum);
                assert_true(error < most[kind][count - 1]);
                if (!(fabs(error - fits[k].error) < .03 * error + 1e-5 && fabs(sum - fits[k].sum) < 1e-4))
                    fail_msg("%s, %d Gaussians, alpha %g: error %.6f and %.6f, sum %.6f and %.6f",
                             kind ? "Beckmann" : "GGX", count, lobe_ndf_alpha(k), fits[k].error, error, fits[k].sum,
                             sum);
            }
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_integrators_agree),
        cmocka_unit_test(the_sum_of_sphere_lights_agrees),
        cmocka_unit_test(special_places_agree),
        cmocka_unit_test(limits),
        cmocka_unit_test(irradiance),
        cmocka_unit_test(peers_on_the_normal),
        cmocka_unit_test(normals_as_gaussians),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
