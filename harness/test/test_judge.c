/* The judge itself, on a function whose answers are known: it must find what is wrong, and where. */
#include "../conform_core.h"
#include "cmocka_first.h"

static float answer[2];

static void fixed(const lobe_value *in, lobe_value *out)
{
    (void)in;
    out[0].f = answer[0];
    out[1].f = answer[1];
}

static const lobe_range ranges[] = {{0.125, 1, 0, 1}, {0.125, 1, 0, 1}};
static const lobe_entry entry = {"m",  "t", "fixed", LOBE_F32, 2,   2,      "a b", "c d", 1, fixed,
                                 NULL, 1,   0.25,    0.1,      0.5, ranges, NULL,  0,     0};
/* Three rows: two inside the domain, and one below it. */
static const uint32_t inputs[] = {0x3f000000, 0x3f000000, 0x3f800000, 0x3e000000, 0x3f800000, 0x3d800000};
static const double truths[] = {0.5, 0.25, 0.5, 0.25, 0.5, 0.25};
static const lobe_vectors vectors = {"m", "t", LOBE_F32, 2, 2, 3, inputs, truths, 1.0, 1.0, 0.0};

static lobe_verdict judge(float c, float d)
{
    answer[0] = c;
    answer[1] = d;
    return lobe_judge(&entry, &vectors);
}

static void passes_at_the_bound(void **state)
{
    const lobe_verdict v = judge(0.75f, 0.125f);
    (void)state;
    assert_int_equal(v.inside.rows, 2);
    assert_int_equal(v.inside.passed, 2);
    assert_int_equal(v.below.rows, 1);
    assert_int_equal(v.below.passed, 1);
    assert_true(v.inside.worst == 0.25);
    assert_int_equal(v.inside.output, 0);
    assert_true(v.inside.squares[0] == 0.125 && v.inside.squares[1] == 0.03125);
}

static void breaks_beyond_it(void **state)
{
    const lobe_verdict v = judge(0.5f, 0.505f);
    (void)state;
    assert_int_equal(v.inside.passed, 0);
    assert_int_equal(v.inside.output, 1);
    assert_int_equal(v.below.passed, 1); /* below the domain half is allowed */
}

/* Both outputs keep the bound and their sum does not. */
static void holds_the_sum_to_the_bound(void **state)
{
    const lobe_verdict v = judge(0.7f, 0.45f);
    (void)state;
    assert_int_equal(v.inside.passed, 0);
    assert_int_equal(v.inside.output, 2);
    assert_int_equal(v.inside.row, 0);
}

/* Taps: the one truth is that of the sum of every second output, and the others may be anything. */
static void holds_only_the_sum_of_every_nth(void **state)
{
    lobe_entry taps = entry;
    lobe_vectors sums = vectors; /* the rows inside have the truths .5 and .25 */
    lobe_value out[2];
    (void)state;
    taps.sums = 0;
    taps.nth = 2;
    taps.prefilter = "k";
    sums.outputs = 1;
    assert_int_equal(lobe_truth_count(&taps), 1);
    assert_string_equal(lobe_truth_names(&taps), "E");
    answer[0] = 100.0f;
    answer[1] = 0.5f;
    assert_int_equal(lobe_judge(&taps, &sums).inside.passed, 2);
    answer[1] = 0.7f;
    assert_int_equal(lobe_judge(&taps, &sums).inside.passed, 1);
    answer[1] = 0.9f;
    assert_int_equal(lobe_judge(&taps, &sums).inside.passed, 0);
    taps.format = LOBE_Q30; /* Q16.16 where the mask says so */
    taps.q16 = 2;
    out[0].q = out[1].q = 1 << 16;
    assert_true(lobe_output_real(&taps, 0, out[0]) == 0x1p-14 && lobe_answer(&taps, 0, out) == 1.0);
}

static void breaks_on_nan_and_infinity(void **state)
{
    const float bad[] = {__builtin_nanf(""), __builtin_inff(), -__builtin_inff()};
    int i;
    (void)state;
    for (i = 0; i < 3; i++) {
        lobe_verdict v = judge(0.5f, bad[i]);
        assert_int_equal(v.inside.passed, 0);
        assert_int_equal(v.below.passed, 0);
        assert_true(v.inside.worst == LOBE_NOT_FINITE);
        v = judge(bad[i], 0.25f);
        assert_int_equal(v.inside.passed, 0);
    }
}

/* The smaller of the two stated bounds holds: the library's header and the file must both be true. */
static void the_smaller_bound_holds(void **state)
{
    lobe_vectors tight = vectors;
    lobe_verdict v;
    (void)state;
    answer[0] = 0.625f;
    answer[1] = 0.25f;
    tight.bound_max = 0.0625;
    v = lobe_judge(&entry, &tight);
    assert_true(v.inside.bound == 0.0625);
    assert_int_equal(v.inside.passed, 0);
    tight.bound_max = 2.0;
    v = lobe_judge(&entry, &tight);
    assert_true(v.inside.bound == 0.25);
    assert_int_equal(v.inside.passed, 2);
}

/* Where E is the one output its reciprocal is judged too: .25 for .2 is small as an error and large in a furnace. */
static void holds_the_furnace_to_its_bound(void **state)
{
    static const double energies[] = {0.2, 0.8};
    static const uint32_t at[] = {0x3f000000, 0x3f000000, 0x3f800000, 0x3f800000};
    lobe_entry energy = entry;
    lobe_vectors rows = {"m", "t", LOBE_F32, 2, 1, 2, at, energies, 1.0, 0.0, 0.0};
    lobe_verdict v;
    (void)state;
    energy.outputs = 1;
    energy.sums = 0;
    energy.max = 1.0;
    answer[0] = 0.25f;
    v = lobe_judge(&energy, &rows);
    assert_int_equal(v.inside.passed, 2);
    rows.bound_furnace = 1.0;
    v = lobe_judge(&energy, &rows);
    assert_int_equal(v.inside.passed, 1);
    assert_true(v.inside.furnace > 2.1999 && v.inside.furnace < 2.2001);
    answer[0] = 0.0f;
    v = lobe_judge(&energy, &rows);
    assert_int_equal(v.inside.passed, 0);
}

/* Either end of either input may be where the domain ends; the ends belong to it. */
static void knows_the_domain(void **state)
{
    static const struct {
        float a, b;
        int in;
    } places[] = {{0.125f, 0.125f, 1}, {1.0f, 0.75f, 1},      {0.1249f, 0.5f, 0}, {0.5f, 0.1249f, 0},
                  {1.0001f, 0.5f, 0},  {0.5f, 0.7500001f, 0}, {0.5f, -1.0f, 0},   {__builtin_nanf(""), 0.5f, 0}};
    static const lobe_range narrow[] = {{0.125, 1, 0, 1}, {0.125, 0.75, 0, 1}};
    lobe_entry e = entry;
    size_t i;
    (void)state;
    e.ranges = narrow;
    for (i = 0; i < sizeof places / sizeof places[0]; i++) {
        lobe_value in[2];
        in[0].f = places[i].a;
        in[1].f = places[i].b;
        assert_int_equal(lobe_in_domain(&e, in), places[i].in);
    }
}

static void converts_numbers(void **state)
{
    (void)state;
    assert_int_equal(lobe_value_nearest(LOBE_Q30, 1.0).q, 1 << 30);
    assert_int_equal(lobe_value_nearest(LOBE_Q30, 2.0).q, INT32_MAX);
    assert_int_equal(lobe_value_nearest(LOBE_Q30, -2.0).q, INT32_MIN);
    assert_int_equal(lobe_value_nearest(LOBE_Q30, 1e300).q, INT32_MAX);
    assert_int_equal(lobe_value_nearest(LOBE_Q30, -__builtin_inf()).q, INT32_MIN);
    assert_int_equal(lobe_value_nearest(LOBE_Q30, __builtin_nan("")).q, 0);
    assert_int_equal(lobe_value_nearest(LOBE_Q30, 1.5 * 0x1p-30).q, 2);
    assert_int_equal(lobe_value_nearest(LOBE_Q30, -1.5 * 0x1p-30).q, -2);
    assert_int_equal(lobe_value_nearest(LOBE_Q30, 0.4 * 0x1p-30).q, 0);
    assert_int_equal(lobe_value_nearest(LOBE_F32, 0.1).bits, 0x3dcccccd);
    assert_int_equal(lobe_value_nearest(LOBE_F32, 1e39).bits, 0x7f800000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(passes_at_the_bound),
        cmocka_unit_test(breaks_beyond_it),
        cmocka_unit_test(holds_the_sum_to_the_bound),
        cmocka_unit_test(breaks_on_nan_and_infinity),
        cmocka_unit_test(holds_only_the_sum_of_every_nth),
        cmocka_unit_test(the_smaller_bound_holds),
        cmocka_unit_test(knows_the_domain),
        cmocka_unit_test(converts_numbers),
        cmocka_unit_test(holds_the_furnace_to_its_bound),
    };
    return cmocka_run_group_tests_name("judge", tests, NULL, NULL);
}
