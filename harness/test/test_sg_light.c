/* Spherical Gaussian lights: bad numbers, f32 and q30 against the same kernel in double, the limit of a sharp light,
 * view and axis on the normal and on each other, the numbers of a light from directions, and 2^-x in integers. How far
 * a tier is from the truth is in the vectors. */
#define LOBE_DOUBLE 1
#include "../../core/q30_exp2.h"
#include "../../models/lobe.h"
#include "../../models/sg_diffuse.h"
#include "../../models/sg_light_high.h"
#include "cmocka_first.h"
#include <math.h>
#include <string.h>

static const struct tier {
    const char *name;
    double (*in_double)(double roughness, lobe_sg light);
    float (*f32)(float roughness, lobe_sg_f32 light);
    lobe_scaled_q30 (*q30)(int32_t roughness, lobe_sg_q30 light);
} tiers[] = {
    {"low", lobe_sg_light_low, lobe_sg_light_low_f32, lobe_sg_light_low_q30},
    {"medium", lobe_sg_light_medium, lobe_sg_light_medium_f32, lobe_sg_light_medium_q30},
    {"high", lobe_sg_light_high, lobe_sg_light_high_f32, lobe_sg_light_high_q30},
};
enum { TIERS = sizeof tiers / sizeof tiers[0] };

static uint64_t random_state = 88172645463325252u;
static uint32_t random_bits(void)
{
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return (uint32_t)(random_state >> 32);
}
static double uniform(void) { return random_bits() * 0x1p-32; }

static float float_of(uint32_t bits)
{
    float f;
    memcpy(&f, &bits, sizeof f);
    return f;
}

/* roughness, then a lobe_sg, in multiples of 2^-24: exact in every format. */
typedef struct place {
    double roughness;
    lobe_sg light;
} place;

static double grid(double x) { return floor(x * 0x1p24 + 0.5) * 0x1p-24; }

static place place_at(double roughness, double v, double l, double azimuth, double versine)
{
    const double sv = sqrt(1.0 - v * v), sl = sqrt(1.0 - l * l), c = cos(0.5 * azimuth);
    place p;
    p.roughness = grid(roughness);
    p.light = lobe_sg_of(grid(v), grid(l), grid(0.25 * (sv - sl) * (sv - sl) + sv * sl * c * c), grid(versine));
    return p;
}

static place any_place(void)
{
    const double versine = pow(2.0, -2.0 - 10.0 * uniform()), v = 0.05 + 0.95 * uniform(), near = uniform();
    const double l = random_bits() & 1 ? 2.0 * uniform() - 1.0 : v;
    return place_at(0.22 + 0.78 * uniform(), v, l, 3.14159265 * (1.0 - near * near), versine);
}

static double in_double(const struct tier *t, place p) { return t->in_double(p.roughness, p.light); }

static double in_f32(const struct tier *t, place p)
{
    const lobe_sg_f32 s = {(float)p.light.n_dot_v, (float)p.light.n_dot_l, (float)p.light.tangent2,
                           (float)p.light.versine};
    return (double)t->f32((float)p.roughness, s);
}

static int32_t fixed(double x) { return (int32_t)lrint(x * LOBE_ONE_Q30); }

static double in_q30(const struct tier *t, place p)
{
    const lobe_sg_q30 s = {fixed(p.light.n_dot_v), fixed(p.light.n_dot_l), fixed(p.light.tangent2),
                           fixed(p.light.versine)};
    const lobe_scaled_q30 y = t->q30(fixed(p.roughness), s);
    return ldexp(y.mantissa, y.exponent - 30);
}

static void fail_at(const struct tier *t, place p, double got, double want)
{
    fail_msg("%s at roughness %.9g, v %.9g, l %.9g, tangent2 %.9g, versine %.9g: got %.9g, want %.9g", t->name,
             p.roughness, p.light.n_dot_v, p.light.n_dot_l, p.light.tangent2, p.light.versine, got, want);
}

static const uint32_t specials[] = {0x00000000, 0x80000000, 0x00000001, 0x00800000, 0x3727c5ac, 0x3f000000, 0x3f7fffff,
                                    0x3f800000, 0x3f800001, 0xbf800000, 0xbf000000, 0x40000000, 0x7f7fffff, 0xff7fffff,
                                    0x7f800000, 0xff800000, 0x7fc00000, 0xffc00000, 0x7f800001};
enum { SPECIALS = sizeof specials / sizeof specials[0] };

static void any_bits_are_answered(void **state)
{
    int t, i, k;
    (void)state;
    for (t = 0; t < TIERS; t++) {
        for (i = 0; i < 600000; i++) {
            float x[5];
            double y;
            int32_t q[5];
            lobe_scaled_q30 z;
            for (k = 0; k < 5; k++) {
                const uint32_t r = random_bits();
                x[k] = float_of(i % 3 == 0 ? r : i % 3 == 1 || r % 3 == 0 ? specials[r / 3 % SPECIALS] : 0x3f000000);
                q[k] = (int32_t)(i % 3 == 1 ? specials[r / 3 % SPECIALS] : r);
            }
            y = (double)tiers[t].f32(x[0], (lobe_sg_f32){x[1], x[2], x[3], x[4]});
            if (!(y >= 0.0 && y <= 1.0))
                fail_msg("%s at %a %a %a %a %a: %a", tiers[t].name, (double)x[0], (double)x[1], (double)x[2],
                         (double)x[3], (double)x[4], y);
            z = tiers[t].q30(q[0], (lobe_sg_q30){q[1], q[2], q[3], q[4]});
            y = ldexp(z.mantissa, z.exponent - 30);
            if (!(y >= 0.0 && y <= 1.0))
                fail_msg("%s at %d %d %d %d %d: %a", tiers[t].name, (int)q[0], (int)q[1], (int)q[2], (int)q[3],
                         (int)q[4], y);
        }
    }
}

/* Rounding over the domain: absolute, and relative but for 1e-8. */
static void near_the_formula(void **state)
{
    int t, i;
    (void)state;
    for (t = 0; t < TIERS; t++) {
        for (i = 0; i < 400000; i++) {
            const place p = any_place();
            const double want = in_double(&tiers[t], p), f32 = in_f32(&tiers[t], p), q30 = in_q30(&tiers[t], p);
            const double slack = 2e-5 * want + 1e-8;
            if (!(fabs(f32 - want) <= fmin(4e-6, slack)))
                fail_at(&tiers[t], p, f32, want);
            if (!(fabs(q30 - want) <= fmin(0x1p-21, slack)))
                fail_at(&tiers[t], p, q30, want);
        }
    }
}

/* A sharp light whose axis stands over the horizon is a punctual one, within 12 % at a
 * sharpness of 131072 in the faintest tail, and the closer the sharper. */
static void a_sharp_light_is_punctual(void **state)
{
    int t, i;
    (void)state;
    for (t = 0; t < TIERS; t++) {
        double sum[2] = {0.0, 0.0};
        for (i = 0; i < 40000; i++) {
            place p = any_place();
            double off[2];
            int k;
            p.light.n_dot_v = 0.3 + 0.7 * p.light.n_dot_v; /* at grazing views no light is small beside the lobe */
            p.light.n_dot_l = 0.3 + 0.7 * fabs(p.light.n_dot_l);
            p = place_at(p.roughness, p.light.n_dot_v, p.light.n_dot_l, 3.14159265 * uniform(), 1.0);
            for (k = 0; k < 2; k++) {
                const double versine = k ? 0x1p-17 : 0x1p-14;
                const lobe_sphere s = {p.light.n_dot_v, p.light.n_dot_l, p.light.tangent2, 0.0, versine};
                p.light.versine = versine;
                off[k] = fabs(in_double(&tiers[t], p) / lobe_sphere_light_punctual(p.roughness, s) - 1.0);
            }
            sum[0] += off[0];
            sum[1] += off[1];
            if (!(off[1] <= 0.12))
                fail_at(&tiers[t], p, off[1], off[0]);
        }
        print_message("# %s: mean difference %.3g, eight times sharper %.3g\n", tiers[t].name, sum[0] / 40000,
                      sum[1] / 40000);
        assert_true(sum[1] <= 0.15 * sum[0]);
    }
}

/* Nothing happens where the published frame is 0/0: view on the normal, on the axis, both. */
static void on_the_normal(void **state)
{
    static const double places[][4] = {
        {1.0, 1.0, 0.0, 0.0}, {1.0, 0.7, 1.0, 1.0}, {0.7, 1.0, 2.0, 0.0}, {0.7, 0.7, 0.0, 0.0}};
    size_t i;
    int t, k;
    (void)state;
    for (t = 0; t < TIERS; t++) {
        for (i = 0; i < 4; i++) {
            for (k = 0; k < 2; k++) {
                const double v = places[i][0], l = places[i][1], phi = places[i][2], versine = k ? 0.01 : 0.2, d = 1e-7;
                const double on = in_f32(&tiers[t], place_at(0.5, v, l, phi, versine));
                const double beside = in_f32(&tiers[t], place_at(0.5, v - d, l - d, phi + d, versine));
                assert_true(on > 0.0 && on < 1.0);
                if (!(fabs(beside / on - 1.0) < 1e-3))
                    fail_at(&tiers[t], place_at(0.5, v, l, phi, versine), beside, on);
            }
        }
    }
}

/* Amplitude 1 gives at most the albedo of an even light of radiance 1, and an axis far under the horizon nothing. */
static void a_light_that_has_set(void **state)
{
    int t, i;
    (void)state;
    for (t = 0; t < TIERS; t++) {
        for (i = 0; i < 100000; i++) {
            place p = any_place();
            const double versine = fmin(p.light.versine, 0.02), depth = -6.0 * sqrt(versine);
            double y;
            p = place_at(p.roughness, p.light.n_dot_v, depth + (-1.0 - depth) * uniform(), 3.14159265 * uniform(),
                         versine);
            y = in_f32(&tiers[t], p);
            if (!(y <= 0.02))
                fail_at(&tiers[t], p, y, 0.0);
        }
    }
}

static void from_directions(void **state)
{
    int i;
    (void)state;
    for (i = 0; i < 200000; i++) {
        const double v = uniform(), l = 2.0 * uniform() - 1.0, phi = 6.2831853 * uniform(),
                     turn = 6.2831853 * uniform();
        const double sv = sqrt(1.0 - v * v), sl = sqrt(1.0 - l * l), sharpness = pow(2.0, 12.0 * uniform());
        /* n = x, so that no component is special */
        const lobe_vec3_f32 n = {1.0f, 0.0f, 0.0f};
        const lobe_vec3_f32 w = {(float)v, (float)(sv * cos(turn)), (float)(sv * sin(turn))};
        const lobe_vec3_f32 a = {(float)l, (float)(sl * cos(turn + phi)), (float)(sl * sin(turn + phi))};
        const lobe_sg_f32 s = lobe_sg_seen_f32(n, w, a, (float)sharpness);
        const double root = sqrt(fmax(0.0, 0.25 * (sv * sv + sl * sl + 2.0 * sv * sl * cos(phi))));
        assert_true(fabs((double)s.n_dot_v - v) < 3e-7 && fabs((double)s.n_dot_l - l) < 3e-7);
        assert_true(fabs((double)s.tangent2 - root * root) < 6e-7 * root + 1e-13);
        assert_true(fabs((double)s.versine * sharpness - 1.0) < 0x1p-22);
    }
    {
        const lobe_vec3_f32 bad = {NAN, INFINITY, -INFINITY};
        const lobe_sg_f32 s = lobe_sg_seen_f32(bad, bad, bad, NAN);
        assert_true(s.n_dot_v >= 0.0f && s.n_dot_v <= 1.0f && s.n_dot_l >= -1.0f && s.n_dot_l <= 1.0f);
        assert_true(s.tangent2 >= 0.0f && s.tangent2 <= 1.0f && s.versine == 1.0f);
    }
}

/* Against a sum over the light, in parts of what it gives overhead; and bad numbers. */
static double lit(double c, double sharpness)
{
    enum { RINGS = 600, SPOKES = 256 };
    double sum = 0.0;
    int i, k;
    for (i = 0; i < RINGS; i++) { /* even in the light's weight */
        const double whole = -expm1(-2.0 * sharpness), u = -log1p(-whole * (i + 0.5) / RINGS) / sharpness;
        const double along = (1.0 - u) * c, aside = sqrt(fmax(0.0, u * (2.0 - u))) * sqrt(1.0 - c * c);
        for (k = 0; k < SPOKES; k++)
            sum += fmax(0.0, along + aside * cos(3.14159265358979 * (k + 0.5) / SPOKES)) * whole;
    }
    return 2.0 / sharpness * sum / (RINGS * SPOKES);
}

static void diffuse(void **state)
{
    static const float odd[] = {NAN, INFINITY, -INFINITY, 0.0f, -1.0f, 1.0f, 1e-30f, 3e38f};
    double worst[2] = {0.0, 0.0};
    int i, k;
    (void)state;
    for (i = 0; i <= 26; i++) {
        const double sharpness = 0.5 * pow(2.0, 0.5 * i), overhead = lit(1.0, sharpness);
        for (k = -20; k <= 20; k++) {
            const double want = lit(0.05 * k, sharpness);
            const float c = (float)(0.05 * k), w = (float)(1.0 / sharpness);
            worst[0] = fmax(worst[0], fabs((double)lobe_sg_diffuse_high_f32(c, w) - want) / overhead);
            worst[1] = fmax(worst[1], fabs((double)lobe_sg_diffuse_inner_f32(c, w) - want) / overhead);
        }
    }
    print_message("# fitted %.5f, inner product %.5f\n", worst[0], worst[1]);
    assert_true(worst[0] < 0.0052 && worst[1] < 0.175);
    for (i = 0; i < 8; i++)
        for (k = 0; k < 8; k++) {
            const float a = lobe_sg_diffuse_high_f32(odd[i], odd[k]), b = lobe_sg_diffuse_inner_f32(odd[i], odd[k]);
            assert_true(a >= 0.0f && a <= 2.0f && b >= 0.0f && b <= 2.0f);
        }
}

/* Both formats in parts of what the light gives overhead, and no light under a light that has set. */
static void diffuse_near_the_formula(void **state)
{
    double worst[2] = {0.0, 0.0};
    int i;
    (void)state;
    for (i = 0; i < 200000; i++) {
        const double c = grid(i % 7 ? 2.0 * uniform() - 1.0 : i % 2 ? 1.0 : -1.0);
        const double w = grid(fmax(0x1p-19, pow(2.0, 1.0 - 13.0 * uniform())) - 0x1p-20);
        const double want = lobe_sg_diffuse_high(c, w), overhead = lobe_sg_diffuse_high(1.0, w);
        const lobe_scaled_q30 q = lobe_sg_diffuse_high_q30(fixed(c), fixed(w));
        worst[0] = fmax(worst[0], fabs((double)lobe_sg_diffuse_high_f32((float)c, (float)w) - want) / overhead);
        worst[1] = fmax(worst[1], fabs(ldexp(q.mantissa, q.exponent - 30) - want) / overhead);
        assert_true(q.mantissa >= 0 && q.exponent <= 1);
    }
    print_message("# f32 %.3g, q30 %.3g of the light overhead\n", worst[0], worst[1]);
    assert_true(worst[0] < 0x1p-20 && worst[1] < 0x1p-23);
    for (i = 0; i < 100000; i++) { /* any bits */
        const lobe_scaled_q30 q = lobe_sg_diffuse_high_q30((int32_t)random_bits(), (int32_t)random_bits());
        assert_true(q.mantissa >= 0 && q.mantissa <= LOBE_ONE_Q30 && q.exponent <= 1);
    }
}

static void powers_of_two(void **state)
{
    int i;
    (void)state;
    for (i = 0; i < 2000000; i++) {
        const int32_t m = (int32_t)(random_bits() >> 1), e = (int32_t)(random_bits() % 12) - 4;
        const lobe_q_scaled x = lobe_qs_of(m, e), y = lobe_qs_exp2_minus(x);
        const double want = exp2(-ldexp(m, e - 30)), got = ldexp(y.m, y.e - 30);
        assert_true(want < 0x1p-126 ? got <= 0x1p-126 : fabs(got / want - 1.0) < 5e-8);
    }
    assert_true(ldexp(lobe_qs_exp2_minus(lobe_qs_of(-5, 0)).m, lobe_qs_exp2_minus(lobe_qs_of(-5, 0)).e) == 0x1p30);
    for (i = 0; i < 120; i++) { /* whole numbers are exact */
        const lobe_q_scaled y = lobe_qs_exp2_minus(lobe_qs_of(i << 20, 10));
        assert_true(ldexp(y.m, y.e - 30) == ldexp(1.0, -i));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_bits_are_answered),
        cmocka_unit_test(near_the_formula),
        cmocka_unit_test(a_sharp_light_is_punctual),
        cmocka_unit_test(on_the_normal),
        cmocka_unit_test(a_light_that_has_set),
        cmocka_unit_test(from_directions),
        cmocka_unit_test(powers_of_two),
        cmocka_unit_test(diffuse),
        cmocka_unit_test(diffuse_near_the_formula),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
