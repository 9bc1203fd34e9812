/* What ships of sphere_light keeps its floors on cells that no fit has seen, in every format; meets the punctual light
 * where the light is tiny, of which an absolute bound says nothing; and the rows of its vectors are lights. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../fit/random.h"
#include "../sphere_light/candidates.h"
#include "../sphere_light/columns.h"
#include "../sphere_light/held.h"
#include "../sphere_light/points.h"
#include "../sphere_light/shipped.h"
#include "../sphere_light/truth_sphere.h"

enum { FIGURES = 6, MOST = 64 };

static const double pi = 3.14159265358979323846;

typedef struct floors {
    const char *tier;
    double most[FIGURES]; /* in the order of figure_names; infinite where there is no floor */
} floors;

static const char *const figure_names[FIGURES] = {"all cells",
                                                  "view <= 60",
                                                  "view >= 75",
                                                  "energy, even and mixed positions",
                                                  "over a punctual light where sine < alpha / 2",
                                                  "energy, 200 uniform positions"};
/* The last is no floor but what README.md states: one position can be all of a cell's light (even.h). */
static const floors all_floors[] = {{"low", {.185, .09, .31, .30, HUGE_VAL, .42}},
                                    {"medium", {.115, .065, .175, .25, .005, .28}},
                                    {"high", {.05, .03, .08, .20, .005, .20}}};

typedef struct floor_test {
    char name[120];
    double is[2], most; /* uniform, mixed positions */
} floor_test;

static floor_test floor_tests[MOST];
static size_t floor_count;

static void keeps_its_floor(void **state)
{
    const floor_test *t = *state;
    print_message("# %s: %.4f and %.4f of %.4f\n", t->name, t->is[0], t->is[1], t->most);
    assert_true(t->is[0] <= t->most && t->is[1] <= t->most);
}

/* One test a tier, format and figure, so that a failure names what it is about. */
static bool measure(void)
{
    lobe_sweep_options options = lobe_sweep_options_default();
    lobe_sphere_held held;
    bool good;
    int i, k, set;
    size_t tier;
    options.progress = 0;
    good = lobe_sphere_held_make(&held, &options);
    for (i = 0; good && lobe_sphere_shipped_at(i); i++) {
        const lobe_sphere_shipped *s = lobe_sphere_shipped_at(i);
        lobe_sphere_figures f[2];
        lobe_sphere_held_judge(&held, s->call, f);
        for (tier = 0; strcmp(all_floors[tier].tier, s->tier) != 0; tier++)
            ;
        for (k = 0; k < FIGURES && floor_count < MOST; k++) {
            floor_test *t = &floor_tests[floor_count];
            t->most = all_floors[tier].most[k];
            if (!(t->most < HUGE_VAL))
                continue;
            for (set = 0; set < 2; set++) {
                const double figure[FIGURES] = {f[set].all,    f[set].view60,
                                                f[set].view75, fabs(set ? f[set].energy : f[set].integral),
                                                f[set].excess, fabs(f[0].energy)};
                t->is[set] = figure[k];
            }
            snprintf(t->name, sizeof t->name, "%s %s, %s", s->tier, s->format, figure_names[k]);
            floor_count++;
        }
    }
    lobe_sphere_held_free(&held);
    return good;
}

/* A row with numbers that every format has, its light at least .1 above the horizon. */
static void tiny_row(lobe_random *random, double sigma, int near, double row[5])
{
    double u[5];
    int k;
    do {
        for (k = 0; k < 5; k++)
            u[k] = lobe_random_unit(random);
        u[4] *= .5;
    } while (!lobe_sphere_draw(row, u, false, near) ||
             !lobe_sphere_place(row, row[0], row[1], row[2], lobe_sphere_azimuth(row), sin(sigma)) || row[2] < .1);
}

/* Half angle .01 degree against 2 pi (1 - cos) D V n.l in double, written for the truth. */
static void tiny_light_is_punctual(void **state)
{
    int i, k;
    (void)state;
    for (k = 0; lobe_sphere_shipped_at(k); k++) {
        const lobe_sphere_shipped *s = lobe_sphere_shipped_at(k);
        lobe_random random;
        double most = 0;
        lobe_random_seed(&random, 71, 0);
        for (i = 0; i < 4000; i++) {
            lobe_sphere_scene scene;
            double row[5];
            tiny_row(&random, .01 * pi / 180, i & 1, row);
            scene = (lobe_sphere_scene){row[0] * row[0], row[1], row[2], lobe_sphere_azimuth(row), asin(row[4]), 1};
            most = fmax(most, fabs(s->call(row) / lobe_truth_sphere_punctual(&scene) - 1));
        }
        print_message("# %s %s, half angle .01 degree: %.1e off the punctual light\n", s->tier, s->format, most);
        assert_true(most <= 1e-3);
    }
}

static const lobe_sphere_candidate *candidate_named(const char *name)
{
    int i;
    for (i = 0; lobe_sphere_candidate_at(i); i++)
        if (strcmp(lobe_sphere_candidate_at(i)->name, name) == 0)
            return lobe_sphere_candidate_at(i);
    return NULL;
}

/* Below a degree what ships is the formula in double, relative to itself: nothing cancels. */
static void small_light_has_no_noise(void **state)
{
    int i, k;
    (void)state;
    for (k = 0; lobe_sphere_shipped_at(k); k++) {
        const lobe_sphere_shipped *s = lobe_sphere_shipped_at(k);
        const lobe_sphere_candidate *c = candidate_named(s->tier);
        lobe_random random;
        double most = 0;
        assert_non_null(c);
        lobe_random_seed(&random, 73, 0);
        for (i = 0; i < 20000; i++) {
            double row[5];
            tiny_row(&random, .01 * pow(100, lobe_random_unit(&random)) * pi / 180, i & 1, row);
            {
                const double angles[5] = {row[0], row[1], row[2], lobe_sphere_azimuth(row), asin(row[4])};
                most = fmax(most, fabs(s->call(row) / c->call(angles) - 1));
            }
        }
        print_message("# %s %s, half angle .01 to 1 degree: %.1e off the formula in double\n", s->tier, s->format,
                      most);
        assert_true(most <= 2e-5);
    }
}

/* The azimuth of a row puts v + l where tangent2 says, and the other integrator agrees there. */
static void columns_are_a_light(void **state)
{
    double *rows = malloc(5 * LOBE_SPHERE_VECTORS * sizeof *rows), worst = 0;
    int beyond, zero = 0, mirror = 0, tiny = 0, wide = 0;
    size_t i, n;
    int k;
    (void)state;
    assert_non_null(rows);
    for (beyond = 0; beyond < 2; beyond++) {
        n = lobe_sphere_points(0, beyond, 1, rows, LOBE_SPHERE_VECTORS);
        assert_int_equal(n, beyond ? 256 : LOBE_SPHERE_VECTORS);
        for (i = 0; i < n; i++) {
            const double *r = rows + 5 * i, azimuth = lobe_sphere_azimuth(r);
            const double sv = sqrt(1 - r[1] * r[1]), sl = sqrt(1 - r[2] * r[2]);
            const double x = .5 * (sv + sl * cos(azimuth)), y = .5 * sl * sin(azimuth);
            double truth;
            for (k = 0; k < 5; k++)
                assert_true(r[k] * 16777216 == floor(r[k] * 16777216));
            assert_true(fabs(x * x + y * y - r[3]) <= 1e-15);
            assert_int_equal(lobe_sphere_inside(r), !beyond);
            assert_true(r[0] >= .05 && r[0] <= 1 && r[1] >= .001 && r[1] <= 1 && r[4] >= 1e-4 && r[4] <= 1);
            lobe_truth_sphere_columns(r, &truth, 1);
            zero += truth == 0;
            mirror += r[3] == 0 && r[1] == r[2];
            tiny += r[4] < 2e-4;
            wide += r[4] > .7;
            if (i % 16 == 0) {
                const lobe_sphere_scene s = {r[0] * r[0], r[1], r[2], azimuth, asin(r[4]), 1};
                const double other = lobe_truth_sphere_cone(&s, 1e-7);
                if (truth > 1e-9)
                    worst = fmax(worst, fabs(other / truth - 1));
            }
        }
    }
    free(rows);
    print_message("# rows: %d in the dark, %d mirrors, %d of .01 degree, %d of 45 and more; integrators %.1e apart\n",
                  zero, mirror, tiny, wide, worst);
    assert_true(zero >= 20 && mirror >= 50 && tiny >= 60 && wide >= 60 && worst <= 1e-6);
}

int main(void)
{
    struct CMUnitTest tests[MOST + 3] = {cmocka_unit_test(columns_are_a_light),
                                         cmocka_unit_test(tiny_light_is_punctual),
                                         cmocka_unit_test(small_light_has_no_noise)};
    size_t i, count = 3;
    if (!measure())
        return 1;
    for (i = 0; i < floor_count; i++) {
        tests[count].name = floor_tests[i].name;
        tests[count].test_func = keeps_its_floor;
        tests[count++].initial_state = &floor_tests[i];
    }
    return _cmocka_run_group_tests("sphere_light floors", tests, count, NULL, NULL);
}
