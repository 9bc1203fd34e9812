/* Sphere lights in fixed point against the same formula in double, at exactly the numbers that the integers stand for.
 * Errors are parts of the peak: the largest value over the light positions of one roughness, view and half angle.
 *
 * The formula has the coefficients that ship, which are floats, and no guards against a division by 0 (1e-18, 1e-36):
 * those are for float, and at low roughness and grazing views they are larger than what they guard. */
#include "../../models/lobe.h"
#include "cmocka_first.h"
#include <math.h>

#define LOBE_DOUBLE
#include "../../core/dialect.h"
#undef LOBE_R
#define LOBE_R(x) (x##f > 0.0f && x##f < 1e-15f ? 1e-300 : (double)x##f)
#include "../../models/sphere_light_high.h"

typedef struct tier {
    const char *name;
    lobe_scaled_q30 (*q30)(int32_t roughness, lobe_sphere_q30 light);
    double (*formula)(double roughness, lobe_sphere light);
    double of_peak;  /* promised over the domain and to 90 degrees; the project's floor is 2^-16 */
    double relative; /* to the value, where that is a hundredth of the peak and more */
    int is_part;     /* of a light of radiance 1, so at most 1 */
} tier;

static const tier tiers[] = {
    {"high", lobe_sphere_light_high_q30, lobe_sphere_light_high, 0x1p-20, 0x1p-16, 1},
    {"medium", lobe_sphere_light_medium_q30, lobe_sphere_light_medium, 0x1p-21, 0x1p-16, 1},
    {"low", lobe_sphere_light_low_q30, lobe_sphere_light_low, 0x1p-21, 0x1p-16, 1},
    {"punctual", lobe_sphere_light_punctual_q30, lobe_sphere_light_punctual, 0x1p-24, 0x1p-24, 0},
};
enum { TIERS = sizeof tiers / sizeof tiers[0], POSITIONS = 256 };

static const double pi = 3.14159265358979323846, degree = 3.14159265358979323846 / 180;
static uint64_t random_state;

static uint32_t random_bits(void)
{
    random_state = random_state * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)(random_state >> 32);
}

static double unit(void) { return random_bits() * 0x1p-32; }

/* From lo to hi, uniform in the logarithm, often an end. */
static double between(double lo, double hi)
{
    const uint32_t end = random_bits() % 8;
    return end == 0 ? lo : end == 1 ? hi : lo * pow(hi / lo, unit());
}

static int32_t fixed(double x) { return (int32_t)lrint(x * LOBE_ONE_Q30); }

static double real(int32_t x) { return x * 0x1p-30; }

static double value(lobe_scaled_q30 y) { return ldexp(y.mantissa, y.exponent - 30); }

static double formula(const tier *t, int32_t roughness, lobe_sphere_q30 s)
{
    return t->formula(real(roughness),
                      lobe_sphere_of(real(s.n_dot_v), real(s.n_dot_l), real(s.tangent2), real(s.sine)));
}

/* A third anywhere, down to where the light has set; a third about the mirror, as wide as light and lobe; a third in
 * its neighbourhood of every size, and the mirror itself. */
static lobe_sphere_q30 place(int i, double v, double half_angle, double alpha)
{
    const double s = sqrt(1.0 - v * v), turn = 2.0 * pi * unit();
    const double wide = i % 3 == 1 ? unit() * fmin(pi / 2, half_angle + 3.0 * alpha)
                        : i == 2   ? 0.0
                                   : pow(10.0, -6 * unit());
    double x = -s * cos(wide) + v * sin(wide) * cos(turn), y = sin(wide) * sin(turn);
    double z = v * cos(wide) + s * sin(wide) * cos(turn);
    lobe_sphere_q30 light;
    if (i % 3 == 0) {
        z = (1.0 + sin(half_angle)) * unit() - sin(half_angle);
        x = sqrt(1.0 - z * z) * cos(turn);
        y = sqrt(1.0 - z * z) * sin(turn);
    }
    light.n_dot_v = fixed(v);
    light.n_dot_l = fixed(z);
    light.tangent2 = fixed(((x + s) * (x + s) + y * y) / 4.0);
    light.sine = fixed(sin(half_angle));
    return light;
}

static void compare(const tier *t, double roughness, double v, double half_angle)
{
    const int32_t r = fixed(roughness);
    lobe_sphere_q30 light[POSITIONS];
    double want[POSITIONS], peak = 0.0;
    int i;
    for (i = 0; i < POSITIONS; i++) {
        light[i] = place(i, v, half_angle, roughness * roughness);
        want[i] = formula(t, r, light[i]);
        peak = fmax(peak, want[i]);
    }
    for (i = 0; i < POSITIONS; i++) {
        const double error = fabs(value(t->q30(r, light[i])) - want[i]);
        if (!(error <= t->of_peak * peak && (want[i] < 0.01 * peak || error <= t->relative * want[i])))
            fail_msg("%s at %.6f, %.6f %.6f %.3g, %.5f degrees: want %.9g, %.3g off, 2^%.1f of the peak", t->name,
                     roughness, v, real(light[i].n_dot_l), real(light[i].tangent2), half_angle / degree, want[i], error,
                     log2(error / peak));
    }
}

/* 800 * 256 inputs a tier. */
static void near_the_formula(void **state)
{
    int i, k;
    (void)state;
    for (k = 0; k < TIERS; k++)
        for (random_state = 1, i = 0; i < 800; i++)
            compare(&tiers[k], between(0.22, 1.0), between(0.08, 1.0), between(0.01 * degree, 45 * degree));
}

static void wide_lights(void **state)
{
    int i, k;
    (void)state;
    for (k = 0; k < TIERS; k++)
        for (random_state = 2, i = 0; i < 400; i++)
            compare(&tiers[k], between(0.22, 1.0), between(0.08, 1.0), between(45 * degree, 90 * degree));
}

/* Smoother surfaces and lower views than the domain has, by the floor alone. */
static void beyond_the_domain(void **state)
{
    int i, k;
    (void)state;
    for (k = 0; k < TIERS; k++) {
        tier t = tiers[k];
        t.of_peak = 0x1p-16;
        t.relative = 0x1p-12;
        for (random_state = 8, i = 0; i < 400; i++)
            compare(&t, between(0.05, 1.0), between(0.02, 1.0), between(0.01 * degree, 90 * degree));
    }
}

/* The relative error is what noise would show in. */
static void small_lights(void **state)
{
    int i, k;
    (void)state;
    for (k = 0; k < TIERS; k++)
        for (random_state = 3, i = 0; i < 400; i++)
            compare(&tiers[k], between(0.22, 1.0), between(0.08, 1.0), between(0.003 * degree, 1 * degree));
}

/* A hundredth of a degree is a point, wherever it stands above the horizon. */
static void small_lights_are_punctual(void **state)
{
    int i, k, p;
    (void)state;
    for (k = 0; k < TIERS; k++) {
        if (!tiers[k].is_part)
            continue;
        for (random_state = 4, i = 0; i < 300; i++) {
            const double roughness = between(0.22, 1.0), v = between(0.08, 1.0);
            for (p = 0; p < POSITIONS; p++) {
                const lobe_sphere_q30 light = place(p, v, 0.01 * degree, roughness * roughness);
                const double point = value(lobe_sphere_light_punctual_q30(fixed(roughness), light));
                const double got = value(tiers[k].q30(fixed(roughness), light));
                if (light.n_dot_l >= fixed(0.01) && !(fabs(got - point) <= 1e-3 * point))
                    fail_msg("%s at %.6f, %.6f %.6f %.3g: %.9g, a point is %.9g", tiers[k].name, roughness, v,
                             real(light.n_dot_l), real(light.tangent2), got, point);
            }
        }
    }
}

/* Numbers of every size, and often the ends. */
static int32_t random_int(void)
{
    static const int32_t ends[] = {INT32_MIN,        INT32_MIN + 1, -LOBE_ONE_Q30, -1,       0, 1,
                                   LOBE_ONE_Q30 - 1, LOBE_ONE_Q30,  INT32_MAX - 1, INT32_MAX};
    const uint32_t r = random_bits();
    return r % 3 == 0 ? ends[(r >> 8) % 10] : (int32_t)random_bits() / (int32_t)(1u << (r >> 8) % 31);
}

static void assert_normal(const tier *t, lobe_scaled_q30 y)
{
    if (y.mantissa == 0)
        assert_int_equal(y.exponent, 0);
    else
        assert_in_range(y.mantissa, 1 << 29, 1 << 30);
    if (t->is_part)
        assert_in_range(lobe_scaled_to_q30(y), 0, LOBE_ONE_Q30);
}

/* Under the sanitizers this is the test that nothing overflows (test_sanitize.sh). */
static void anything_is_finite(void **state)
{
    int i, k;
    (void)state;
    random_state = 5;
    for (i = 0; i < 200000; i++) {
        const int32_t roughness = random_int();
        lobe_sphere_q30 light;
        light.n_dot_v = random_int();
        light.n_dot_l = random_int();
        light.tangent2 = random_int();
        light.sine = random_int();
        for (k = 0; k < TIERS; k++)
            assert_normal(&tiers[k], tiers[k].q30(roughness, light));
    }
}

static void same(const tier *t, int32_t roughness, lobe_sphere_q30 a, int32_t other, lobe_sphere_q30 b)
{
    const lobe_scaled_q30 x = t->q30(roughness, a), y = t->q30(other, b);
    if (x.mantissa != y.mantissa || x.exponent != y.exponent)
        fail_msg("%s: %d 2^%d, clamped %d 2^%d", t->name, (int)x.mantissa, (int)x.exponent, (int)y.mantissa,
                 (int)y.exponent);
}

/* What lies outside counts as the end. */
static void inputs_are_clamped(void **state)
{
    const lobe_sphere_q30 middle = {LOBE_ONE_Q30 / 2, LOBE_ONE_Q30 / 3, LOBE_ONE_Q30 / 4, LOBE_ONE_Q30 / 8};
    int k;
    (void)state;
    for (k = 0; k < TIERS; k++) {
        const tier *t = &tiers[k];
        lobe_sphere_q30 a = middle, b = middle;
        same(t, INT32_MIN, a, 0, b);
        same(t, INT32_MAX, a, LOBE_ONE_Q30, b);
        a.n_dot_v = INT32_MIN, b.n_dot_v = 0;
        same(t, LOBE_ONE_Q30 / 2, a, LOBE_ONE_Q30 / 2, b);
        a.n_dot_v = INT32_MAX, b.n_dot_v = LOBE_ONE_Q30;
        same(t, LOBE_ONE_Q30 / 2, a, LOBE_ONE_Q30 / 2, b);
        a.n_dot_l = INT32_MIN, b.n_dot_l = -LOBE_ONE_Q30;
        same(t, LOBE_ONE_Q30 / 2, a, LOBE_ONE_Q30 / 2, b);
        a.n_dot_l = INT32_MAX, b.n_dot_l = LOBE_ONE_Q30;
        same(t, LOBE_ONE_Q30 / 2, a, LOBE_ONE_Q30 / 2, b);
        a.tangent2 = INT32_MIN, b.tangent2 = 0;
        same(t, LOBE_ONE_Q30 / 2, a, LOBE_ONE_Q30 / 2, b);
        a.tangent2 = INT32_MAX, b.tangent2 = LOBE_ONE_Q30;
        same(t, LOBE_ONE_Q30 / 2, a, LOBE_ONE_Q30 / 2, b);
        a.sine = INT32_MIN, b.sine = 0;
        same(t, LOBE_ONE_Q30 / 2, a, LOBE_ONE_Q30 / 2, b);
        a.sine = INT32_MAX, b.sine = LOBE_ONE_Q30;
        same(t, LOBE_ONE_Q30 / 2, a, LOBE_ONE_Q30 / 2, b);
    }
}

/* Straight below there is no light. (Of the width that high gives the horizon, 20 degrees keep well below.) */
static void below_the_horizon(void **state)
{
    int i, k;
    (void)state;
    random_state = 6;
    for (i = 0; i < 1000; i++) {
        const double half_angle = between(0.01 * degree, 20 * degree);
        lobe_sphere_q30 light = place(0, between(0.08, 1.0), half_angle, 1.0);
        light.n_dot_l = -LOBE_ONE_Q30;
        for (k = 0; k < TIERS; k++)
            assert_int_equal(tiers[k].q30(fixed(between(0.22, 1.0)), light).mantissa, 0);
    }
}

/* Rounded to nearest, ties up, held at the ends. */
static void scaled_numbers_round(void **state)
{
    int i;
    (void)state;
    random_state = 7;
    for (i = 0; i < 1000000; i++) {
        const lobe_scaled_q30 y = {random_int(), i % 4 ? (int32_t)(random_bits() % 80) - 40 : random_int()};
        const double exact = ldexp(y.mantissa, y.exponent < -2000 ? -2000 : y.exponent > 900 ? 900 : y.exponent);
        const double want = fmin(fmax(floor(exact + 0.5), INT32_MIN), INT32_MAX);
        if (lobe_scaled_to_q30(y) != (int32_t)want)
            fail_msg("%d 2^%d: got %d, want %.0f", (int)y.mantissa, (int)y.exponent, (int)lobe_scaled_to_q30(y), want);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(near_the_formula),          cmocka_unit_test(wide_lights),
        cmocka_unit_test(beyond_the_domain),         cmocka_unit_test(small_lights),
        cmocka_unit_test(small_lights_are_punctual), cmocka_unit_test(anything_is_finite),
        cmocka_unit_test(inputs_are_clamped),        cmocka_unit_test(below_the_horizon),
        cmocka_unit_test(scaled_numbers_round),
    };
    return cmocka_run_group_tests_name("sphere lights in fixed point", tests, NULL, NULL);
}
