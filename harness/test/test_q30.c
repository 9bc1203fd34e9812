/* Fixed point against the same formula in double, by the promise of each tier. */
#include "../registry.h"
#include "cmocka_first.h"
#include <math.h>

#define LOBE_DOUBLE
#include "../../models/energy.h"
#include "../../models/split_sum.h"
#include "../../models/split_sum_sep.h"

typedef struct formula {
    const char *model, *tier;
    lobe_dfg (*dfg)(double roughness, double n_dot_v); /* energy: E as scale, 0 as bias */
    double allowed; /* absolute difference of any output, over all inputs in [0, 1] */
} formula;

#define ENERGY(tier)                                                                                                   \
    static lobe_dfg energy_##tier(double roughness, double n_dot_v)                                                    \
    {                                                                                                                  \
        lobe_dfg e;                                                                                                    \
        e.scale = lobe_energy_##tier(roughness, n_dot_v);                                                              \
        e.bias = 0.0;                                                                                                  \
        return e;                                                                                                      \
    }
ENERGY(low)
ENERGY(medium)
ENERGY(high)

/* A line a tier. Low and medium are the floors of the project; high is what 32 bits were found to hold. */
static const formula formulas[] = {
    {"split_sum", "low", lobe_split_sum_low, 0x1p-20},
    {"split_sum", "medium", lobe_split_sum_medium, 0x1p-18},
    {"split_sum", "high", lobe_split_sum_high, 0x1p-18},
    {"split_sum_sep", "low", lobe_split_sum_sep_low, 0x1p-20},
    {"split_sum_sep", "medium", lobe_split_sum_sep_medium, 0x1p-18},
    {"split_sum_sep", "high", lobe_split_sum_sep_high, 0x1p-18},
    {"energy", "low", energy_low, 0x1p-25},
    {"energy", "medium", energy_medium, 0x1p-25},
    {"energy", "high", energy_high, 0x1p-25},
};

static void compare(const formula *f, const lobe_entry *e, int32_t roughness, int32_t n_dot_v)
{
    const lobe_dfg want = f->dfg(roughness * 0x1p-30, n_dot_v * 0x1p-30);
    lobe_value in[LOBE_MAX_INPUTS], out[LOBE_MAX_OUTPUTS];
    double error;
    in[0].q = roughness;
    in[1].q = n_dot_v;
    e->call(in, out);
    if (e->outputs == 1)
        out[1].q = 0;
    error = fmax(fabs(out[0].q * 0x1p-30 - want.scale), fabs(out[1].q * 0x1p-30 - want.bias));
    if (!(error <= f->allowed))
        fail_msg("%s at %08x %08x: got %08x %08x, want %.9g %.9g: 2^%.1f apart, 2^%.1f is allowed", e->kernel,
                 (unsigned)roughness, (unsigned)n_dot_v, (unsigned)out[0].q, (unsigned)out[1].q, want.scale, want.bias,
                 log2(error), log2(f->allowed));
}

static void grid(void **state)
{
    size_t i;
    int32_t a, b;
    (void)state;
    for (i = 0; i < sizeof formulas / sizeof formulas[0]; i++) {
        const lobe_entry *e = lobe_find_entry(formulas[i].model, formulas[i].tier, LOBE_Q30);
        assert_non_null(e);
        for (a = 0; a <= 512; a++)
            for (b = 0; b <= 512; b++)
                compare(&formulas[i], e, a << 21, b << 21);
    }
}

/* Where products lose their bits: both inputs from 2^-30 up, four values an octave. */
static void small_numbers(void **state)
{
    size_t i;
    int a, b;
    (void)state;
    for (i = 0; i < sizeof formulas / sizeof formulas[0]; i++) {
        const lobe_entry *e = lobe_find_entry(formulas[i].model, formulas[i].tier, LOBE_Q30);
        assert_non_null(e);
        for (a = 0; a <= 120; a++)
            for (b = 0; b <= 120; b++)
                compare(&formulas[i], e, (int32_t)exp2(a / 4.0), (int32_t)exp2(b / 4.0));
    }
}

/* No tier is left out: every q30 entry that is a formula has its line above (nine outputs: test_diffuse_sh.c; lights
 * have tests of their own). */
static void every_tier_is_here(void **state)
{
    size_t i, k, found = 0, wanted = 0;
    (void)state;
    for (i = 0; i < lobe_entry_count; i++) {
        const lobe_entry *e = &lobe_entries[i];
        if (e->format != LOBE_Q30 || e->tier[0] == 't' || !(e->sums || lobe_same(e->model, "energy")))
            continue;
        wanted++;
        for (k = 0; k < sizeof formulas / sizeof formulas[0]; k++)
            found += (size_t)(lobe_same(formulas[k].model, e->model) && lobe_same(formulas[k].tier, e->tier));
    }
    assert_int_equal(found, wanted);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(grid),
        cmocka_unit_test(small_numbers),
        cmocka_unit_test(every_tier_is_here),
    };
    return cmocka_run_group_tests_name("q30", tests, NULL, NULL);
}
