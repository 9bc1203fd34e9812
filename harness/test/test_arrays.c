/* The array versions: the same bits as one call an element, at every length and alignment, and not a value
 * beyond the end. */
#include "../hash.h"
#include "../registry.h"
#include "cmocka_first.h"
#include <string.h>

enum { MOST = 1031, GUARD = 8, MARK = 0x5a5a5a5a };

static lobe_value in[LOBE_MAX_INPUTS][MOST + GUARD], out[LOBE_MAX_OUTPUTS][MOST + 2 * GUARD];

static void fill(const lobe_entry *e)
{
    uint32_t i;
    int k;
    for (i = 0; i < MOST + GUARD; i++) {
        lobe_value one[LOBE_MAX_INPUTS];
        lobe_hash_inputs(e, i, one);
        for (k = 0; k < e->inputs; k++)
            in[k][i] = one[k];
    }
}

static void compare(const lobe_entry *e, size_t n, size_t offset)
{
    const lobe_value *in_at[LOBE_MAX_INPUTS];
    lobe_value *out_at[LOBE_MAX_OUTPUTS];
    size_t i;
    int k;
    memset(out, 0x5a, sizeof out);
    for (k = 0; k < e->inputs; k++)
        in_at[k] = in[k] + offset;
    for (k = 0; k < e->outputs; k++)
        out_at[k] = out[k] + GUARD + offset % 3;
    e->array(in_at, out_at, n);
    for (k = 0; k < e->outputs; k++) {
        assert_int_equal(out_at[k][-1].bits, MARK);
        assert_int_equal(out_at[k][n].bits, MARK);
    }
    for (i = 0; i < n; i++) {
        lobe_value one[LOBE_MAX_INPUTS], want[LOBE_MAX_OUTPUTS];
        for (k = 0; k < e->inputs; k++)
            one[k] = in_at[k][i];
        e->call(one, want);
        for (k = 0; k < e->outputs; k++)
            if (out_at[k][i].bits != want[k].bits)
                fail_msg("%s: element %zu of %zu at %08x %08x: output %d is %08x, one call gives %08x", e->kernel, i, n,
                         (unsigned)one[0].bits, (unsigned)one[1].bits, k, (unsigned)out_at[k][i].bits,
                         (unsigned)want[k].bits);
    }
}

static void same_bits_as_one_call(void **state)
{
    size_t i, n, offset, compared = 0;
    (void)state;
    for (i = 0; i < lobe_entry_count; i++) {
        const lobe_entry *e = &lobe_entries[i];
        if (!e->array)
            continue;
        fill(e);
        for (n = 0; n <= 67; n++)
            for (offset = 0; offset < GUARD; offset++)
                compare(e, n, offset);
        compare(e, MOST, 0);
        compare(e, MOST, 1);
        compared++;
    }
    assert_true(compared > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(same_bits_as_one_call)};
    return cmocka_run_group_tests_name("arrays", tests, NULL, NULL);
}
