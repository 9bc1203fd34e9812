/* The hash must see every bit of every output, and its inputs must go where functions break. */
#include "../hash.h"
#include "cmocka_first.h"
#include <math.h>

static uint32_t calls, flip_at, flip_output, flip_bits;

/* Outputs that depend on nothing but the number of the call. */
static void counted(const lobe_value *in, lobe_value *out)
{
    uint32_t k;
    (void)in;
    for (k = 0; k < 3; k++)
        out[k].bits = 0x9e3779b9u * (3 * calls + k) ^ (calls == flip_at && k == flip_output ? flip_bits : 0u);
    calls++;
}

static const lobe_range units[] = {{0, 1, 0, 1}, {0, 1, 0, 1}};
static const lobe_entry entry = {"m", "t",     "counted", LOBE_F32, 2, 3, "a b", "c d e",
                                 0,   counted, NULL,      1,        1, 1, 1,     units,   NULL, 0, 0};

static uint64_t hash_with(uint32_t at, uint32_t output, uint32_t bits)
{
    calls = 0;
    flip_at = at;
    flip_output = output;
    flip_bits = bits;
    return lobe_hash_entry(&entry, 1000);
}

static void sees_every_bit(void **state)
{
    const uint64_t plain = hash_with(0, 0, 0);
    uint32_t output, bit;
    (void)state;
    assert_true(hash_with(5, 1, 0) == plain);
    for (output = 0; output < 3; output++) {
        for (bit = 0; bit < 32; bit++) {
            assert_true(hash_with(0, output, 1u << bit) != plain);
            assert_true(hash_with(999, output, 1u << bit) != plain);
        }
    }
    assert_int_equal(calls, 1000);
}

/* The bytes that FNV-1a gets, spelled out: every output's bits, the lowest byte first. */
static void is_fnv1a_of_the_outputs(void **state)
{
    unsigned char bytes[12 * 10];
    uint32_t i, k;
    (void)state;
    for (i = 0; i < 30; i++)
        for (k = 0; k < 4; k++)
            bytes[4 * i + k] = (unsigned char)(0x9e3779b9u * i >> 8 * k);
    calls = 0;
    flip_bits = 0;
    assert_true(lobe_hash_entry(&entry, 10) == lobe_fnv1a(LOBE_FNV_START, bytes, sizeof bytes));
}

static void float_inputs(void **state)
{
    int nan = 0, infinite = 0, negative_zero = 0, denormal = 0, tiny = 0, ends = 0, inside = 0;
    uint32_t i;
    (void)state;
    for (i = 0; i < LOBE_HASH_COUNT; i++) {
        lobe_value in[LOBE_MAX_INPUTS];
        lobe_hash_inputs(&entry, i, in);
        nan += isnan(in[0].f) || isnan(in[1].f);
        infinite += isinf(in[1].f) != 0;
        negative_zero += in[0].bits == 0x80000000u;
        denormal += fpclassify(in[0].f) == FP_SUBNORMAL;
        tiny += in[0].f > 0.0f && in[0].f < 1e-4f;
        ends += in[0].f == 1.0f && in[1].f == 1.0f;
        inside += in[0].f >= 0.0f && in[0].f <= 1.0f && in[1].f >= 0.0f && in[1].f <= 1.0f;
    }
    assert_true(nan > 0 && infinite > 0 && negative_zero > 0 && denormal > 0 && tiny > 100 && ends > 0);
    assert_true(inside > LOBE_HASH_COUNT * 9 / 10);
}

static void integer_inputs(void **state)
{
    lobe_entry q30 = entry;
    int least = 0, most = 0, negative = 0, above = 0, ends = 0, inside = 0;
    uint32_t i;
    (void)state;
    q30.format = LOBE_Q30;
    for (i = 0; i < LOBE_HASH_COUNT; i++) {
        lobe_value in[LOBE_MAX_INPUTS];
        lobe_hash_inputs(&q30, i, in);
        least += in[0].q == INT32_MIN;
        most += in[1].q == INT32_MAX;
        negative += in[0].q < 0;
        above += in[0].q > 1 << 30;
        ends += in[0].q == 1 << 30 && in[1].q == 1 << 30;
        inside += in[0].q >= 0 && in[0].q <= 1 << 30 && in[1].q >= 0 && in[1].q <= 1 << 30;
    }
    assert_true(least > 0 && most > 0 && negative > 100 && above > 100 && ends > 0);
    assert_true(inside > LOBE_HASH_COUNT * 9 / 10);
}

/* An input that has a sign gets both, and the same spread on each side; nine inputs are nine streams. */
static void signs_and_many_inputs(void **state)
{
    static const lobe_range ranges[9] = {{0, 1, 0, 1}, {-1, 1, -1, 1}, {0, 1, 0, 1}, {0, 1, 0, 1},  {0, 1, 0, 1},
                                         {0, 1, 0, 1}, {0, 1, 0, 1},   {0, 1, 0, 1}, {-1, 1, -1, 1}};
    lobe_entry many = entry;
    int format, j, k;
    (void)state;
    many.inputs = 9;
    many.ranges = ranges;
    for (format = 0; format < LOBE_FORMATS; format++) {
        int quarter[4] = {0}, same = 0;
        uint32_t i;
        many.format = (lobe_format)format;
        for (i = 256; i < 256 + 16 * 1000; i++) {
            lobe_value in[LOBE_MAX_INPUTS], next[LOBE_MAX_INPUTS];
            if (i % 16 >= 14)
                continue;
            lobe_hash_inputs(&many, i, in);
            lobe_hash_inputs(&many, i + 1, next);
            assert_true(lobe_value_real(many.format, in[0]) >= 0.0);
            quarter[(int)(lobe_value_real(many.format, in[8]) * 2.0 + 2.0)]++;
            for (j = 0; j < 9; j++)
                for (k = 0; k < 9; k++)
                    same += (j != k && in[j].bits == in[k].bits) || in[j].bits == next[k].bits;
        }
        for (k = 0; k < 4; k++)
            assert_in_range(quarter[k], 3300, 3700); /* 3500 expected, 51 is one standard deviation */
        assert_true(same < 20);                      /* 17 in 2^24 by chance */
    }
}

/* Both halves of the unit interval, and the whole of it, are met about equally often. */
static void inputs_are_spread(void **state)
{
    int counts[16] = {0};
    uint32_t i;
    int k;
    (void)state;
    for (i = 256; i < 256 + 16 * 1000; i++) {
        lobe_value in[LOBE_MAX_INPUTS];
        if (i % 16 >= 14)
            continue;
        lobe_hash_inputs(&entry, i, in);
        counts[(int)(in[0].f * 4.0f) * 4 + (int)(in[1].f * 4.0f)]++;
    }
    for (k = 0; k < 16; k++)
        assert_true(counts[k] > 750 && counts[k] < 1000); /* 875 expected, 28 is one standard deviation */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sees_every_bit),    cmocka_unit_test(is_fnv1a_of_the_outputs),
        cmocka_unit_test(float_inputs),      cmocka_unit_test(integer_inputs),
        cmocka_unit_test(inputs_are_spread), cmocka_unit_test(signs_and_many_inputs),
    };
    return cmocka_run_group_tests_name("hash", tests, NULL, NULL);
}
