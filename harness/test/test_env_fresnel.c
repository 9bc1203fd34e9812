/* Fresnel on taps of environment lobes: parts sum to the bias, f32 and q30 against the same formula in double, what
 * looks to the horizon has more, bad numbers are finite. How near that comes to the truth is judged by radiance
 * (cases/env_lobes/fresnel.csv). */
#define LOBE_DOUBLE 1
#include "../../models/env_fresnel.h"
#include "../../models/lobe.h"
#include "cmocka_first.h"
#include <math.h>

enum { TAPS = 8, STEPS = 120 };

typedef struct point {
    int n;
    float bias, cosine[TAPS], got[TAPS];
    lobe_env_tap_f32 tap[TAPS];
    int32_t bias_q30, cosine_q30[TAPS], got_q16[TAPS];
    lobe_env_tap_q30 tap_q30[TAPS];
} point;

static int32_t q30(double x) { return (int32_t)lrint(fmin(1.9, x) * 0x1p30); }

static point point_of(int tier, double r, double v)
{
    static void (*const f32[4])(float, float, lobe_env_tap_f32 *) = {lobe_env_lobes1_f32, lobe_env_lobes2_f32,
                                                                     lobe_env_lobes4_f32, lobe_env_lobes8_f32};
    static void (*const fixed[4])(int32_t, int32_t, lobe_env_tap_q30 *) = {lobe_env_lobes1_q30, lobe_env_lobes2_q30,
                                                                           lobe_env_lobes4_q30, lobe_env_lobes8_q30};
    point p;
    int i;
    p.n = 1 << tier;
    p.bias = lobe_split_sum_high_f32((float)r, (float)v).bias;
    p.bias_q30 = lobe_split_sum_high_q30(q30(r), q30(v)).bias;
    f32[tier]((float)r, (float)v, p.tap);
    fixed[tier](q30(r), q30(v), p.tap_q30);
    for (i = 0; i < p.n; i++) {
        p.cosine[i] = (float)cos(acos(v) + (double)p.tap[i].angle);
        p.cosine_q30[i] = q30(cos(acos(v) + p.tap_q30[i].angle * 0x1p-30));
    }
    lobe_env_fresnel_f32(p.tap, p.cosine, (size_t)p.n, p.bias, p.got);
    lobe_env_fresnel_q30(p.tap_q30, p.cosine_q30, (size_t)p.n, p.bias_q30, p.got_q16);
    return p;
}

/* The kernels in double on the taps of a format: rows of cosine, width and weight. */
static void in_double(double row[][3], int n, double bias, double *want)
{
    double sum = 0, grazing = 0;
    int i;
    for (i = 0; i < n; i++) {
        want[i] = lobe_env_grazing(row[i][0], row[i][1]);
        sum += row[i][2];
        grazing += row[i][2] * want[i];
    }
    for (i = 0; i < n; i++)
        want[i] = lobe_env_bias(row[i][2], want[i], grazing / sum, bias / sum);
}

/* Towards n_dot_v = 0 view and tap are opposite, and the half vector's cosine is a root of next to nothing. */
static void parts_are_the_formula_and_sum_to_the_bias(void **state)
{
    double worst[2][2] = {{0}};
    int k, i;
    (void)state;
    for (k = 0; k < 4 * STEPS * STEPS; k++) {
        const double r = (k / 4 % STEPS) / (STEPS - 1.0), v = (k / 4 / STEPS) / (STEPS - 1.0);
        const point p = point_of(k % 4, r, v);
        const int low = v < 0.02;
        double row[2][TAPS][3], want[2][TAPS], sum = 0;
        int32_t rest = (p.bias_q30 + (1 << 13)) >> 14;
        for (i = 0; i < p.n; i++) {
            row[0][i][0] = (double)p.cosine[i];
            row[0][i][1] = (double)p.tap[i].width;
            row[0][i][2] = (double)p.tap[i].weight;
            row[1][i][0] = p.cosine_q30[i] * 0x1p-30;
            row[1][i][1] = p.tap_q30[i].width * 0x1p-30;
            row[1][i][2] = p.tap_q30[i].weight_q16 * 0x1p-16;
        }
        in_double(row[0], p.n, (double)p.bias, want[0]);
        in_double(row[1], p.n, p.bias_q30 * 0x1p-30, want[1]);
        for (i = 0; i < p.n; i++) {
            sum += (double)p.got[i];
            rest -= p.got_q16[i];
            worst[low][0] = fmax(worst[low][0], fabs((double)p.got[i] - want[0][i]));
            worst[low][1] = fmax(worst[low][1], fabs(p.got_q16[i] * 0x1p-16 - want[1][i]));
        }
        assert_true(fabs(sum - (double)p.bias) <= 4e-6);
        assert_true(rest >= -1 && rest <= 1);
    }
    for (i = 0; i < 2; i++)
        print_message("# n_dot_v %s .02: f32 within %.2g of the formula, q30 within %.2g\n", i ? "below" : "from",
                      worst[i][0], worst[i][1]);
    assert_true(worst[0][0] <= 4e-5 && worst[1][0] <= 4e-3 && worst[0][1] <= 0x1p-14 && worst[1][1] <= 0x1p-9);
}

/* Equal weights and widths: the parts order as the angles do, and one tap has all. */
static void the_horizon_has_more(void **state)
{
    const lobe_env_tap_f32 tap[3] = {{0.5f, 0.3f, 0.25f}, {0.8f, 0.3f, 0.25f}, {1.1f, 0.3f, 0.25f}};
    const float cosine[3] = {0.3f, 0.0f, -0.3f}, bias = 0.1f;
    float part[3];
    (void)state;
    lobe_env_fresnel_f32(tap, cosine, 3, bias, part);
    assert_true(part[0] < part[1] && part[1] < part[2]);
    lobe_env_fresnel_f32(tap, cosine, 1, bias, part);
    assert_true(fabs((double)part[0] - 0.1) <= 1e-8);
    assert_true(lobe_env_grazing(1.0, 0.0) == 0.0 && lobe_env_grazing(-1.0, 0.0) == 1.0);
}

static void bad_numbers_are_finite(void **state)
{
    static const float bad[] = {NAN, INFINITY, -INFINITY, -5.0f, 3e38f};
    static const int32_t bad_q30[] = {INT32_MIN, INT32_MAX, 0, -1, 1 << 30};
    int i, k;
    (void)state;
    for (i = 0; i < 5; i++)
        for (k = 0; k < 5; k++) {
            const lobe_env_tap_f32 tap[2] = {{0.5f, bad[i], 0.5f}, {0.5f, 0.5f, 0.3f}};
            const lobe_env_tap_q30 fixed[2] = {{0, bad_q30[i], bad_q30[k]}, {0, 1 << 29, bad_q30[4 - i]}};
            const float cosine[2] = {bad[k], 0.5f};
            const int32_t cosine_q30[2] = {bad_q30[k], 1 << 29};
            float part[2];
            int32_t part_q16[2];
            lobe_env_fresnel_f32(tap, cosine, 2, bad[4 - k], part);
            assert_true(fabsf(part[0]) <= 2.0f && fabsf(part[1]) <= 2.0f);
            lobe_env_fresnel_q30(fixed, cosine_q30, 2, bad_q30[k], part_q16); /* under the sanitizers: no overflow */
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts_are_the_formula_and_sum_to_the_bias),
        cmocka_unit_test(the_horizon_has_more),
        cmocka_unit_test(bad_numbers_are_finite),
    };
    return cmocka_run_group_tests_name("Fresnel on environment lobes", tests, NULL, NULL);
}
