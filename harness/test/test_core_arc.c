/* Angles and circular segments of the first quadrant against libm in long double, near the axes and between, and the
 * points where the worst errors were found. Compiled a second time in double. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include "../../core/arc.h"
#include <float.h>
#include <math.h>

#if defined(LOBE_DOUBLE)
#define UNITS (DBL_EPSILON / FLT_EPSILON * 16) /* what libm leaves of a double, and a short series */
#else
#define UNITS 1.0
#endif

static const long double pi = 3.14159265358979323846264L;
static uint64_t random_state = 1;

static double random_unit(void)
{
    random_state = random_state * 6364136223846793005u + 1442695040888963407u;
    return (double)(random_state >> 11) * 0x1p-53;
}

/* In units of 2^-24 of the binade that holds the true value. */
static double ulp(lobe_real got, long double want)
{
    int exponent;
    frexp((double)want, &exponent);
    return fabs((double)((long double)got - want)) / ldexp(1.0, exponent - 24);
}

/* t - sin t cos t by its series where that difference loses digits. */
static long double segment(long double t)
{
    long double term = 2 * t * t * t / 3, sum = 0;
    int k;
    if (t > 0.5L)
        return t - sinl(t) * cosl(t);
    for (k = 2; k < 30; k++) {
        sum += term;
        term *= -4 * t * t / ((2 * k) * (2 * k + 1));
    }
    return sum;
}

static void check(lobe_real y, lobe_real x)
{
    const long double t = atan2l((long double)y, (long double)x);
    const double of_arc = ulp(lobe_arc(y, x), t / pi), of_segment = ulp(lobe_arc_segment(y, x), segment(t) / pi);
    if (!(of_arc <= UNITS * LOBE_ARC_ULP && of_segment <= UNITS * LOBE_ARC_SEGMENT_ULP))
        fail_msg("at y = %a, x = %a: arc %g ulp, segment %g ulp", (double)y, (double)x, of_arc / UNITS,
                 of_segment / UNITS);
}

static void within_the_bounds(void **state)
{
    int i;
    (void)state;
    for (i = 0; i < 2000000; i++) {
        const lobe_real a = (lobe_real)(1e-6 + random_unit());
        const lobe_real b = (lobe_real)(i & 1 ? 1e-6 + random_unit() : ldexp(1 + random_unit(), -(i % 24)));
        check(i & 2 ? a : b, i & 2 ? b : a);
    }
    check((lobe_real)0x1.168adp-1, (lobe_real)0x1.1cea98p-1);
    check((lobe_real)0x1.fb6dc4p-1, (lobe_real)0x1.f7407p-1);
    for (i = -12; i <= 12; i++) /* next to 45 degrees */
        check((lobe_real)(0.7 + i * 6e-8), (lobe_real)0.7);
}

static void ends(void **state)
{
    const lobe_real zero = 0, one = 1, half = (lobe_real)0.5;
    (void)state;
    assert_true(lobe_arc(zero, one) == zero && lobe_arc(one, zero) == half && lobe_arc(zero, zero) == zero);
    assert_true(lobe_arc_segment(zero, one) == zero && lobe_arc_segment(one, zero) == half);
    assert_true(lobe_arc_segment(zero, zero) == zero);
    assert_true(lobe_arc((lobe_real)NAN, one) >= zero && lobe_arc(one, (lobe_real)NAN) <= half);
    assert_true(lobe_arc_segment((lobe_real)NAN, one) >= zero && lobe_arc_segment(one, (lobe_real)NAN) <= half);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(within_the_bounds),
        cmocka_unit_test(ends),
    };
    return cmocka_run_group_tests_name("core arc", tests, NULL, NULL);
}
