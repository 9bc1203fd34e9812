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
        const double x = lobe_value_real(e->format, out[k]);
        good &= x >= 0.0 && x <= 1.0;
        if (e->format == LOBE_F32)
            sum_f += out[k].f;
        else
            sum_q += out[k].q;
    }
    if (e->sums)
        good &= sum_f >= 0.0f && sum_f <= 1.0f && sum_q >= 0 && sum_q <= 1 << 30;
    if (!good)
        fail_msg("%s at %08x %08x gives %08x %08x", e->kernel, (unsigned)in[0].bits, (unsigned)in[1].bits,
                 (unsigned)out[0].bits, e->outputs > 1 ? (unsigned)out[1].bits : 0u);
}

static void special_numbers(void **state)
{
    const size_t nf = sizeof floats / sizeof floats[0], nq = sizeof integers / sizeof integers[0];
    size_t i, a, b;
    (void)state;
    for (i = 0; i < lobe_entry_count; i++) {
        const lobe_entry *e = &lobe_entries[i];
        const size_t n = e->format == LOBE_F32 ? nf : nq;
        for (a = 0; a < n; a++) {
            for (b = 0; b < n; b++) {
                lobe_value in[LOBE_MAX_INPUTS];
                in[0].bits = e->format == LOBE_F32 ? floats[a] : (uint32_t)integers[a];
                in[1].bits = e->format == LOBE_F32 ? floats[b] : (uint32_t)integers[b];
                check_outputs(e, in);
            }
        }
    }
}

/* A grid whose step is not a power of two, a margin outside the domain included. */
static void dense_sweep(void **state)
{
    size_t i;
    int a, b;
    (void)state;
    for (i = 0; i < lobe_entry_count; i++) {
        const lobe_entry *e = &lobe_entries[i];
        for (a = -7; a <= 707; a++) {
            for (b = -7; b <= 707; b++) {
                lobe_value in[LOBE_MAX_INPUTS];
                in[0] = lobe_value_nearest(e->format, a / 700.0);
                in[1] = lobe_value_nearest(e->format, b / 700.0);
                check_outputs(e, in);
            }
        }
    }
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

/* What the interface promises: out of domain is clamped to it, NaN counts as 0. */
static void clamped_to_the_domain(void **state)
{
    static const uint32_t pairs[][2] = {{0x7fc00000, 0x00000000}, {0xffc00000, 0x00000000}, {0xbf800000, 0x00000000},
                                        {0xff800000, 0x00000000}, {0x7f800000, 0x3f800000}, {0x7f7fffff, 0x3f800000},
                                        {0x3f800001, 0x3f800000}, {0x80000000, 0x00000000}};
    static const int32_t ends[][2] = {{INT32_MIN, 0}, {-1, 0}, {INT32_MAX, 1 << 30}, {(1 << 30) + 1, 1 << 30}};
    size_t i, p;
    int k, place, b;
    (void)state;
    for (i = 0; i < lobe_entry_count; i++) {
        const lobe_entry *e = &lobe_entries[i];
        const int f32 = e->format == LOBE_F32;
        for (p = 0; p < (f32 ? sizeof pairs / sizeof pairs[0] : sizeof ends / sizeof ends[0]); p++) {
            for (place = 0; place < 2; place++) {
                for (b = 0; b <= 16; b++) {
                    lobe_value in[LOBE_MAX_INPUTS], outside[LOBE_MAX_OUTPUTS], edge[LOBE_MAX_OUTPUTS];
                    in[1 - place] = lobe_value_nearest(e->format, b / 16.0);
                    in[place].bits = f32 ? pairs[p][0] : (uint32_t)ends[p][0];
                    e->call(in, outside);
                    in[place].bits = f32 ? pairs[p][1] : (uint32_t)ends[p][1];
                    e->call(in, edge);
                    for (k = 0; k < e->outputs; k++)
                        if (lobe_value_real(e->format, outside[k]) != lobe_value_real(e->format, edge[k]))
                            fail_msg("%s: input %d outside (%08x) is not clamped to its edge", e->kernel, place,
                                     f32 ? (unsigned)pairs[p][0] : (unsigned)ends[p][0]);
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
        cmocka_unit_test(clamped_to_the_domain),
    };
    return cmocka_run_group_tests_name("range", tests, NULL, NULL);
}
