/* What each tier promises at most, as the project set it: cost, error, domain. The vectors hold the functions to
 * their stated bounds; this holds the stated bounds to the promise. */
#include "../registry.h"
#include "cmocka_first.h"

static const struct {
    const char *model, *tier;
    int ops;
    double max;
} promises[] = {
    {"split_sum", "low", 20, 0.047},         {"split_sum", "medium", 40, 0.0065},
    {"split_sum", "high", 110, 0.0012},      {"split_sum_sep", "low", 20, 0.045},
    {"split_sum_sep", "medium", 40, 0.0150}, {"split_sum_sep", "high", 110, 0.0030},
    {"energy", "low", 20, 0.0125},           {"energy", "medium", 40, 0.006},
    {"energy", "high", 110, 0.003},          {"diffuse_sh", "low", 20, 0.02},
    {"diffuse_sh", "medium", 40, 0.006},     {"diffuse_sh", "exact", 110, 2e-6},
};
enum { PROMISES = sizeof promises / sizeof promises[0] };

static void every_promise_is_kept(void **state)
{
    int p, format;
    (void)state;
    for (p = 0; p < PROMISES; p++) {
        for (format = 0; format < LOBE_FORMATS; format++) {
            const lobe_entry *e = lobe_find_entry(promises[p].model, promises[p].tier, (lobe_format)format);
            if (!e)
                continue;
            if (e->ops > promises[p].ops || !(e->max <= promises[p].max))
                fail_msg("%s: %d operations (%d allowed), max %g (%g allowed)", e->kernel, e->ops, promises[p].ops,
                         e->max, promises[p].max);
        }
    }
}

/* A tier of each model exists in both formats, and with numbers that can be true. */
static void entries_are_whole(void **state)
{
    size_t i;
    (void)state;
    for (i = 0; i < lobe_entry_count; i++) {
        const lobe_entry *e = &lobe_entries[i];
        const lobe_entry *other = lobe_find_entry(e->model, e->tier, e->format == LOBE_F32 ? LOBE_Q30 : LOBE_F32);
        if (!other)
            fail_msg("%s %s is not in both formats", e->model, e->tier);
        if (!(e->rms > 0.0 && e->rms <= e->max && e->max < 1.0 && e->below_max > 0.0 && e->below_max < 1.0))
            fail_msg("%s: rms %g, max %g, max below the domain %g cannot be true", e->kernel, e->rms, e->max,
                     e->below_max);
        assert_true(e->domain_lo >= 0.0 && e->domain_lo <= 0.02);
        assert_true((e->ops > 0 || lobe_same(e->tier, "lambert")) && e->inputs <= LOBE_MAX_INPUTS && e->outputs <= LOBE_MAX_OUTPUTS);
        assert_ptr_equal(lobe_find_entry(e->model, e->tier, e->format), e); /* no name twice */
    }
}

/* A tier that costs more and errs more than another is no tier. Tables stay in view whatever they cost, and a zonal
 * lobe is kept for what takes one direction. */
static int may_be_beaten(const lobe_entry *e) { return e->tier[0] == 't' || e->tier[0] == 'z'; }

static void tiers_stand_on_the_front(void **state)
{
    size_t i, k;
    (void)state;
    for (i = 0; i < lobe_entry_count; i++) {
        for (k = 0; k < lobe_entry_count; k++) {
            const lobe_entry *a = &lobe_entries[i], *b = &lobe_entries[k];
            if (may_be_beaten(a) || may_be_beaten(b) || !lobe_same(a->model, b->model) || a->format != b->format)
                continue;
            if (a->ops > b->ops && a->max >= b->max)
                fail_msg("%s is beaten by %s in cost and error", a->kernel, b->kernel);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_promise_is_kept),
        cmocka_unit_test(entries_are_whole),
        cmocka_unit_test(tiers_stand_on_the_front),
    };
    return cmocka_run_group_tests_name("promises", tests, NULL, NULL);
}
