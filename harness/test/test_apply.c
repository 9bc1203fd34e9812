/* What a renderer does with the terms: reflectance, compensation and roughness conventions, against their formulas
 * in double, and at every bad number. */
#include "../../models/compensation.h"
#include "../../models/reflectance.h"
#include "../../models/roughness.h"
#include "cmocka_first.h"
#include <math.h>

static const float bad[] = {-1.0f, -0.0f, 1e-45f, 3.4e38f, -3.4e38f, INFINITY, -INFINITY, NAN};
enum { BAD = sizeof bad / sizeof bad[0] };

static lobe_dfg terms(float scale, float bias)
{
    lobe_dfg d;
    d.scale = scale;
    d.bias = bias;
    return d;
}

static void reflectance(void **state)
{
    int i, k;
    (void)state;
    for (i = 0; i <= 32; i++) {
        for (k = 0; k <= 32; k++) {
            const double f0 = i / 32.0, f90 = k / 32.0, want = f0 * 0.75 + f90 * 0.125;
            const float got = lobe_reflectance(terms(0.75f, 0.125f), (float)f0, (float)f90);
            assert_true(fabs((double)got - want) <= 1e-7);
        }
    }
    for (i = 0; i < BAD; i++) {
        for (k = 0; k < BAD; k++) {
            const float got = lobe_reflectance(terms(0.75f, 0.25f), bad[i], bad[k]);
            assert_true(got >= 0.0f && got <= 1.0f);
        }
    }
    assert_true(lobe_reflectance(terms(0.75f, 0.25f), NAN, 1.0f) == 0.25f);
}

/* Hoffman: below 2 % the grazing reflectance fades with f0, above it is 1. */
static void two_percent_rule(void **state)
{
    (void)state;
    assert_true(lobe_f90_of_f0(0.0f) == 0.0f);
    assert_true(fabsf(lobe_f90_of_f0(0.01f) - 0.5f) <= 1e-7f);
    assert_true(lobe_f90_of_f0(0.02f) == 1.0f);
    assert_true(lobe_f90_of_f0(1.0f) == 1.0f);
    assert_true(lobe_f90_of_f0(NAN) == 0.0f);
    assert_true(lobe_f90_of_f0(-1.0f) == 0.0f);
    assert_true(lobe_f90_of_f0(INFINITY) == 1.0f);
}

/* White furnace: a white metal with the factor 1/E gives back all light, whatever E is. */
static void furnace(void **state)
{
    int i;
    (void)state;
    for (i = 1024 / 4; i <= 1024; i++) {
        const float e = (float)i / 1024.0f;
        assert_true(fabsf(e * lobe_compensation(1.0f, 1.0f / e) - 1.0f) <= 2.4e-7f);
        assert_true(lobe_compensation(0.0f, 1.0f / e) == 1.0f);
    }
    assert_true(fabsf(lobe_compensation(0.5f, 2.0f) - 1.5f) <= 1e-7f);
    for (i = 0; i < BAD; i++) {
        const float factor = lobe_compensation(bad[i], bad[BAD - 1 - i]);
        assert_true(factor >= 1.0f && factor <= 4.0f);
    }
}

static void published_factors(void **state)
{
    int i, k;
    (void)state;
    for (i = 0; i <= 16; i++) {
        const double a = i / 16.0 * (i / 16.0);
        assert_true(fabs((double)lobe_inverse_energy_alpha2((float)i / 16.0f) - (1.0 + a * a)) <= 2.4e-7);
        for (k = 0; k <= 16; k++)
            assert_true(fabs((double)lobe_inverse_energy_alpha2_view((float)i / 16.0f, (float)k / 16.0f) -
                             (1.0 + 2.0 * a * a * k / 16.0)) <= 4.8e-7);
    }
    for (i = 0; i < BAD; i++) {
        const float factor = lobe_inverse_energy_alpha2_view(bad[i], bad[BAD - 1 - i]);
        assert_true(factor >= 1.0f && factor <= 3.0f);
    }
}

/* There and back. The tolerance is a relative 2^-20: two square roots and two products. */
static void conventions(void **state)
{
    int i;
    (void)state;
    for (i = 1; i <= 256; i++) {
        const float r = (float)i / 256.0f;
        assert_true(fabsf(lobe_roughness_of_alpha(lobe_alpha_of_roughness(r)) - r) <= r * 0x1p-20f);
        assert_true(fabsf(lobe_roughness_of_smoothness(1.0f - r) - r) <= 0x1p-24f);
        assert_true(fabsf(lobe_roughness_of_gloss(lobe_gloss_of_roughness(r)) - r) <= 0x1p-20f);
        if (r > 0.0067f)
            assert_true(fabsf(lobe_roughness_of_phong(lobe_phong_of_roughness(r)) - r) <= r * 0x1p-18f);
    }
    assert_true(lobe_alpha_of_roughness(0.5f) == 0.25f);
    assert_true(fabsf(lobe_roughness_of_phong(0.0f) - 1.0f) <= 0x1p-22f);  /* alpha = 1 */
    assert_true(fabsf(lobe_roughness_of_phong(30.0f) - 0.5f) <= 0x1p-22f); /* alpha = 1/4 */
    assert_true(fabsf(lobe_roughness_of_gloss(0.5f) - 0.25f) <= 0x1p-24f); /* alpha = (1 - gloss)^4 */
    for (i = 0; i < BAD; i++) {
        const float x = bad[i];
        const float in_unit[] = {lobe_alpha_of_roughness(x),      lobe_roughness_of_alpha(x),
                                 lobe_roughness_of_smoothness(x), lobe_roughness_of_gloss(x),
                                 lobe_gloss_of_roughness(x),      lobe_roughness_of_phong(x)};
        size_t k;
        for (k = 0; k < sizeof in_unit / sizeof in_unit[0]; k++)
            if (!(in_unit[k] >= 0.0f && in_unit[k] <= 1.0f))
                fail_msg("conversion %zu of %g gives %g", k, (double)x, (double)in_unit[k]);
        assert_true(isfinite(lobe_phong_of_roughness(x)));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reflectance),       cmocka_unit_test(two_percent_rule), cmocka_unit_test(furnace),
        cmocka_unit_test(published_factors), cmocka_unit_test(conventions),
    };
    return cmocka_run_group_tests_name("apply", tests, NULL, NULL);
}
