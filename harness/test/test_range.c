/* Every function at every special number, and densely: outputs are finite and in [0, 1], and so is E where they add up
 * to it. */
#include "../hash.h"
#include "../registry.h"
#include "cmocka_first.h"

static const uint32_t floats[] = {
    0x00000000, 0x80000000, 0x00000001, 0x80000001, 0x007fffff, 0x807fffff, 0x00800000, 0x80800000, 0x0da24260,
    0x33800000, 0x358637bd, 0x3a83126f, 0x3ca3d709, 0x3ca3d70a, 0x3ca3d70b, 0x3e99999a, 0x3f000000, 0x3f7fffff,
    0x3f800000, 0x3f800001, 0xbf800000, 0x40000000, 0xc0000000, 0x5f3759df, 0xdf3759df, 0x7f7fffff, 0xff7fffff,
    0x7f800000, 0xff800000, 0x7fc00000, 0xffc00000, 0x7f800001, 0xffbfffff,
};
static const int32_t integers[] = {
    INT32_MIN,
    INT32_MIN + 1,
    -(1 << 30) - 1,
    -(1 << 30),
    -(1 << 30) + 1,
    -65536,
    -2,
    -1,
    0,
    1,
    2,
    63,
    64,
    32767,
    65535,
    65536,
    21474836,
    1 << 29,
    (1 << 30) - 64,
    (1 << 30) - 1,
    1 << 30,
    (1 << 30) + 1,
    INT32_MAX - 1,
    INT32_MAX,
};

static void check_outputs(const lobe_entry *e, const lobe_value *in)
{
    lobe_value out[LOBE_MAX_OUTPUTS];
    float sum_f = 0.0f;
    int64_t sum_q = 0;
    int k, good = 1;
    e->call(in, out);
    for (k = 0; k < e->outputs; k++) {
        const double x = lobe_output_real(e, k, out[k]);
        if (e->nth) { /* angles, widths and weights that may be negative: test_env_lobes.c */
            good &= x - x == 0.0;
            continue;
        }
        good &= x >= 0.0 && x <= 1.0;
        if (e->format == LOBE_F32)
            sum_f += out[k].f;
        else
            sum_q += out[k].q;
    }
    if (e->sums)
        good &= sum_f >= 0.0f && sum_f <= 1.0f && sum_q >= 0 && sum_q <= 1 << 30;
    if (good)
        return;
    for (k = 0; k < e->inputs; k++)
        print_error("input %d: %08x\n", k, (unsigned)in[k].bits);
    fail_msg("%s gives %08x %08x", e->kernel, (unsigned)out[0].bits, e->outputs > 1 ? (unsigned)out[1].bits : 0u);
}

/* What the other inputs are while two of them are looked at; with two inputs there are no others. */
enum { OTHERS = 12 };

static void others(const lobe_entry *e, uint32_t which, lobe_value *in)
{
    lobe_hash_inputs(e, 256 + 16 * which + (which & 1 ? 14 : 0), in);
}

/* Calls visit for every pair of inputs, with everything that the others are. */
static void for_pairs(const lobe_entry *e, void (*visit)(const lobe_entry *e, lobe_value *in, int j, int k))
{
    lobe_value in[LOBE_MAX_INPUTS];
    uint32_t which;
    int j, k;
    for (j = 0; j < e->inputs; j++) {
        for (k = j + 1; k < e->inputs; k++) {
            for (which = 0; which < (e->inputs > 2 ? OTHERS : 1); which++) {
                others(e, which, in);
                visit(e, in, j, k);
            }
        }
    }
}

static void visit_specials(const lobe_entry *e, lobe_value *in, int j, int k)
{
    const size_t n = e->format == LOBE_F32 ? sizeof floats / sizeof floats[0] : sizeof integers / sizeof integers[0];
    size_t a, b;
    for (a = 0; a < n; a++) {
        for (b = 0; b < n; b++) {
            in[j].bits = e->format == LOBE_F32 ? floats[a] : (uint32_t)integers[a];
            in[k].bits = e->format == LOBE_F32 ? floats[b] : (uint32_t)integers[b];
            check_outputs(e, in);
        }
    }
}

static void special_numbers(void **state)
{
    size_t i;
    (void)state;
    for (i = 0; i < lobe_entry_count; i++)
        for_pairs(&lobe_entries[i], visit_specials);
}

static lobe_value at(const lobe_entry *e, int k, double part)
{
    const lobe_range *r = &e->ranges[k];
    return lobe_value_nearest(e->format, r->least + (r->most - r->least) * part);
}

static void visit_grid(const lobe_entry *e, lobe_value *in, int j, int k)
{
    const int step = e->inputs > 2 ? 17 : 1;
    int a, b;
    for (a = -7; a <= 707; a += step) {
        for (b = -7; b <= 707; b += step) {
            in[j] = at(e, j, a / 700.0);
            in[k] = at(e, k, b / 700.0);
            check_outputs(e, in);
        }
    }
}

/* A grid whose step is not a power of two, a margin outside the range included. */
static void dense_sweep(void **state)
{
    size_t i;
    (void)state;
    for (i = 0; i < lobe_entry_count; i++)
        for_pairs(&lobe_entries[i], visit_grid);
}

static void any_bits(void **state)
{
    size_t i;
    uint32_t k;
    (void)state;
    for (i = 0; i < lobe_entry_count; i++) {
        for (k = 0; k < 200000; k++) {
            lobe_value in[LOBE_MAX_INPUTS];
            lobe_hash_inputs(&lobe_entries[i], 16 * k + 15, in);
            check_outputs(&lobe_entries[i], in);
        }
    }
}

static void compare_with_edge(const lobe_entry *e, lobe_value *in, int k, lobe_value value, double edge)
{
    lobe_value outside[LOBE_MAX_OUTPUTS], inside[LOBE_MAX_OUTPUTS];
    int o;
    in[k] = value;
    e->call(in, outside);
    in[k] = lobe_value_nearest(e->format, edge);
    e->call(in, inside);
    for (o = 0; o < e->outputs; o++)
        if (lobe_value_real(e->format, outside[o]) != lobe_value_real(e->format, inside[o]))
            fail_msg("%s: input %d outside (%08x) is not clamped to its edge", e->kernel, k, (unsigned)value.bits);
}

/* What the interface promises: out of range is clamped to it, NaN counts as the lower end. The other inputs are alike,
 * or anything. */
static void clamped_to_the_range(void **state)
{
    const size_t nf = sizeof floats / sizeof floats[0], nq = sizeof integers / sizeof integers[0];
    size_t i, p;
    uint32_t which;
    int k, o;
    (void)state;
    for (i = 0; i < lobe_entry_count; i++) {
        const lobe_entry *e = &lobe_entries[i];
        for (k = 0; k < e->inputs; k++) {
            for (p = 0; p < (e->format == LOBE_F32 ? nf : nq); p++) {
                lobe_value value, in[LOBE_MAX_INPUTS];
                double x;
                value.bits = e->format == LOBE_F32 ? floats[p] : (uint32_t)integers[p];
                x = lobe_value_real(e->format, value);
                if (x > e->ranges[k].least && x <= e->ranges[k].most)
                    continue;
                for (which = 0; which < 17 + OTHERS; which++) {
                    others(e, which, in);
                    for (o = 0; which < 17 && o < e->inputs; o++)
                        in[o] = at(e, o, which / 16.0);
                    compare_with_edge(e, in, k, value, x > e->ranges[k].most ? e->ranges[k].most : e->ranges[k].least);
                }
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(special_numbers),
        cmocka_unit_test(dense_sweep),
        cmocka_unit_test(any_bits),
        cmocka_unit_test(clamped_to_the_range),
    };
    return cmocka_run_group_tests_name("range", tests, NULL, NULL);
}
