/* The fixed-point primitives against plain 64-bit arithmetic with real division. Compiled a second time with
 * LOBE_Q_HALVES and LOBE_Q_NO_CLZ, the spellings of Cortex-M0. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <cmocka.h>
#include "../../core/q30_log2.h"
#include "../../core/q30_sqrt.h"
#include <math.h>

static uint64_t random_state = 1;

static uint32_t random_bits(void)
{
    random_state = random_state * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)(random_state >> 32);
}

/* Numbers of every size, and often the ends. */
static int32_t random_int(void)
{
    static const int32_t ends[] = {INT32_MIN, INT32_MIN + 1, -65536, -65535,  -1,       0,
                                   1,         32767,         65535,  1 << 30, INT32_MAX};
    const uint32_t r = random_bits();
    return r % 5 == 0 ? ends[(r >> 8) % 11] : (int32_t)random_bits() / (int32_t)(1u << (r >> 8) % 31);
}

/* floor(numerator / 2^shift + 1/2), by division. */
static int64_t rounded(int64_t numerator, int shift)
{
    const int64_t unit = (int64_t)1 << shift;
    int64_t quotient = numerator / unit, rest = numerator % unit;
    if (rest < 0) {
        rest += unit;
        quotient--;
    }
    return quotient + (rest >= unit - rest ? 1 : 0);
}

static void multiply_rounds_to_nearest(void **state)
{
    int i, fits = 0;
    (void)state;
    for (i = 0; i < 3000000; i++) {
        const int32_t a = random_int(), b = random_int();
        const int shift = (int)(random_bits() % 63);
        const int64_t want = rounded((int64_t)a * b, shift);
        if (want < INT32_MIN || want > INT32_MAX)
            continue;
        fits++;
        assert_int_equal(lobe_q_mul(a, b, shift), want);
        assert_int_equal(lobe_q_mul_wide(a, b, shift), want);
        assert_int_equal(lobe_q_mul_halves(a, b, shift), want);
    }
    assert_true(fits > 1000000);
    assert_int_equal(lobe_q_mul(LOBE_Q30_ONE, 12345, 30), 12345);
    assert_int_equal(lobe_q_mul(3, 1, 1), 2); /* ties go up */
    assert_int_equal(lobe_q_mul(-3, 1, 1), -1);
}

static void shift_rounds_to_nearest(void **state)
{
    int i;
    (void)state;
    for (i = 0; i < 1000000; i++) {
        const int32_t a = random_int();
        const int n = (int)(random_bits() % 32);
        assert_int_equal(lobe_q_shift_right(a, n), rounded(a, n));
    }
}

static int64_t held(int64_t x) { return x < INT32_MIN ? INT32_MIN : x > INT32_MAX ? INT32_MAX : x; }

static void saturation_holds_the_ends(void **state)
{
    int i;
    (void)state;
    for (i = 0; i < 1000000; i++) {
        const int32_t a = random_int(), b = random_int();
        const int n = (int)(random_bits() % 31);
        assert_int_equal(lobe_q_add_saturated(a, b), held((int64_t)a + b));
        assert_int_equal(lobe_q_subtract_saturated(a, b), held((int64_t)a - b));
        assert_int_equal(lobe_q_shift_left_saturated(a, n), held((int64_t)a * ((int64_t)1 << n)));
        assert_int_equal(lobe_q30_from_q16(a), held((int64_t)a * 16384));
        assert_int_equal(lobe_q16_from_q30(a), rounded(a, 14));
        assert_int_equal(lobe_q_saturate(a), a < 0 ? 0 : a > 1073741824 ? 1073741824 : a);
    }
}

static void check_reciprocal(int32_t x)
{
    const lobe_q_inverse inverse = lobe_q_reciprocal(x);
    int z = 0;
    uint64_t m = (uint64_t)x;
    while (m < (uint64_t)1 << 30) {
        m *= 2;
        z++;
    }
    assert_int_equal(lobe_q_headroom(x), z);
    assert_int_equal(inverse.shift, 60 - z);
    assert_int_equal(inverse.mantissa, (((uint64_t)1 << 61) / m + 1) / 2);
    assert_true(fabs(ldexp((double)inverse.mantissa, -inverse.shift) * x - 1.0) <= 0x1p-30);
}

static void reciprocal_is_exact(void **state)
{
    int32_t x;
    int i;
    (void)state;
    for (x = 1; x < 70000; x++)
        check_reciprocal(x);
    for (x = 70000; x < INT32_MAX - 2003; x += 2003)
        check_reciprocal(x);
    for (i = 0; i < 31; i++)
        check_reciprocal((int32_t)1 << i);
    check_reciprocal(INT32_MAX);
    assert_int_equal(lobe_q_reciprocal(0).mantissa, lobe_q_reciprocal(1).mantissa);
    assert_int_equal(lobe_q_reciprocal(INT32_MIN).shift, lobe_q_reciprocal(1).shift);
}

static void quotients_stay_in_bound(void **state)
{
    double worst = 0.0;
    int i;
    (void)state;
    for (i = 0; i < 2000000; i++) {
        const int32_t d = (int32_t)(random_bits() >> (1 + random_bits() % 30)) + 1;
        const int32_t size = (int32_t)(random_bits() % ((uint32_t)d + 1u));
        const int32_t n = i & 1 ? -size : size;
        const lobe_q_inverse inverse = lobe_q_reciprocal(d);
        const double error = fabs((double)lobe_q_ratio(n, inverse) - ldexp((double)n / d, 30));
        worst = error > worst ? error : worst;
    }
    assert_true(worst <= 1.5);
    for (i = 0; i < 1000000; i++) {
        const int32_t n = random_int(), d = (int32_t)(random_bits() >> (1 + random_bits() % 30)) + 1;
        const int fraction = (int)(random_bits() % 31);
        const double exact = ldexp((double)n / d, fraction);
        const double want = exact > 2147483647.0 ? 2147483647.0 : exact < -2147483648.0 ? -2147483648.0 : exact;
        const double got = (double)lobe_q_quotient(n, lobe_q_reciprocal(d), fraction);
        assert_true(fabs(got - want) <= 0.5 + fabs(want) * 0x1p-30);
    }
}

/* Against the double logarithm: all small numbers, then a stride prime to every power of two, then the ends. */
static void log2_stays_in_bound(void **state)
{
    double worst = 0.0;
    int64_t x;
    int n;
    (void)state;
    for (x = 1; x <= INT32_MAX; x += x < 70000 ? 1 : 1999)
        worst = fmax(worst, fabs(lobe_q_log2((int32_t)x) / 67108864.0 - log2((double)x)));
    if (!(worst <= LOBE_Q_LOG2_ERROR))
        fail_msg("log2 is %g off", worst);
    for (n = 0; n <= 30; n++)
        assert_int_equal(lobe_q_log2((int32_t)1 << n), n * 67108864);
    assert_int_equal(lobe_q_log2(0), 0);
    assert_int_equal(lobe_q_log2(INT32_MIN), 0);
}

/* Every number up to 2^18, where the root is steepest, powers of two and their neighbours, and 2 million others. */
static void check_root(int32_t x)
{
    const double want = sqrt(x * 1073741824.0), got = lobe_q_sqrt(x);
    if (!(fabs(got - want) <= 3.0))
        fail_msg("root of %08x: got %.0f, want %.3f", (unsigned)x, got, want);
}

static void root_stays_in_bound(void **state)
{
    int32_t x;
    int i;
    (void)state;
    for (x = 0; x <= 1 << 18; x++)
        check_root(x);
    for (i = 2; i <= 30; i++) {
        check_root((1 << i) - 1);
        check_root(1 << i);
        check_root(i < 30 ? (1 << i) + 1 : 3 << 28);
    }
    for (i = 0; i < 2000000; i++)
        check_root((int32_t)(random_bits() >> 2 >> random_bits() % 24));
    assert_int_equal(lobe_q_sqrt(0), 0);
    assert_int_equal(lobe_q_sqrt(-1), 0);
    assert_int_equal(lobe_q_sqrt(INT32_MIN), 0);
    assert_int_equal(lobe_q_sqrt(INT32_MAX), lobe_q_sqrt(LOBE_Q30_ONE));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(multiply_rounds_to_nearest), cmocka_unit_test(shift_rounds_to_nearest),
        cmocka_unit_test(saturation_holds_the_ends),  cmocka_unit_test(reciprocal_is_exact),
        cmocka_unit_test(quotients_stay_in_bound),    cmocka_unit_test(log2_stays_in_bound),
        cmocka_unit_test(root_stays_in_bound),
    };
    return cmocka_run_group_tests_name("fixed point", tests, NULL, NULL);
}
