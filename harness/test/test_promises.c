/* What each tier promises at most, as the project set it: cost, error, domain. The vectors hold the functions to
 * their stated bounds; this holds the stated bounds to the promise. */
#include "../../models/coeffs/capsule_light_bounds.h"
#include "../../models/coeffs/sg_light_bounds.h"
#include "../../models/coeffs/sphere_light_bounds.h"
#include "../registry.h"
#include "cmocka_first.h"

static const struct {
    const char *model, *tier;
    int ops;
    double max;
} promises[] = {
    {"split_sum", "low", 20, 0.047},
    {"split_sum", "medium", 40, 0.0065},
    {"split_sum", "high", 110, 0.0012},
    {"split_sum_sep", "low", 20, 0.045},
    {"split_sum_sep", "medium", 40, 0.0150},
    {"split_sum_sep", "high", 110, 0.0030},
    {"energy", "low", 20, 0.0125},
    {"energy", "medium", 40, 0.006},
    {"energy", "high", 110, 0.003},
    {"diffuse_sh", "low", 20, 0.02},
    {"diffuse_sh", "medium", 40, 0.006},
    {"diffuse_sh", "exact", 110, 2e-6},
    {"sphere_diffuse", "low", 20, 0.008},
    {"sphere_diffuse", "medium", 40, 0.0006},
    {"sphere_diffuse", "exact", 110, 2e-6},
    {"sg_diffuse", "high", 110, 0.003},
    {"sg_light", "low", 20, 1.0},
    {"sg_light", "medium", 40, 1.0},
    {"sg_light", "high", 110, 1.0}, /* by cells too */
    {"sphere_light", "low", 20, 1.0},
    {"sphere_light", "medium", 40, 1.0},
    {"sphere_light", "high", 110, 1.0}, /* judged by cells, below */
};
/* Where an input's domain is promised to reach; without a line, from .02 or less to 1. */
static const struct {
    const char *model;
    int input;
    double lo, hi;
} domains[] = {
    {"sphere_light", 0, 0.22, 1.0},
    {"sphere_light", 1, 0.08, 1.0},
    {"sphere_light", 2, -1.0, 1.0},
    {"sphere_light", 3, 0.0, 1.0},
    {"sphere_light", 4, 0.0, 0.7072},
    {"sphere_light_schlick", 0, 0.22, 1.0},
    {"sphere_light_schlick", 1, 0.08, 1.0},
    {"sphere_light_schlick", 2, -1.0, 1.0},
    {"sphere_light_schlick", 3, 0.0, 1.0},
    {"sphere_light_schlick", 4, 0.0, 0.7072},
    {"sg_light", 0, 0.22, 1.0},
    {"sg_light", 1, 0.05, 1.0},
    {"sg_light", 2, -1.0, 1.0},
    {"sg_light", 3, 0.0, 1.0},
    {"sg_light", 4, 0.000244140625, 0.25},
    {"capsule_light", 0, 0.22, 1.0},
    {"capsule_light", 1, 0.08, 1.0},
    {"capsule_light", 2, -1.0, 1.0},
    {"capsule_light", 3, -1.0, 1.0},
    {"capsule_light", 4, -1.0, 1.0},
    {"capsule_light", 5, -1.0, 1.0},
    {"capsule_light", 6, -1.0, 1.0},
    {"capsule_light", 7, -1.0, 1.0},
    {"capsule_light", 8, 0.0, 0.5},
};
enum { PROMISES = sizeof promises / sizeof promises[0] };

/* Sphere lights over held-out cells: relative L2 error of all, of views to 60 degrees, of views from 75 on, energy of
 * the worst cell, and how much worse than a punctual light where sine < alpha / 2. */
#define CELLS(TIER)                                                                                                    \
    {                                                                                                                  \
        LOBE_SPHERE_LIGHT_##TIER##_F32_CELLS, LOBE_SPHERE_LIGHT_##TIER##_F32_CELLS_VIEW60,                             \
            LOBE_SPHERE_LIGHT_##TIER##_F32_CELLS_VIEW75, LOBE_SPHERE_LIGHT_##TIER##_F32_CELLS_ENERGY,                  \
            LOBE_SPHERE_LIGHT_##TIER##_F32_CELLS_EXCESS                                                                \
    }
enum { CELL_FIGURES = 5 };
static const char *const cell_names[CELL_FIGURES] = {"all", "view to 60", "view from 75", "energy", "excess"};
static const struct {
    const char *tier;
    double stated[CELL_FIGURES], promised[CELL_FIGURES];
} cells[] = {
    {"low", CELLS(LOW), {0.185, 0.09, 0.31, 0.30, 1.0}},
    {"medium", CELLS(MEDIUM), {0.115, 0.065, 0.175, 0.25, 0.005}},
    {"high", CELLS(HIGH), {0.05, 0.03, 0.08, 0.20, 0.005}},
};

/* Spherical Gaussian lights over held-out cells: relative L2 error of all, and where alpha <= .25 and n.v >= .4. */
static void gaussian_lights_keep_their_floors(void **state)
{
    (void)state;
    assert_true(LOBE_SG_LIGHT_LOW_F32_CELLS <= 0.28 && LOBE_SG_LIGHT_LOW_F32_CELLS_SMOOTH <= 0.15);
    assert_true(LOBE_SG_LIGHT_MEDIUM_F32_CELLS < LOBE_SG_LIGHT_LOW_F32_CELLS);
    assert_true(LOBE_SG_LIGHT_MEDIUM_F32_CELLS <= 0.28 && LOBE_SG_LIGHT_MEDIUM_F32_CELLS_SMOOTH <= 0.15);
    assert_true(LOBE_SG_LIGHT_HIGH_F32_CELLS <= 0.28 && LOBE_SG_LIGHT_HIGH_F32_CELLS_SMOOTH <= 0.15);
    assert_true(LOBE_SG_LIGHT_HIGH_F32_CELLS < LOBE_SG_LIGHT_MEDIUM_F32_CELLS);
}

static void sphere_lights_keep_their_floors(void **state)
{
    int i, k, failed = 0;
    (void)state;
    for (i = 0; i < 3; i++) {
        for (k = 0; k < CELL_FIGURES; k++) {
            if (!(cells[i].stated[k] <= cells[i].promised[k])) {
                print_error("sphere_light %s, %s: %g, %g is promised\n", cells[i].tier, cell_names[k],
                            cells[i].stated[k], cells[i].promised[k]);
                failed = 1;
            }
        }
    }
    assert_false(failed);
}

/* Capsules over theirs. Karis' form errs there by 81 %, and half of that is the floor of medium. */
static void capsule_lights_keep_their_floors(void **state)
{
    (void)state;
    assert_true(LOBE_CAPSULE_LIGHT_LOW_F32_CELLS <= 0.30 && LOBE_CAPSULE_LIGHT_LOW_Q30_CELLS <= 0.30);
    assert_true(LOBE_CAPSULE_LIGHT_MEDIUM_F32_CELLS <= 0.13 && LOBE_CAPSULE_LIGHT_MEDIUM_Q30_CELLS <= 0.13);
    assert_true(LOBE_CAPSULE_LIGHT_HIGH_F32_CELLS <= 0.10 && LOBE_CAPSULE_LIGHT_HIGH_Q30_CELLS <= 0.10);
    assert_true(LOBE_CAPSULE_LIGHT_MEDIUM_F32_CELLS_VIEW75 <= 0.20 &&
                LOBE_CAPSULE_LIGHT_MEDIUM_F32_CELLS_ENERGY <= 0.20);
}

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

static void check_domain(const lobe_entry *e, int k)
{
    double lo = 0.02, hi = 1.0;
    size_t i;
    for (i = 0; i < sizeof domains / sizeof domains[0]; i++) {
        if (lobe_same(domains[i].model, e->model) && domains[i].input == k) {
            lo = domains[i].lo;
            hi = domains[i].hi;
        }
    }
    if (!(e->ranges[k].least <= e->ranges[k].lo && e->ranges[k].lo <= lo && e->ranges[k].hi >= hi &&
          e->ranges[k].hi <= e->ranges[k].most))
        fail_msg("%s: input %d has the domain [%g, %g] within [%g, %g], not [%g, %g]", e->kernel, k, e->ranges[k].lo,
                 e->ranges[k].hi, e->ranges[k].least, e->ranges[k].most, lo, hi);
}

/* A tier of each model exists in both formats, and with numbers that can be true. */
static void entries_are_whole(void **state)
{
    size_t i;
    int k;
    (void)state;
    for (i = 0; i < lobe_entry_count; i++) {
        const lobe_entry *e = &lobe_entries[i];
        const lobe_entry *other = lobe_find_entry(e->model, e->tier, e->format == LOBE_F32 ? LOBE_Q30 : LOBE_F32);
        if (!other)
            fail_msg("%s %s is not in both formats", e->model, e->tier);
        if (!(e->rms > 0.0 && e->rms <= e->max && e->max < 1.0 && e->below_max > 0.0 && e->below_max <= 1.0))
            fail_msg("%s: rms %g, max %g, max below the domain %g cannot be true", e->kernel, e->rms, e->max,
                     e->below_max);
        for (k = 0; k < e->inputs; k++)
            check_domain(e, k);
        assert_true((e->ops > 0 || lobe_same(e->tier, "lambert")) && e->inputs <= LOBE_MAX_INPUTS &&
                    e->outputs <= LOBE_MAX_OUTPUTS);
        assert_ptr_equal(lobe_find_entry(e->model, e->tier, e->format), e); /* no name twice */
    }
}

/* A tier that costs more and errs more than another is no tier. Tables stay in view whatever they cost, a zonal
 * lobe is kept for what takes one direction, and taps are judged by radiance (cases/env_lobes). */
static int may_be_beaten(const lobe_entry *e) { return e->tier[0] == 't' || e->tier[0] == 'z' || e->nth; }

static void tiers_stand_on_the_front(void **state)
{
    size_t i, k;
    (void)state;
    for (i = 0; i < lobe_entry_count; i++) {
        for (k = 0; k < lobe_entry_count; k++) {
            const lobe_entry *a = &lobe_entries[i], *b = &lobe_entries[k];
            if (may_be_beaten(a) || may_be_beaten(b) || !lobe_same(a->model, b->model) || a->format != b->format)
                continue;
            if (a->ops > b->ops && a->max >= b->max && a->rms >= b->rms)
                fail_msg("%s is beaten by %s in cost and error", a->kernel, b->kernel);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_promise_is_kept),
        cmocka_unit_test(gaussian_lights_keep_their_floors),
        cmocka_unit_test(sphere_lights_keep_their_floors),
        cmocka_unit_test(capsule_lights_keep_their_floors),
        cmocka_unit_test(entries_are_whole),
        cmocka_unit_test(tiers_stand_on_the_front),
    };
    return cmocka_run_group_tests_name("promises", tests, NULL, NULL);
}
