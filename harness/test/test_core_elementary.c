/* The elementary functions of core: a strided pass through every exponent of every domain against libm in double,
 * the inputs where the exhaustive measurement found the worst error, and the special floats.
 * Compiled a second time with -Ofast and LOBE_TEST_FAST: a user's compiler may reorder, contract, and take roots
 * and quotients from estimates, so bounds are doubled, roots and quotients get 3 ulp, and nothing is asked of NaN,
 * infinities and denormals. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <cmocka.h>
#include "../elementary.h"
#include "../../core/turns.h"
#include <string.h>

#if defined(LOBE_TEST_FAST)
#define SLACK 2.0
#else
#define SLACK 1.0
#endif

enum { STRIDE = 9973 }; /* prime: 841 points in every octave, other mantissas in each */

static const lobe_elementary *find(const char *name)
{
    size_t i;
    for (i = 0; i < LOBE_ELEMENTARIES; i++)
        if (strcmp(lobe_elementaries[i].name, name) == 0)
            return &lobe_elementaries[i];
    fail_msg("no function %s", name);
    return NULL;
}

static void check(const char *name, uint32_t witness)
{
    const lobe_elementary *f = find(name);
    lobe_worst worst = {0.0, 0, 0};
    const double allowed = SLACK > 1.0 && f->bound < 1.0 ? 3.0 : SLACK * f->bound;
    uint32_t first = f->first;
#if defined(LOBE_TEST_FAST)
    if (first < 0x00800000u)
        first = 0x00800000u;
#endif
    lobe_measure(f, first, f->last, STRIDE, &worst);
    if (f->both_signs)
        lobe_measure(f, first | 0x80000000u, f->negative_last, STRIDE, &worst);
    lobe_measure(f, f->last, f->last, 1, &worst);
    lobe_measure(f, witness, witness, 1, &worst);
    assert_true(worst.points > 40000);
    if (!(worst.ulp <= allowed))
        fail_msg("%s(%a): %a, want %a, %g ulp over the bound %g", name, (double)lobe_float_of(worst.input),
                 (double)f->got(lobe_float_of(worst.input)), f->want((double)lobe_float_of(worst.input)), worst.ulp,
                 f->bound);
}

/* The witnesses are those of harness/exhaustive.txt. */
static void exp2_bound(void **state)
{
    (void)state;
    check("exp2", 0x3effff4bu);
}

static void log2_bound(void **state)
{
    (void)state;
    check("log2", 0x3f351809u);
}

static void reciprocal_bound(void **state)
{
    (void)state;
    check("reciprocal", 0x00fc3237u);
}

static void sqrt_bound(void **state)
{
    (void)state;
    check("sqrt", 0x017fffffu);
}

static void sqrt_soft_bound(void **state)
{
    (void)state;
    check("sqrt_soft", 0x017fffffu);
}

static void pow5_bound(void **state)
{
    (void)state;
    check("pow5", 0x333ffff1u);
}

/* Exact values that a rounding error may not touch. */
static void exact_points(void **state)
{
    int n;
    (void)state;
    for (n = -126; n <= 127; n++) {
        const float power = ldexpf(1.0f, n);
        assert_true(lobe_exp2((float)n) == power);
        assert_true(lobe_log2(power) == (float)n);
#if !defined(LOBE_TEST_FAST)
        if (n < 127)
            assert_true(lobe_reciprocal(power) == ldexpf(1.0f, -n));
        if (n % 2 == 0)
            assert_true(lobe_sqrt(power) == ldexpf(1.0f, n / 2));
#endif
    }
    assert_true(lobe_pow5(2.0f) == 32.0f && lobe_pow5(-1.0f) == -1.0f && lobe_pow5(0.0f) == 0.0f);
}

/* |x^y - pow| <= LOBE_POW_RELATIVE (1 + |y log2 x|) x^y over a spiral of pairs. */
static void pow_bound(void **state)
{
    int i;
    (void)state;
    for (i = 0; i < 200000; i++) {
        const float x = (float)exp2(fmod(i * 0.6180339887, 1.0) * 40.0 - 20.0);
        const float y = (float)(fmod(i * 0.7548776662, 1.0) * 16.0 - 8.0);
        const double l = y * log2((double)x);
        const double want = pow((double)x, (double)y);
        if (fabs(l) < 125.9)
            assert_true(fabs((double)lobe_pow(x, y) - want) <= SLACK * LOBE_POW_RELATIVE * (1.0 + fabs(l)) * want);
    }
}

static void turns_bound(void **state)
{
    const double circle = 6.283185307179586;
    int i;
    (void)state;
    for (i = -(1 << 25); i <= 1 << 25; i += 61) {
        const float t = (float)i / 16777216.0f;
        assert_true(fabs((double)lobe_sin_turns(t) - sin(circle * (double)t)) <= SLACK * LOBE_SIN_ABSOLUTE);
        assert_true(fabs((double)lobe_cos_turns(t) - cos(circle * (double)t)) <= SLACK * LOBE_COS_ABSOLUTE);
    }
    for (i = 0; i < 500000; i++) {
        const double angle = i * 3.883222077, radius = exp2(i % 41 - 20);
        const float y = (float)(radius * sin(angle)), x = (float)(radius * cos(angle));
        const double want = atan2((double)y, (double)x) / circle;
        assert_true(fabs((double)lobe_atan2_turns(y, x) - want) <= SLACK * LOBE_ATAN2_ABSOLUTE);
    }
    assert_true(lobe_sin_turns(0.0f) == 0.0f && lobe_cos_turns(0.25f) == 0.0f && lobe_cos_turns(1000000.0f) == 1.0f);
    assert_true(lobe_atan2_turns(0.0f, 0.0f) == 0.0f && lobe_atan2_turns(0.0f, -1.0f) == 0.5f);
    assert_true(lobe_atan2_turns(-3.0f, 0.0f) == -0.25f);
}

#if !defined(LOBE_TEST_FAST)
/* What each head comment says about numbers outside the domain. */
static void special_floats(void **state)
{
    const float smallest = 1.17549435e-38f, largest = 3.40282347e+38f;
    const float low[] = {0.0f, -0.0f, 1e-45f, 1e-39f, -1e-39f, -1.0f, -largest, -INFINITY, NAN, -NAN};
    size_t i;
    (void)state;
    for (i = 0; i < sizeof low / sizeof low[0]; i++) {
        assert_true(lobe_log2(low[i]) == -126.0f);
        assert_true(lobe_reciprocal(low[i]) == ldexpf(1.0f, 126));
        if (!(low[i] > 0.0f))
            assert_true(lobe_sqrt(low[i]) == 0.0f);
    }
    assert_true(lobe_exp2(NAN) == 0.0f && lobe_exp2(-INFINITY) == 0.0f && lobe_exp2(-126.5f) == 0.0f);
    assert_true(lobe_exp2(-126.0f) == smallest && lobe_exp2(-largest) == 0.0f);
    assert_true(lobe_exp2(1e-45f) == 1.0f && lobe_exp2(-0.0f) == 1.0f);
    assert_true(lobe_exp2(INFINITY) == lobe_exp2(127.999992f) && lobe_exp2(128.0f) == lobe_exp2(largest));
    assert_true(lobe_exp2(INFINITY) > 3.4e38f && lobe_exp2(INFINITY) <= largest);
    assert_true(lobe_log2(INFINITY) == 128.0f && lobe_log2(largest) == 128.0f);
    assert_true(lobe_reciprocal(INFINITY) == ldexpf(1.0f, -126) && lobe_reciprocal(largest) == ldexpf(1.0f, -126));
    assert_true(lobe_sqrt(INFINITY) == 1.84467429e19f);
    assert_true(lobe_sqrt(1e-45f) == 3.74339207e-23f && lobe_sqrt_soft(1e-45f) == 3.74339207e-23f);
    assert_true(lobe_pow(0.0f, 2.0f) == 0.0f && lobe_pow(0.0f, 0.0f) == 1.0f && lobe_pow(NAN, 0.0f) == 1.0f);
    assert_true(lobe_pow(2.0f, INFINITY) <= largest && lobe_pow(0.5f, NAN) == 0.0f);
    assert_true(fabsf(lobe_sin_turns(NAN)) <= 1.0f && fabsf(lobe_cos_turns(INFINITY)) <= 1.0f);
    assert_true(fabsf(lobe_atan2_turns(NAN, 1.0f)) <= 0.5f && fabsf(lobe_atan2_turns(1.0f, NAN)) <= 0.5f);
    assert_true(fabsf(lobe_atan2_turns(INFINITY, INFINITY)) <= 0.5f);
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exp2_bound),
        cmocka_unit_test(log2_bound),
        cmocka_unit_test(reciprocal_bound),
        cmocka_unit_test(sqrt_bound),
        cmocka_unit_test(sqrt_soft_bound),
        cmocka_unit_test(pow5_bound),
        cmocka_unit_test(exact_points),
        cmocka_unit_test(pow_bound),
        cmocka_unit_test(turns_bound),
#if !defined(LOBE_TEST_FAST)
        cmocka_unit_test(special_floats),
#endif
    };
    return cmocka_run_group_tests_name("elementary functions", tests, NULL, NULL);
}
