/* Irradiance of sphere lights as the library gives it: each format against its formula in double (which
 * cases/test/test_sphere_diffuse.c holds against quadrature), the limits that are known without an integral, and the
 * same light as spherical harmonics. */
#define LOBE_DOUBLE 1
#include "../../models/sphere_diffuse.h"
#include "../../models/lobe.h"
#include "cmocka_first.h"
#include <math.h>

static const double pi = 3.14159265358979323846;

typedef double formula(double n_dot_l, double sine);
typedef float call_f32(float n_dot_l, float sine);
typedef lobe_scaled_q30 call_q30(int32_t n_dot_l, int32_t sine);

/* What a format adds to the formula, as a part of sine^2, at most. */
static const struct tier {
    const char *name;
    formula *in_double;
    call_f32 *f32;
    call_q30 *q30;
    double f32_adds, q30_adds;
} tiers[] = {
    {"low", lobe_sphere_diffuse_low, lobe_sphere_diffuse_low_f32, lobe_sphere_diffuse_low_q30, 8e-7, 0x1p-26},
    {"medium", lobe_sphere_diffuse_medium, lobe_sphere_diffuse_medium_f32, lobe_sphere_diffuse_medium_q30, 3e-7,
     0x1p-26},
    {"exact", lobe_sphere_diffuse_exact, lobe_sphere_diffuse_exact_f32, lobe_sphere_diffuse_exact_q30, 2e-7, 0x1p-26},
};
enum { TIERS = sizeof tiers / sizeof tiers[0] };

static int32_t q30(double x) { return (int32_t)floor(x * 1073741824.0 + 0.5); }
static double real(lobe_scaled_q30 y) { return ldexp(y.mantissa, y.exponent - 30); }

static void compare(const struct tier *t, double n_dot_l, double sine)
{
    const float cf = (float)n_dot_l, sf = (float)sine;
    const int32_t cq = q30(n_dot_l), sq = q30(sine);
    const double cd = (double)cf, sd = (double)sf, ci = cq / 1073741824.0, si = sq / 1073741824.0;
    const double f = (double)t->f32(cf, sf), q = real(t->q30(cq, sq));
    const double of_f = t->in_double(cd, sd), of_q = t->in_double(ci, si);
    if (!(fabs(f - of_f) <= t->f32_adds * sd * sd))
        fail_msg("%s f32 at %.9g %.9g: %.9g, not %.9g", t->name, cd, sd, f, of_f);
    if (!(fabs(q - of_q) <= t->q30_adds * si * si))
        fail_msg("%s q30 at %.9g %.9g: %.12g, not %.12g", t->name, ci, si, q, of_q);
}

/* From lights of 2^-13 radian, a hundred-and-fortieth of a degree, to half the sky and all but that. */
static void formats_keep_their_floors(void **state)
{
    int t, i, k;
    (void)state;
    for (t = 0; t < TIERS; t++)
        for (i = 0; i <= 700; i++) {
            const double u = i / 700.0;
            const double sine = i % 3 == 0   ? ldexp(1.0, -(int)(13 * u)) * (1 - 0.37 * u)
                                : i % 3 == 1 ? sin(pi / 2 * u)
                                             : 1 - pow(10.0, -8 * u);
            for (k = 0; sine > 0 && k <= 500; k++) {
                compare(&tiers[t], sine * sin(pi * (k / 500.0 - 0.5)), sine);
                compare(&tiers[t], k / 250.0 - 1.0, sine);
            }
        }
}

/* Above the horizon a light of any size is a punctual one: f32 has the bits of sine^2 n_dot_l, q30 its digits, also at
 * a hundredth of a degree. Below it is nothing. */
static void whole_lights_are_punctual(void **state)
{
    int t, i, k;
    (void)state;
    for (t = 0; t < TIERS; t++)
        for (i = 0; i <= 200; i++)
            for (k = 0; k <= 200; k++) {
                const double sine = pow(10.0, -3.7594 * i / 200), n_dot_l = sine + (1 - sine) * k / 200;
                const float sf = (float)sine, cf = fmaxf((float)n_dot_l, sf);
                const int32_t sq = q30(sine), cq = q30(n_dot_l) > sq ? q30(n_dot_l) : sq;
                const double want = (sq / 1073741824.0) * (sq / 1073741824.0) * (cq / 1073741824.0);
                assert_true(tiers[t].f32(cf, sf) == sf * sf * cf);
                assert_true(tiers[t].f32(-cf, sf) == 0.0f);
                if (!(fabs(real(tiers[t].q30(cq, sq)) / want - 1.0) <= 0x1p-26))
                    fail_msg("%s q30 at %.9g %.9g: %.12g, not %.12g", tiers[t].name, n_dot_l, sine,
                             real(tiers[t].q30(cq, sq)), want);
                assert_int_equal(tiers[t].q30(-cq, sq).mantissa, 0);
            }
}

/* A small disc whose centre is on the horizon: 2 / (3 pi) sine^3. Half the sky: (1 + n_dot_l) / 2. */
static void known_values(void **state)
{
    static const double allowed[TIERS] = {0.09, 0.033, 2e-6}; /* relative; low and medium: .019 and .0069 sine^3 */
    int t, i;
    (void)state;
    for (t = 0; t < TIERS; t++) {
        for (i = 3; i <= 13; i++) {
            const double sine = ldexp(1.0, -i), s2 = sine * sine; /* (sigma - sin sigma cos sigma) / pi */
            const double want = sine * s2 * (2.0 / 3 + s2 / 5 + 3 * s2 * s2 / 28 + 5 * s2 * s2 * s2 / 72) / pi;
            assert_true(fabs((double)tiers[t].f32(0.0f, (float)sine) / want - 1) <= allowed[t]);
            assert_true(fabs(real(tiers[t].q30(0, q30(sine))) / want - 1) <= allowed[t]);
        }
        for (i = -64; i <= 64; i++) {
            const double want = (1 + i / 64.0) / 2;
            assert_true(fabs((double)tiers[t].f32((float)(i / 64.0), 1.0f) - want) <= 2.5e-7);
            assert_true(fabs(real(tiers[t].q30(q30(i / 64.0), LOBE_ONE_Q30)) - want) <= 1e-8);
        }
    }
}

/* Of a light that rises nothing is lost, but rounding; and a wider light gives more, but the fit's error. */
static void never_falls(void **state)
{
    int t, i, k;
    (void)state;
    for (t = 0; t < TIERS; t++)
        for (i = 1; i <= 300; i++) {
            const double sine = i <= 150 ? sin(pi / 2 * i / 150) : pow(10.0, -3.7 * (i - 150) / 150);
            double high_f = 0, high_q = 0;
            for (k = 0; k <= 2000; k++) {
                const double x = (k < 1000 ? -1 + k / 500.0 : 1 + (1 / sine - 1) * (k - 1000) / 1000.0) * sine;
                const double f = (double)tiers[t].f32((float)x, (float)sine), q = real(tiers[t].q30(q30(x), q30(sine)));
                if (!(f >= high_f - 4e-7 * sine * sine && q >= high_q - 0x1p-26 * sine * sine))
                    fail_msg("%s falls at %.9g %.9g", tiers[t].name, x, sine);
                high_f = fmax(high_f, f);
                high_q = fmax(high_q, q);
            }
        }
}

/* Out of range counts as the nearer end, NaN as the lower one, and the mantissa is 0 or in [2^29, 2^30]. */
static void ends_and_specials(void **state)
{
    static const float odd[] = {NAN, INFINITY, -INFINITY, 3e38f, -3e38f, 1e-45f, -1e-45f, -0.0f, 1e-30f, 1.5f, -1.5f};
    int t;
    size_t a, b;
    uint32_t random = 1;
    (void)state;
    for (t = 0; t < TIERS; t++) {
        for (a = 0; a < sizeof odd / sizeof odd[0]; a++)
            for (b = 0; b < sizeof odd / sizeof odd[0]; b++) {
                const float c = odd[a] > -1.0f ? fminf(odd[a], 1.0f) : -1.0f,
                            s = odd[b] > 0.0f ? fminf(odd[b], 1.0f) : 0.0f;
                assert_true(tiers[t].f32(odd[a], odd[b]) == tiers[t].f32(c, s));
                assert_true(tiers[t].f32(c, s) >= 0.0f && tiers[t].f32(c, s) <= 1.0f);
            }
        assert_int_equal(tiers[t].q30(INT32_MAX, INT32_MAX).mantissa, LOBE_ONE_Q30);
        assert_int_equal(tiers[t].q30(INT32_MIN, INT32_MAX).mantissa, 0);
        assert_int_equal(tiers[t].q30(LOBE_ONE_Q30, INT32_MIN).mantissa, 0);
        for (a = 0; a < 400000; a++) {
            lobe_scaled_q30 y;
            int32_t in[2];
            for (b = 0; b < 2; b++) {
                random = random * 1664525u + 1013904223u;
                in[b] = (int32_t)random >> (a % 3 == b ? random % 30 : 1);
            }
            y = tiers[t].q30(in[0], in[1]);
            assert_true(y.mantissa == 0 || (y.mantissa >= 1 << 29 && y.mantissa <= 1 << 30));
            assert_true(real(y) <= 1.0);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(formats_keep_their_floors),
        cmocka_unit_test(whole_lights_are_punctual),
        cmocka_unit_test(known_values),
        cmocka_unit_test(never_falls),
        cmocka_unit_test(ends_and_specials),
    };
    return cmocka_run_group_tests_name("sphere_diffuse", tests, NULL, NULL);
}
