/* The truth of capsule_light: a line of spheres converges to it, a point capsule is a sphere, and so is one that stands
 * end on; a longer capsule is never darker; what is out of the domain is refused. And the forms: what they tend to, and
 * that no input breaks them. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <math.h>
#include <string.h>
#include "../capsule_light/candidates.h"
#include "../capsule_light/truth_capsule.h"
#include "../fit/random.h"
#include "../sphere_light/truth_sphere.h"

static double length(const double *a) { return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); }

/* Around the mirror direction; a third near the horizon, a fifth nearly end on; alpha .05 to 1, half length .02 to 2.
 */
static lobe_capsule_scene scene_of(lobe_random *r, int i)
{
    lobe_capsule_scene s;
    do {
        double e[3], scale;
        int k;
        s.alpha = .05 * pow(20, lobe_random_unit(r));
        s.v_z = cos(1.5 * lobe_random_unit(r));
        s.f0 = i & 1 ? 1 : .04;
        for (k = 0; k < 3; k++) {
            s.middle[k] = lobe_random_unit(r) - .5;
            e[k] = lobe_random_unit(r) - .5;
        }
        s.middle[0] -= sqrt(1 - s.v_z * s.v_z);
        s.middle[2] = i % 3 == 0 ? .6 * s.middle[2] : s.v_z + s.middle[2];
        for (k = 0; k < 3 && i % 5 == 1; k++)
            e[k] = s.middle[k] + .2 * e[k];
        scale = .02 * pow(100, lobe_random_unit(r)) / length(e);
        for (k = 0; k < 3; k++)
            s.half[k] = e[k] * scale;
        s.radius = .02 * pow(25, lobe_random_unit(r));
    } while (lobe_capsule_refusal(&s));
    return s;
}

/* Spheres half a radius apart miss as the square of that; taking the square away leaves 4e-5. */
static void line_of_spheres_converges(void **state)
{
    lobe_random r;
    double coarse = 0, fine = 0, beyond = 0;
    int i, used = 0, through = 0, end_on = 0;
    (void)state;
    lobe_random_seed(&r, 51, 0);
    for (i = 0; i < 40; i++) {
        const lobe_capsule_scene s = scene_of(&r, i);
        const int spheres = 8 + (int)(4 * length(s.half) / s.radius);
        const double exact = lobe_truth_capsule(&s, 1e-6), few = lobe_truth_capsule_spheres(&s, 1e-6, spheres);
        const double many = lobe_truth_capsule_spheres(&s, 1e-6, 2 * spheres - 1);
        if (!(exact > 1e-8))
            continue;
        used++;
        through += s.middle[2] < fabs(s.half[2]) + s.radius;
        end_on += i % 5 == 1;
        coarse = fmax(coarse, fabs(few / exact - 1));
        fine = fmax(fine, fabs(many / exact - 1));
        beyond = fmax(beyond, fabs((4 * many - few) / 3 / exact - 1));
    }
    print_message(
        "# %d capsules, %d through the horizon, %d nearly end on: spheres half a radius apart miss %.1e, twice "
        "as many %.1e, extrapolated %.1e\n",
        used, through, end_on, coarse, fine, beyond);
    assert_true(used >= 30 && through >= 10 && end_on >= 5);
    assert_true(coarse > 1e-4 && fine < coarse / 3 && beyond <= 1e-4);
}

static lobe_sphere_scene sphere_of(const lobe_capsule_scene *s, const double p[3])
{
    const double d = length(p);
    const lobe_sphere_scene sphere = {s->alpha, s->v_z, p[2] / d, fabs(atan2(p[1], p[0])), asin(s->radius / d), s->f0};
    return sphere;
}

/* Against the other integrator of spheres; near: a length just too large for the capsule's own way out. */
static void short_is_a_sphere(void **state)
{
    static const double lengths[2] = {0, 1e-7};
    lobe_random r;
    double worst[2] = {0, 0};
    int i, k, j;
    (void)state;
    lobe_random_seed(&r, 52, 0);
    for (i = 0; i < 60; i++) {
        lobe_capsule_scene s = scene_of(&r, i);
        const double half = length(s.half);
        double exact;
        if (length(s.middle) < 1.001 * s.radius)
            continue;
        {
            const lobe_sphere_scene sphere = sphere_of(&s, s.middle);
            exact = lobe_truth_sphere_stretched(&sphere, 1e-7);
        }
        for (k = 0; k < 2; k++) {
            lobe_capsule_scene small = s;
            for (j = 0; j < 3; j++)
                small.half[j] *= lengths[k] / half;
            if (exact > 1e-8)
                worst[k] = fmax(worst[k], fabs(lobe_truth_capsule(&small, 1e-7) / exact - 1));
        }
    }
    print_message("# a capsule of no length is a sphere within %.1e, one of 2e-7 within %.1e\n", worst[0], worst[1]);
    assert_true(worst[0] <= 5e-6 && worst[1] <= 1e-5);
}

/* Inside the prolonged cylinder only the near end is seen; and nothing jumps where that begins. */
static void end_on_is_its_near_end(void **state)
{
    lobe_capsule_scene s = {.25, .8, 1, {-.7, .1, .9}, {-.35, .05, .45}, .1};
    const double near[3] = {-.35, .05, .45};
    const lobe_sphere_scene sphere = sphere_of(&s, near);
    const double exact = lobe_truth_sphere_stretched(&sphere, 1e-7);
    double inside, outside;
    (void)state;
    assert_true(fabs(lobe_truth_capsule(&s, 1e-7) / exact - 1) <= 5e-6);
    s.middle[1] += .1 * (1 - 1e-6) * sqrt(.7 * .7 + .1 * .1 + .9 * .9) / sqrt(.7 * .7 + .9 * .9);
    inside = lobe_truth_capsule(&s, 1e-7);
    s.middle[1] += 2e-7;
    outside = lobe_truth_capsule(&s, 1e-7);
    print_message("# end on: %.6f inside the prolonged cylinder, %.6f outside\n", inside, outside);
    assert_true(fabs(inside / outside - 1) <= 1e-4);
}

static void longer_is_never_darker(void **state)
{
    lobe_random r;
    int i, j, k;
    (void)state;
    lobe_random_seed(&r, 53, 0);
    for (i = 0; i < 20; i++) {
        lobe_capsule_scene s = scene_of(&r, i);
        const double half[3] = {s.half[0], s.half[1], s.half[2]};
        double before = 0;
        for (k = 0; k <= 5; k++) {
            double y;
            for (j = 0; j < 3; j++)
                s.half[j] = half[j] * .2 * k;
            if (lobe_capsule_refusal(&s))
                break;
            y = lobe_truth_capsule(&s, 1e-7);
            assert_true(y >= before * (1 - 1e-6) - 1e-12 && y <= 1 + 1e-7);
            before = y;
        }
    }
}

static void outside_the_domain_is_refused(void **state)
{
    const double inside[9] = {.5, .5, 0, 0, .1, 1, 0, 0, .2}, thin[9] = {.5, .5, 0, 0, 1, 0, 0, 0, 1e-5};
    const double set[9] = {.5, .5, 0, 0, -2, 1, 0, 0, .2}, good[9] = {.5, .5, 0, 0, 1, 0, 0, 0, .1};
    double y = 1;
    (void)state;
    assert_non_null(strstr(lobe_truth_capsule_row_refusal(inside), "inside"));
    assert_non_null(strstr(lobe_truth_capsule_row_refusal(thin), "1e-4"));
    assert_null(lobe_truth_capsule_row_refusal(good));
    assert_null(lobe_truth_capsule_row_refusal(set));
    lobe_truth_capsule_rows(set, &y, 1);
    assert_true(y == 0);
    lobe_truth_capsule_rows(inside, &y, 1);
    assert_true(isnan(y));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(line_of_spheres_converges),     cmocka_unit_test(short_is_a_sphere),
        cmocka_unit_test(end_on_is_its_near_end),        cmocka_unit_test(longer_is_never_darker),
        cmocka_unit_test(outside_the_domain_is_refused),
    };
    return cmocka_run_group_tests_name("capsule_light truth", tests, NULL, NULL);
}
