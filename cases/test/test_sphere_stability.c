/* Where sphere lights fail, and how far: the limits that cases/sphere_light/README.md states, region by region, and
 * that the published points fail where they are said to. The map is that of make stability. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <string.h>
#include "../sphere_light/stability/stability.h"

enum { POSITIONS = 120 };

static lobe_stability map;

static const lobe_sphere_candidate *form_named(const char *name)
{
    int i;
    for (i = 0; lobe_sphere_candidate_at(i); i++) {
        if (strcmp(lobe_sphere_candidate_at(i)->name, name) == 0)
            return lobe_sphere_candidate_at(i);
    }
    fail_msg("no form is called %s", name);
    return NULL;
}

typedef struct limit {
    const char *form;
    double rms[LOBE_STABILITY_REGIONS], worst[LOBE_STABILITY_REGIONS];
} limit;

/* grazing and narrow, small, large, rough, through the horizon, half angles 70 to 90 degrees */
static const limit limits[] = {
    {"low", {.27, .08, .17, .075, .30, .38}, {.60, .55, .40, .32, .95, .60}},
    {"medium", {.135, .035, .125, .04, .29, .32}, {.29, .22, .25, .19, 1.15, .60}},
    {"high", {.055, .01, .07, .04, .105, .19}, {.19, .05, .23, .20, .36, .43}},
};

static void tiers_stay_within_their_limits(void **state)
{
    size_t i;
    int region, broken = 0;
    (void)state;
    for (i = 0; i < sizeof limits / sizeof limits[0]; i++) {
        for (region = 0; region < LOBE_STABILITY_REGIONS; region++) {
            const lobe_stability_sum sum =
                lobe_stability_over(&map, form_named(limits[i].form), (lobe_stability_region)region);
            print_message("# %s, %s: rms %.3f of %.3f, worst %.3f of %.3f, %d cells\n", limits[i].form,
                          lobe_stability_region_name[region], sum.rms, limits[i].rms[region], sum.worst,
                          limits[i].worst[region], sum.cells);
            assert_true(sum.cells >= 6);
            broken += !(sum.rms <= limits[i].rms[region]) + !(sum.worst <= limits[i].worst[region]);
        }
    }
    assert_int_equal(broken, 0);
}

/* Every nearest point is several times too bright where the view grazes a narrow lobe. */
static void published_points_fail_at_grazing_views(void **state)
{
    (void)state;
    assert_true(lobe_stability_over(&map, form_named("Karis 1/2"), LOBE_STABILITY_GRAZING).rms > 2);
    assert_true(lobe_stability_over(&map, form_named("Karis 1/3"), LOBE_STABILITY_GRAZING).rms > 4);
    assert_true(lobe_stability_over(&map, form_named("smoothed point as printed"), LOBE_STABILITY_GRAZING).rms > 2);
}

/* A hard point has a flat plateau where the light is larger than the lobe, and so is too dark or too bright there. */
static void a_point_light_fails_where_the_light_is_larger(void **state)
{
    (void)state;
    assert_true(lobe_stability_over(&map, form_named("point"), LOBE_STABILITY_LARGE).rms > 5);
    assert_true(lobe_stability_over(&map, form_named("point"), LOBE_STABILITY_SMALL).rms < .15);
}

static int make_map(void **state)
{
    lobe_sweep_options options = lobe_sweep_options_default();
    (void)state;
    options.progress = 0;
    return lobe_stability_make(&map, POSITIONS, &options) ? 0 : -1;
}

static int free_map(void **state)
{
    (void)state;
    lobe_stability_free(&map);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tiers_stay_within_their_limits),
        cmocka_unit_test(published_points_fail_at_grazing_views),
        cmocka_unit_test(a_point_light_fails_where_the_light_is_larger),
    };
    return cmocka_run_group_tests_name("sphere_stability", tests, make_map, free_map);
}
