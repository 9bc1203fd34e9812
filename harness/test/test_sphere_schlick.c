/* Schlick inside a sphere light, in f32 and q30: bad numbers, the same kernel in double, the limit of a small light,
 * the mirror, and arrays. How far it is from the truth is in cases/test/test_sphere_schlick_floors.c. */
#define LOBE_DOUBLE 1
#include "../../models/lobe.h"
#include "../../models/sphere_light_high.h"
#include "cmocka_first.h"
#include <math.h>
#include <string.h>

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

static float high(float roughness, lobe_sphere_f32 light)
{
    return lobe_sphere_light_high_lit_f32(roughness, light).schlick;
}
static double high_in_double(double roughness, lobe_sphere light)
{
    return lobe_sphere_light_high_lit(roughness, light).schlick;
}

static const struct form {
    const char *name;
    float (*f32)(float roughness, lobe_sphere_f32 light);
    double (*in_double)(double roughness, lobe_sphere light);
    double rounding, rounding_small; /* of all sizes to 45 degrees; below a degree */
} forms[] = {{"schlick", lobe_sphere_light_schlick_f32, lobe_sphere_light_schlick, 2e-6, 2e-6},
             {"high", high, high_in_double, 1e-4, 2e-6}};
enum { FORMS = sizeof forms / sizeof forms[0] };

/* A place and a light; phi is how far the light is from the mirror's side. */
typedef struct place {
    float roughness, v, l, tangent2, sine;
} place;

static place place_at(double roughness, double v, double l, double phi, double sine)
{
    const double sv = sqrt(1.0 - v * v), sl = sqrt(1.0 - l * l), s = sin(0.5 * phi);
    place p;
    p.roughness = (float)roughness;
    p.v = (float)v;
    p.l = (float)l;
    p.tangent2 = (float)(0.25 * (sv - sl) * (sv - sl) + sv * sl * s * s);
    p.sine = (float)sine;
    return p;
}

static place any_place(double sine_hi)
{
    const double a = uniform(), b = uniform();
    return place_at(0.22 + 0.78 * uniform(), 0.08 + 0.92 * uniform(), 2.0 * uniform() - 1.0, 3.14159265 * a * a,
                    sine_hi * b);
}

static double in_f32(const struct form *f, place p)
{
    return (double)f->f32(p.roughness, lobe_sphere_of_f32(p.v, p.l, p.tangent2, p.sine));
}

static double in_double(const struct form *f, place p)
{
    return f->in_double((double)p.roughness,
                        lobe_sphere_of((double)p.v, (double)p.l, (double)p.tangent2, (double)p.sine));
}

static void fail_at(const struct form *f, place p, double got, double want)
{
    fail_msg("%s at roughness %.9g, v %.9g, l %.9g, tangent2 %.9g, sine %.9g: got %.9g, want %.9g", f->name,
             (double)p.roughness, (double)p.v, (double)p.l, (double)p.tangent2, (double)p.sine, got, want);
}

static const uint32_t specials[] = {0x00000000, 0x80000000, 0x00000001, 0x80000001, 0x00800000, 0x3727c5ac, 0x3f000000,
                                    0x3f7fffff, 0x3f800000, 0x3f800001, 0xbf800000, 0xbf000000, 0x40000000, 0x7f7fffff,
                                    0xff7fffff, 0x7f800000, 0xff800000, 0x7fc00000, 0xffc00000, 0x7f800001};
enum { SPECIALS = sizeof specials / sizeof specials[0] };

/* Every member may be anything, versine too. */
static void any_bits_are_answered(void **state)
{
    int f, i, k;
    (void)state;
    for (f = 0; f < FORMS; f++) {
        for (i = 0; i < 600000; i++) {
            float x[6];
            double y;
            for (k = 0; k < 6; k++) {
                const uint32_t r = random_bits();
                x[k] = float_of(i % 3 == 0 ? r : i % 3 == 1 || r % 3 == 0 ? specials[r / 3 % SPECIALS] : 0x3f000000);
            }
            y = (double)forms[f].f32(x[0], (lobe_sphere_f32){x[1], x[2], x[3], x[4], x[5]});
            if (!(y >= 0.0 && y <= 1.0))
                fail_msg("%s at %a %a %a %a %a %a: %a", forms[f].name, (double)x[0], (double)x[1], (double)x[2],
                         (double)x[3], (double)x[4], (double)x[5], y);
        }
    }
}

static void rounding(void **state)
{
    int f, i, small;
    (void)state;
    for (f = 0; f < FORMS; f++) {
        for (small = 0; small < 2; small++) {
            const double allowed = small ? forms[f].rounding_small : forms[f].rounding;
            for (i = 0; i < 300000; i++) {
                const place p = any_place(small ? 0.01745 : 0.7072);
                const double got = in_f32(&forms[f], p), want = in_double(&forms[f], p);
                if (!(fabs(got - want) <= allowed))
                    fail_at(&forms[f], p, got, want);
            }
        }
    }
}

/* At a hundredth of a degree, (1 - v.h)^5 of the light's centre, from the angles. */
static void meets_the_punctual_light(void **state)
{
    int f, i;
    (void)state;
    for (f = 0; f < FORMS; f++) {
        for (i = 0; i < 200000; i++) {
            const double v = 0.08 + 0.92 * uniform(), l = uniform(), phi = 3.14159265 * (i % 2 ? 1.0 : 0.1) * uniform();
            const double v_l = v * l - sqrt((1.0 - v * v) * (1.0 - l * l)) * cos(phi); /* phi = 0: the mirror's side */
            const double want = pow(1.0 - sqrt(0.5 * (1.0 + v_l)), 5.0);
            const place p = place_at(0.22 + 0.78 * uniform(), v, l, phi, 1.745329e-4);
            const double got = in_f32(&forms[f], p);
            if (!(fabs(got - want) <= 1e-4 * (want + 0.02)))
                fail_at(&forms[f], p, got, want);
        }
    }
}

/* A mirror that sees a light of any size about the mirror direction reflects (1 - n.v)^5 of it; alpha is 1e-3. */
static void mirror_has_one_direction(void **state)
{
    int i;
    (void)state;
    for (i = 0; i < 100000; i++) {
        const double v = 0.2 + 0.8 * uniform(), sine = 0.1 + 0.6 * uniform();
        const place p = place_at(0.0, v, v, 0.0, sine);
        const double got = in_f32(&forms[1], p), want = pow(1.0 - v, 5.0);
        if (!(fabs(got - want) <= 1e-2 * (want + 0.02)))
            fail_at(&forms[1], p, got, want);
    }
}

/* The radiance beside it is that of high, to the last bit. */
static void radiance_is_that_of_high(void **state)
{
    int i;
    (void)state;
    for (i = 0; i < 200000; i++) {
        const place p = any_place(1.0);
        const lobe_sphere_f32 light = lobe_sphere_of_f32(p.v, p.l, p.tangent2, p.sine);
        const float a = lobe_sphere_light_high_lit_f32(p.roughness, light).radiance;
        const float b = lobe_sphere_light_high_f32(p.roughness, light);
        assert_memory_equal(&a, &b, sizeof a);
    }
}

static void arrays_have_the_same_bits(void **state)
{
    enum { COUNT = 1031 };
    static float x[5][COUNT], radiance[COUNT + 1], schlick[COUNT + 1], alone[COUNT + 1];
    int i, k;
    (void)state;
    for (i = 0; i < COUNT; i++) {
        const place p = any_place(1.0);
        const float some[5] = {p.roughness, p.v, p.l, p.tangent2, p.sine};
        for (k = 0; k < 5; k++)
            x[k][i] = random_bits() % 8 ? some[k] : float_of(specials[random_bits() % SPECIALS]);
    }
    radiance[COUNT] = schlick[COUNT] = alone[COUNT] = -1.0f;
    lobe_sphere_light_high_lit_n_f32(x[0], x[1], x[2], x[3], x[4], radiance, schlick, COUNT);
    lobe_sphere_light_schlick_n_f32(x[0], x[1], x[2], x[3], x[4], alone, COUNT);
    assert_true(radiance[COUNT] == -1.0f && schlick[COUNT] == -1.0f && alone[COUNT] == -1.0f);
    for (i = 0; i < COUNT; i++) {
        const lobe_sphere_f32 light = lobe_sphere_of_f32(x[1][i], x[2][i], x[3][i], x[4][i]);
        const lobe_sphere_lit_f32 lit = lobe_sphere_light_high_lit_f32(x[0][i], light);
        const float one = lobe_sphere_light_schlick_f32(x[0][i], light);
        assert_memory_equal(&radiance[i], &lit.radiance, sizeof one);
        assert_memory_equal(&schlick[i], &lit.schlick, sizeof one);
        assert_memory_equal(&alone[i], &one, sizeof one);
    }
}

static int32_t schlick_q30(int32_t roughness, lobe_sphere_q30 light)
{
    return lobe_sphere_light_schlick_q30(roughness, light);
}
static int32_t high_q30(int32_t roughness, lobe_sphere_q30 light)
{
    return lobe_sphere_light_high_lit_q30(roughness, light).schlick;
}
static int32_t (*const integers[FORMS])(int32_t roughness, lobe_sphere_q30 light) = {schlick_q30, high_q30};

static int32_t fixed(double x) { return (int32_t)lrint(x * 0x1p30); }
static double real(int32_t x) { return x * 0x1p-30; }

/* Against the formula in double at the numbers that the integers stand for: in the domain, and anywhere. */
static void integers_are_the_formula(void **state)
{
    int f, i, beyond;
    (void)state;
    for (f = 0; f < FORMS; f++) {
        for (beyond = 0; beyond < 2; beyond++) {
            for (i = 0; i < 200000; i++) {
                place p = any_place(beyond ? 1.0 : 0.7072);
                lobe_sphere_q30 light;
                int32_t rough;
                double got, want;
                if (beyond)
                    p = place_at(uniform(), uniform(), (double)p.l, 3.14159265 * uniform(), (double)p.sine);
                light = (lobe_sphere_q30){fixed((double)p.v), fixed((double)p.l), fixed((double)p.tangent2),
                                          fixed((double)p.sine)};
                rough = fixed((double)p.roughness);
                got = real(integers[f](rough, light));
                want = forms[f].in_double(real(rough), lobe_sphere_of(real(light.n_dot_v), real(light.n_dot_l),
                                                                      real(light.tangent2), real(light.sine)));
                if (!(fabs(got - want) <= (beyond ? 0x1p-18 : 0x1p-20)))
                    fail_at(&forms[f], p, got, want);
            }
        }
    }
}

static void any_integers_are_answered(void **state)
{
    static const int32_t ends[] = {0, 1, -1, 1073741823, 1073741824, 1073741825, -1073741824, INT32_MAX, INT32_MIN};
    int f, i, k;
    (void)state;
    for (f = 0; f < FORMS; f++) {
        for (i = 0; i < 300000; i++) {
            int32_t x[5], y;
            for (k = 0; k < 5; k++)
                x[k] = random_bits() % 2 ? (int32_t)random_bits() : ends[random_bits() % 9];
            y = integers[f](x[0], (lobe_sphere_q30){x[1], x[2], x[3], x[4]});
            assert_true(y >= 0 && y <= 1073741824);
        }
    }
}

static void integer_radiance_is_that_of_high(void **state)
{
    int i;
    (void)state;
    for (i = 0; i < 20000; i++) {
        const place p = any_place(1.0);
        const lobe_sphere_q30 light = {fixed((double)p.v), fixed((double)p.l), fixed((double)p.tangent2),
                                       fixed((double)p.sine)};
        const int32_t rough = fixed((double)p.roughness);
        const lobe_scaled_q30 a = lobe_sphere_light_high_lit_q30(rough, light).radiance;
        const lobe_scaled_q30 b = lobe_sphere_light_high_q30(rough, light);
        assert_true(a.mantissa == b.mantissa && a.exponent == b.exponent);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_bits_are_answered),
        cmocka_unit_test(rounding),
        cmocka_unit_test(meets_the_punctual_light),
        cmocka_unit_test(mirror_has_one_direction),
        cmocka_unit_test(radiance_is_that_of_high),
        cmocka_unit_test(arrays_have_the_same_bits),
        cmocka_unit_test(integers_are_the_formula),
        cmocka_unit_test(any_integers_are_answered),
        cmocka_unit_test(integer_radiance_is_that_of_high),
    };
    return cmocka_run_group_tests_name("sphere_schlick", tests, NULL, NULL);
}
