/* Numbers with a block exponent against double. Compiled a second time with LOBE_Q_HALVES and LOBE_Q_NO_CLZ, the
 * spellings of Cortex-M0. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <cmocka.h>
#include "../../core/q30_scaled.h"
#include <math.h>

static uint64_t random_state = 1;

static uint32_t random_bits(void)
{
    random_state = random_state * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)(random_state >> 32);
}

/* Of every size, and often the ends: 2^31 - 2 is the largest that is allowed. */
static int32_t random_mantissa(void)
{
    static const int32_t ends[] = {-2147483646, -1073741824, -1073741823, -536870912, -1,         0,
                                   1,           536870911,   536870912,   1073741823, 1073741824, 2147483646};
    const uint32_t r = random_bits();
    const int32_t m = (int32_t)random_bits() / (int32_t)(1u << (r >> 8) % 31);
    return r % 4 == 0 ? ends[(r >> 8) % 12] : lobe_q_clamp(m, -2147483646, 2147483646);
}

static lobe_q_scaled random_number(void) { return lobe_qs_of(random_mantissa(), (int32_t)(random_bits() % 90) - 45); }

static double value(lobe_q_scaled a) { return ldexp(a.m, a.e - 30); }

static void assert_normal(lobe_q_scaled a)
{
    const int32_t size = a.m < 0 ? -a.m : a.m;
    if (size == 0)
        assert_true(a.e <= LOBE_QS_ZERO / 2);
    else
        assert_true(size >= 1 << 29 && size < 1 << 30);
}

/* got is within bound of want, relative to scale. */
static void check(const char *what, lobe_q_scaled got, double want, double scale, double bound)
{
    assert_normal(got);
    if (!(fabs(value(got) - want) <= bound * scale))
        fail_msg("%s: got %.17g, want %.17g", what, value(got), want);
}

static void arithmetic_stays_in_bound(void **state)
{
    int i;
    (void)state;
    for (i = 0; i < 3000000; i++) {
        const lobe_q_scaled a = random_number(), b = random_number();
        const double x = value(a), y = value(b), larger = fmax(fabs(x), fabs(y));
        check("product", lobe_qs_mul(a, b), x * y, fabs(x * y), 0x1p-29);
        check("sum", lobe_qs_add(a, b), x + y, larger, 0x1p-28);
        check("difference", lobe_qs_sub(a, b), x - y, larger, 0x1p-28);
        check("thrice", lobe_qs_thrice(a), 3 * x, fabs(3 * x), 0x1p-28);
        check("root", lobe_qs_sqrt(a), sqrt(fmax(x, 0.0)), sqrt(fabs(x)), 0x1p-28);
        check("positive", lobe_qs_positive(a), fmax(x, 0.0), 1.0, 0.0);
        assert_int_equal(lobe_qs_less(a, b), x < y);
        if (b.m != 0)
            check("quotient", lobe_qs_div(a, b), x / y, fabs(x / y), 0x1p-28);
    }
}

static void integers_are_exact(void **state)
{
    int i;
    (void)state;
    for (i = 0; i < 1000000; i++) {
        const int32_t m = random_mantissa();
        check("of", lobe_qs_of(m, 30), m, m < -1073741824 || m > 1073741824 ? 1.0 : 0.0, 1.0);
    }
    for (i = -40; i <= 40; i += 2) {
        const lobe_q_scaled power = {1 << 29, i};
        check("root of a power of 4", lobe_qs_sqrt(lobe_qs_mul(power, power)), value(power), value(power), 0x1p-28);
        check("half of a power of 4", lobe_qs_div(lobe_qs_mul(power, power), power), value(power), 0.0, 0.0);
    }
}

static void fixed_rounds_and_saturates(void **state)
{
    int i;
    (void)state;
    for (i = 0; i < 1000000; i++) {
        const lobe_q_scaled a = random_number();
        const int bits = (int)(random_bits() % 41);
        const double want = floor(ldexp(value(a), bits) + 0.5);
        assert_true(lobe_qs_fixed(a, bits) == fmin(fmax(want, -2147483648.0), 2147483647.0));
    }
    assert_int_equal(lobe_qs_fixed(lobe_qs_of(0, 100), 30), 0);
}

/* Zero is smaller than everything, adds nothing, and divides into something large. */
static void zero(void **state)
{
    const lobe_q_scaled nothing = lobe_qs_of(0, 20), small = {1 << 29, -400}, one = {1 << 29, 1};
    (void)state;
    assert_int_equal(lobe_qs_add(nothing, small).m, small.m);
    assert_int_equal(lobe_qs_add(small, lobe_qs_mul(nothing, nothing)).e, small.e);
    assert_int_equal(lobe_qs_sub(small, small).m, 0);
    assert_int_equal(lobe_qs_less(nothing, small), 1);
    assert_int_equal(lobe_qs_mul(nothing, one).m, 0);
    assert_int_equal(lobe_qs_div(nothing, nothing).m, 0);
    assert_true(value(lobe_qs_div(one, nothing)) >= 1e30);
}

static void constants_are_nearest(void **state)
{
    static const lobe_q_scaled constants[] = {LOBE_QS_CONSTANT(5.74969934f), LOBE_QS_CONSTANT(-0.0820573521f),
                                              LOBE_QS_CONSTANT(1.0),         LOBE_QS_CONSTANT(-0.5),
                                              LOBE_QS_CONSTANT(0.000244141), LOBE_QS_CONSTANT(255.99)};
    static const double values[] = {5.74969934f, -0.0820573521f, 1.0, -0.5, 0.000244141, 255.99};
    static const lobe_q_scaled none[] = {LOBE_QS_CONSTANT(0.0), LOBE_QS_CONSTANT(-0.0002)};
    int i;
    (void)state;
    for (i = 0; i < 6; i++)
        check("constant", constants[i], values[i], fabs(values[i]), 0x1p-30);
    assert_int_equal(none[0].m | none[1].m, 0);
    assert_int_equal(none[0].e & none[1].e, LOBE_QS_ZERO);
    assert_int_equal(LOBE_Q_CONSTANT(-1.25f, 28), -335544320);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(arithmetic_stays_in_bound),  cmocka_unit_test(integers_are_exact),
        cmocka_unit_test(fixed_rounds_and_saturates), cmocka_unit_test(zero),
        cmocka_unit_test(constants_are_nearest),
    };
    return cmocka_run_group_tests_name("block exponents", tests, NULL, NULL);
}
