/* The public helpers: f32 has the bits of the kernels, which test_apply.c holds to their formulas; the integer
 * versions stay within a stated distance of those formulas in double; and energy with compensation passes the
 * furnace. */
#include "../../models/compensation.h"
#include "../../models/lobe.h"
#include "../../models/reflectance.h"
#include "../../models/roughness.h"
#include "cmocka_first.h"
#include <math.h>

#define UNIT 0x1p-30

static double real(int32_t q30) { return q30 * UNIT; }
static double real29(int32_t q29) { return q29 * 2.0 * UNIT; }
static int32_t q30(double x) { return (int32_t)floor(x / UNIT + 0.5); }

static const int32_t bad[] = {INT32_MIN, -LOBE_ONE_Q30, -1, 0, 1, LOBE_ONE_Q30, LOBE_ONE_Q30 + 1, INT32_MAX};
enum { BAD = sizeof bad / sizeof bad[0], STEPS = 4096 };

static void f32_is_the_kernel(void **state)
{
    static const float in[] = {-1.0f, 0.0f, 0.01f, 0.25f, 0.7f, 1.0f, 3.0f, INFINITY, -INFINITY, NAN};
    size_t i, k;
    (void)state;
    for (i = 0; i < sizeof in / sizeof in[0]; i++) {
        const float x = in[i];
        assert_true(lobe_alpha_of_roughness_f32(x) == lobe_alpha_of_roughness(x));
        assert_true(lobe_roughness_of_alpha_f32(x) == lobe_roughness_of_alpha(x));
        assert_true(lobe_roughness_of_smoothness_f32(x) == lobe_roughness_of_smoothness(x));
        assert_true(lobe_roughness_of_gloss_f32(x) == lobe_roughness_of_gloss(x));
        assert_true(lobe_gloss_of_roughness_f32(x) == lobe_gloss_of_roughness(x));
        assert_true(lobe_roughness_of_phong_f32(x) == lobe_roughness_of_phong(x));
        assert_true(lobe_phong_of_roughness_f32(x) == lobe_phong_of_roughness(x));
        assert_true(lobe_f90_of_f0_f32(x) == lobe_f90_of_f0(x));
        assert_true(lobe_inverse_energy_alpha2_f32(x) == lobe_inverse_energy_alpha2(x));
        for (k = 0; k < sizeof in / sizeof in[0]; k++) {
            const lobe_dfg_f32 public_terms = {0.7f, 0.2f};
            lobe_dfg terms;
            terms.scale = 0.7f;
            terms.bias = 0.2f;
            assert_true(lobe_reflectance_f32(public_terms, x, in[k]) == lobe_reflectance(terms, x, in[k]));
            assert_true(lobe_compensation_f32(x, in[k]) == lobe_compensation(x, in[k]));
            assert_true(lobe_inverse_energy_alpha2_view_f32(x, in[k]) == lobe_inverse_energy_alpha2_view(x, in[k]));
        }
    }
}

static void q30_roughness(void **state)
{
    int i;
    (void)state;
    for (i = 0; i <= STEPS; i++) {
        const int32_t q = q30((double)i / STEPS);
        const double x = real(q);
        assert_true(fabs(real(lobe_alpha_of_roughness_q30(q)) - x * x) <= 0.5001 * UNIT);
        assert_true(fabs(real(lobe_roughness_of_alpha_q30(q)) - sqrt(x)) <= 0.5001 * UNIT);
        assert_true(real(lobe_roughness_of_smoothness_q30(q)) == 1.0 - x);
        assert_true(fabs(real(lobe_roughness_of_gloss_q30(q)) - (1.0 - x) * (1.0 - x)) <= 0.5001 * UNIT);
        assert_true(fabs(real(lobe_gloss_of_roughness_q30(q)) - (1.0 - sqrt(x))) <= 0.5001 * UNIT);
    }
    for (i = 0; i < BAD; i++) {
        const int32_t all[] = {lobe_alpha_of_roughness_q30(bad[i]), lobe_roughness_of_alpha_q30(bad[i]),
                               lobe_roughness_of_smoothness_q30(bad[i]), lobe_roughness_of_gloss_q30(bad[i]),
                               lobe_gloss_of_roughness_q30(bad[i])};
        size_t k;
        for (k = 0; k < sizeof all / sizeof all[0]; k++)
            assert_true(all[k] >= 0 && all[k] <= LOBE_ONE_Q30);
    }
}

static void q30_phong(void **state)
{
    double n;
    int i;
    (void)state;
    for (n = 0.0; n < 32765.0; n = n * 1.01 + 0.01) {
        const int32_t q16 = (int32_t)(n * 65536.0);
        const double exact = q16 / 65536.0, want = sqrt(sqrt(2.0 / (exact + 2.0)));
        const int32_t r = lobe_roughness_of_phong_q30(q16);
        assert_true(fabs(real(r) - want) <= 0x1p-22);
        if (want > 0.0885)
            assert_true(fabs(lobe_phong_of_roughness_q16(r) / 65536.0 - exact) <= (exact + 2.0) * 0x1p-12);
    }
    for (i = 0; i < BAD; i++) {
        assert_true(lobe_roughness_of_phong_q30(bad[i]) > 0 && lobe_roughness_of_phong_q30(bad[i]) <= LOBE_ONE_Q30);
        assert_true(lobe_phong_of_roughness_q16(bad[i]) >= 0);
    }
    assert_true(lobe_phong_of_roughness_q16(LOBE_ONE_Q30) == 0);
    assert_true(lobe_phong_of_roughness_q16(0) == INT32_MAX);
}

static void q30_reflectance(void **state)
{
    int i, k;
    (void)state;
    for (i = 0; i <= 64; i++) {
        for (k = 0; k <= 64; k++) {
            const lobe_dfg_q30 d = {q30(0.63), q30(0.31)};
            const int32_t f0 = q30(i / 64.0), f90 = q30(k / 64.0);
            const double want = real(f0) * real(d.scale) + real(f90) * real(d.bias);
            assert_true(fabs(real(lobe_reflectance_q30(d, f0, f90)) - want) <= 1.0001 * UNIT);
        }
        assert_true(real(lobe_f90_of_f0_q30(q30(i / 1024.0))) == fmin(1.0, 50.0 * real(q30(i / 1024.0))));
    }
    for (i = 0; i < BAD; i++) {
        for (k = 0; k < BAD; k++) {
            const lobe_dfg_q30 d = {bad[BAD - 1 - i], bad[k]};
            const int32_t got = lobe_reflectance_q30(d, bad[i], bad[k]);
            assert_true(got >= 0 && got <= LOBE_ONE_Q30);
        }
        assert_true(lobe_f90_of_f0_q30(bad[i]) >= 0 && lobe_f90_of_f0_q30(bad[i]) <= LOBE_ONE_Q30);
    }
    assert_true(lobe_f90_of_f0_q30(LOBE_ONE_Q30) == LOBE_ONE_Q30);
}

static void q29_compensation(void **state)
{
    int i, k;
    (void)state;
    for (i = 0; i <= 64; i++) {
        for (k = 0; k <= 64; k++) {
            const int32_t f0 = q30(i / 64.0), inverse = (int32_t)((1.0 + 2.9 * k / 64.0) / UNIT / 2.0);
            const int32_t r = q30(i / 64.0), v = q30(k / 64.0);
            const double want = 1.0 + real(f0) * (real29(inverse) - 1.0);
            assert_true(fabs(real29(lobe_compensation_q29(f0, inverse)) - want) <= 1.0001 * UNIT);
            assert_true(fabs(real29(lobe_inverse_energy_alpha2_view_q29(r, v)) - 1.0 -
                             2.0 * pow(real(r), 4) * real(v)) <= 6.0 * UNIT);
            assert_true(fabs(real29(lobe_inverse_energy_alpha2_q29(r)) - 1.0 - pow(real(r), 4)) <= 4.0 * UNIT);
        }
    }
    for (i = 0; i < BAD; i++)
        for (k = 0; k < BAD; k++) {
            assert_true(lobe_compensation_q29(bad[i], bad[k]) >= 1 << 29);
            assert_true(lobe_inverse_energy_alpha2_view_q29(bad[i], bad[k]) >= 1 << 29);
        }
}

/* E times the factor for a white metal is 1: the rounding of one division in f32; in integers E, whose unit weighs
 * 1 / E^2 in the reciprocal. What E itself is worth is the vectors' business. */
static void white_furnace(void **state)
{
    typedef float energy_f32(float, float);
    typedef int32_t energy_int(int32_t, int32_t);
    static energy_f32 *const e_f32[] = {lobe_energy_low_f32, lobe_energy_medium_f32, lobe_energy_high_f32};
    static energy_f32 *const inverse_f32[] = {lobe_energy_inverse_low_f32, lobe_energy_inverse_medium_f32,
                                              lobe_energy_inverse_high_f32};
    static energy_int *const e_q30[] = {lobe_energy_low_q30, lobe_energy_medium_q30, lobe_energy_high_q30};
    static energy_int *const inverse_q29[] = {lobe_energy_inverse_low_q29, lobe_energy_inverse_medium_q29,
                                              lobe_energy_inverse_high_q29};
    int t, i, k;
    (void)state;
    for (t = 0; t < 3; t++) {
        for (i = 0; i <= 64; i++) {
            for (k = 0; k <= 64; k++) {
                const float r = (float)i / 64.0f, v = (float)k / 64.0f, inverse = inverse_f32[t](r, v);
                const int32_t rq = q30((double)r), vq = q30((double)v), eq = e_q30[t](rq, vq);
                /* low dips under 1 by its own error, where E is held at 1 */
                const float floor1 = inverse < 1.0f ? 1.0f : inverse;
                assert_true(fabsf(e_f32[t](r, v) * lobe_compensation_f32(1.0f, floor1) - 1.0f) <= 2.4e-7f);
                assert_true(lobe_compensation_f32(0.0f, inverse) == 1.0f);
                assert_true(fabs(real(eq) * real29(inverse_q29[t](rq, vq)) - 1.0) <= 4.0 * UNIT);
                assert_true(fabs(real(eq) - (double)e_f32[t](r, v)) <= (t == 2 ? 4e-6 : 1e-6));
            }
        }
        assert_true(inverse_f32[t](0.0f, 0.0f) == 1.0f && e_f32[t](0.0f, 0.0f) == 1.0f);
        assert_true(inverse_f32[t](NAN, NAN) == 1.0f && inverse_f32[t](INFINITY, 0.0f) == 1.0f);
        assert_true(inverse_q29[t](0, 0) == 1 << 29);
        for (i = 0; i < BAD; i++)
            for (k = 0; k < BAD; k++)
                assert_true(inverse_q29[t](bad[i], bad[k]) >= 1 << 29);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(f32_is_the_kernel), cmocka_unit_test(q30_roughness),    cmocka_unit_test(q30_phong),
        cmocka_unit_test(q30_reflectance),   cmocka_unit_test(q29_compensation), cmocka_unit_test(white_furnace),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
