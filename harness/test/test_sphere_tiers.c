/* Sphere lights in f32: bad numbers, the same kernel in double, the limit of a small light, a light that has set. What
 * a light is made of (lobe_sphere_seen_f32) is in test_sphere_seen.c; how far a tier is from the truth, in the vectors.
 */
#define LOBE_DOUBLE 1
#include "../../models/lobe.h"
#include "../../models/sphere_light_high.h"
#include "cmocka_first.h"
#include <math.h>
#include <string.h>

typedef double formula(double roughness, lobe_sphere light);
typedef float function(float roughness, lobe_sphere_f32 light);
typedef void arrays(const float *, const float *, const float *, const float *, const float *, float *, size_t);

static const struct tier {
    const char *name;
    formula *in_double;
    function *f32;
    arrays *n;
    double set; /* the most of a light below the horizon, in the domain */
} tiers[] = {
    {"low", lobe_sphere_light_low, lobe_sphere_light_low_f32, lobe_sphere_light_low_n_f32, 0.0},
    {"medium", lobe_sphere_light_medium, lobe_sphere_light_medium_f32, lobe_sphere_light_medium_n_f32, 0.0},
    {"high", lobe_sphere_light_high, lobe_sphere_light_high_f32, lobe_sphere_light_high_n_f32, 0.02},
    {"punctual", lobe_sphere_light_punctual, lobe_sphere_light_punctual_f32, lobe_sphere_light_punctual_n_f32, 0.0},
};
enum { TIERS = sizeof tiers / sizeof tiers[0], EXTENDED = TIERS - 1 }; /* the last one has no size */

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

static place any_place(double roughness_lo, double v_lo, double sine_hi)
{
    const double a = uniform(), b = uniform(), c = uniform();
    return place_at(roughness_lo + (1.0 - roughness_lo) * uniform(), v_lo + (1.0 - v_lo) * uniform(),
                    2.0 * uniform() - 1.0, 3.14159265 * a * a, sine_hi * b * c);
}

static double in_f32(const struct tier *t, place p)
{
    return (double)t->f32(p.roughness, lobe_sphere_of_f32(p.v, p.l, p.tangent2, p.sine));
}

static double in_double(const struct tier *t, place p)
{
    return t->in_double((double)p.roughness,
                        lobe_sphere_of((double)p.v, (double)p.l, (double)p.tangent2, (double)p.sine));
}

static void fail_at(const struct tier *t, place p, double got, double want)
{
    fail_msg("%s at roughness %.9g, v %.9g, l %.9g, tangent2 %.9g, sine %.9g: got %.9g, want %.9g", t->name,
             (double)p.roughness, (double)p.v, (double)p.l, (double)p.tangent2, (double)p.sine, got, want);
}

static const uint32_t specials[] = {0x00000000, 0x80000000, 0x00000001, 0x80000001, 0x00800000, 0x3727c5ac, 0x3f000000,
                                    0x3f7fffff, 0x3f800000, 0x3f800001, 0xbf800000, 0xbf000000, 0x40000000, 0x7f7fffff,
                                    0xff7fffff, 0x7f800000, 0xff800000, 0x7fc00000, 0xffc00000, 0x7f800001};
enum { SPECIALS = sizeof specials / sizeof specials[0] };

/* Every member may be anything, versine too: a tier is in [0, 1], the punctual light finite and not negative. */
static void any_bits_are_answered(void **state)
{
    int t, i, k;
    (void)state;
    for (t = 0; t < TIERS; t++) {
        const double most = t < EXTENDED ? 1.0 : 3.4028235e38;
        for (i = 0; i < 600000; i++) {
            float x[6];
            double y;
            for (k = 0; k < 6; k++) {
                const uint32_t r = random_bits();
                x[k] = float_of(i % 3 == 0 ? r : i % 3 == 1 || r % 3 == 0 ? specials[r / 3 % SPECIALS] : 0x3f000000);
            }
            y = (double)tiers[t].f32(x[0], (lobe_sphere_f32){x[1], x[2], x[3], x[4], x[5]});
            if (!(y >= 0.0 && y <= most))
                fail_msg("%s at %a %a %a %a %a %a: %a", tiers[t].name, (double)x[0], (double)x[1], (double)x[2],
                         (double)x[3], (double)x[4], (double)x[5], y);
        }
    }
}

/* Rounding, over the domain: absolute, and relative to the formula in double at the same inputs. */
static void rounding_in_the_domain(void **state)
{
    int t, i;
    (void)state;
    for (t = 0; t < EXTENDED; t++) {
        for (i = 0; i < 400000; i++) {
            const place p = any_place(0.22, 0.08, 0.7072);
            const double got = in_f32(&tiers[t], p), want = in_double(&tiers[t], p);
            if (!(fabs(got - want) <= 2e-5))
                fail_at(&tiers[t], p, got, want);
        }
    }
}

/* Below a degree no digit is lost to the smallness of the light, whatever the height of the light above its rim. */
static void no_noise_below_a_degree(void **state)
{
    int t, i;
    (void)state;
    for (t = 0; t < TIERS; t++) {
        for (i = 0; i < 400000; i++) {
            const double sine = 0.01745 * pow(10.0, -3.0 * uniform());
            place p = any_place(0.22, 0.08, 0.7072);
            double got, want;
            p = place_at((double)p.roughness, (double)p.v, sine + (1.0 - sine) * uniform(),
                         3.14 * uniform() * uniform(), sine);
            got = in_f32(&tiers[t], p);
            want = in_double(&tiers[t], p);
            if (!(fabs(got - want) <= 2e-5 * want))
                fail_at(&tiers[t], p, got, want);
        }
    }
}

/* At a hundredth of a degree a light above the horizon is a punctual one, to a thousandth; and the smaller, the closer.
 */
static void meets_the_punctual_light(void **state)
{
    static const double degrees[] = {0.01, 0.003, 0.001}, allowed[] = {1e-3, 2e-4, 5e-5};
    int t, i, k;
    (void)state;
    for (t = 0; t < EXTENDED; t++) {
        for (i = 0; i < 200000; i++) {
            for (k = 0; k < 3; k++) {
                const double sine = sin(degrees[k] * 3.14159265358979 / 180.0);
                const double least = i % 2 ? 0.08 : 0.02; /* of the light */
                place p = any_place(0.22, 0.0872, 0.7072);
                double got, want;
                /* half of them in the mirror direction and around it, where the lobe bends the most */
                p = place_at(i % 8 ? (double)p.roughness : 0.22, (double)p.v,
                             i % 4 == 0 ? (double)p.v : least + (1.0 - least) * uniform(),
                             i % 2 ? 3.14159265 * uniform() : 0.1 * uniform() * uniform(), sine);
                got = in_f32(&tiers[t], p);
                want = in_f32(&tiers[EXTENDED], p);
                if (!(fabs(got - want) <= allowed[k] * want))
                    fail_at(&tiers[t], p, got, want);
            }
        }
    }
}

/* A light wholly below the horizon. low and medium give exactly nothing, high next to nothing. */
static void nothing_of_a_set_light(void **state)
{
    int t, i;
    (void)state;
    for (t = 0; t < TIERS; t++) {
        for (i = 0; i < 200000; i++) {
            const place some = any_place(0.22, 0.08, 0.7072);
            const double sine = (double)some.sine, l = -sine - 1e-6 - (1.0 - 1e-6 - sine) * uniform();
            const place p = place_at((double)some.roughness, (double)some.v, l, 3.14 * uniform(), sine);
            const double got = in_f32(&tiers[t], p);
            if (!(got <= tiers[t].set))
                fail_at(&tiers[t], p, got, tiers[t].set);
        }
    }
}

/* The arrays that the registry does not call, and the light of every element. */
static void arrays_have_the_same_bits(void **state)
{
    enum { COUNT = 1031 };
    static float x[5][COUNT], y[COUNT + 1];
    int t, i, k;
    (void)state;
    for (t = 0; t < TIERS; t++) {
        for (i = 0; i < COUNT; i++) {
            const place p = any_place(0.0, 0.0, 1.0);
            const float some[5] = {p.roughness, p.v, p.l, p.tangent2, p.sine};
            for (k = 0; k < 5; k++)
                x[k][i] = random_bits() % 8 ? some[k] : float_of(specials[random_bits() % SPECIALS]);
        }
        y[COUNT] = -1.0f;
        tiers[t].n(x[0], x[1], x[2], x[3], x[4], y, COUNT);
        assert_true(y[COUNT] == -1.0f);
        for (i = 0; i < COUNT; i++) {
            const float one = tiers[t].f32(x[0][i], lobe_sphere_of_f32(x[1][i], x[2][i], x[3][i], x[4][i]));
            if (memcmp(&one, &y[i], sizeof one) != 0)
                fail_msg("%s: element %d is %a, one call gives %a", tiers[t].name, i, (double)y[i], (double)one);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_bits_are_answered),   cmocka_unit_test(rounding_in_the_domain),
        cmocka_unit_test(no_noise_below_a_degree), cmocka_unit_test(meets_the_punctual_light),
        cmocka_unit_test(nothing_of_a_set_light),  cmocka_unit_test(arrays_have_the_same_bits),
    };
    return cmocka_run_group_tests_name("sphere_tiers", tests, NULL, NULL);
}
