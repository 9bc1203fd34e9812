/* What ships of sg_light keeps its floors on cells that no fit has seen, in every format, and is ahead of the published
 * forms in the same run; fit and held-out cells share nothing; the rows of its vectors are lights. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <math.h>
#include <string.h>
#include "../sg_light/columns.h"
#include "../sg_light/held.h"
#include "../sg_light/points.h"
#include "../sg_light/shipped.h"
#include "../sphere_light/columns.h"

static lobe_sg_held held;

static int prepare(void **state)
{
    lobe_sweep_options options = lobe_sweep_options_default();
    (void)state;
    options.progress = 0;
    return lobe_sg_held_make(&held, &options) ? 0 : -1;
}

static int finish(void **state)
{
    (void)state;
    lobe_sg_held_free(&held);
    return 0;
}

static void floors_are_kept(void **state)
{
    int i, set;
    (void)state;
    for (i = 0; lobe_sg_shipped_at(i); i++) {
        const lobe_sg_shipped *s = lobe_sg_shipped_at(i);
        lobe_sg_figures f[2];
        lobe_sg_held_judge(&held, s->call, f);
        for (set = 0; set < 2; set++) {
            print_message("# %s %s: %.4f, smooth %.4f\n", s->tier, s->format, f[set].all, f[set].smooth);
            assert_true(f[set].all <= .28 && f[set].smooth <= .15 && f[set].worst <= .7);
        }
    }
    assert_int_equal(i, 6);
}

static const lobe_sg_score *score_of(const char *name, int set)
{
    static lobe_sg_score score;
    int i;
    for (i = 0; strcmp(lobe_sg_candidate_at(i)->name, name) != 0; i++)
        ;
    lobe_sg_judge(lobe_sg_candidate_at(i), &held.cells[set], &score);
    return &score;
}

/* Each step of the front by a tenth at least. */
static void the_front_is_ordered(void **state)
{
    static const char *const order[] = {"high", "medium", "low", "ASG warp refitted", "ASG warp", "SG warp"};
    size_t i;
    int set;
    (void)state;
    for (set = 0; set < 2; set++)
        for (i = 1; i < sizeof order / sizeof order[0]; i++) {
            const double better = score_of(order[i - 1], set)->all;
            const double worse = score_of(order[i], set)->all;
            print_message("# %s %.4f, %s %.4f\n", order[i - 1], better, order[i], worse);
            assert_true(better < .93 * worse);
        }
}

static void cells_share_nothing(void **state)
{
    lobe_sweep_options options = lobe_sweep_options_default();
    lobe_sg_cells fit;
    int i, k, smooth = 0;
    (void)state;
    options.progress = 0;
    assert_true(lobe_sg_cells_make(&fit, false, false, &options));
    for (i = 0; i < LOBE_SG_COUNT; i += LOBE_SG_POSITIONS)
        for (k = 0; k < LOBE_SG_COUNT; k += LOBE_SG_POSITIONS) {
            const double *a = fit.in + 5 * i, *b = held.cells[0].in + 5 * k;
            assert_true(a[0] != b[0] && a[1] != b[1] && a[4] != b[4]);
        }
    for (i = 0; i < LOBE_SG_CELLS; i++)
        smooth += lobe_sg_cell_smooth(&fit, i);
    assert_int_equal(smooth, 54);
    lobe_sg_cells_free(&fit);
}

/* Every row of the vectors is on the grid of both formats, in its domain, and two directions that there are. */
static void rows_are_lights(void **state)
{
    static double rows[5 * LOBE_SG_VECTORS];
    int beyond, k;
    (void)state;
    for (beyond = 0; beyond < 2; beyond++) {
        const size_t count = lobe_sg_points(0, beyond, 1, rows, LOBE_SG_VECTORS);
        size_t i;
        assert_int_equal(count, beyond ? 256 : LOBE_SG_VECTORS);
        for (i = 0; i < count; i++) {
            const double *row = rows + 5 * i;
            const double sv = sqrt(1 - row[1] * row[1]), sl = sqrt(1 - row[2] * row[2]);
            for (k = 0; k < 5; k++)
                assert_true(row[k] * 16777216 == floor(row[k] * 16777216));
            assert_true(lobe_sg_inside(row) == !beyond && lobe_sg_taken(row));
            assert_true(row[3] >= .25 * (sv - sl) * (sv - sl) - 1e-15 && row[3] <= .25 * (sv + sl) * (sv + sl) + 1e-15);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(floors_are_kept),
        cmocka_unit_test(the_front_is_ordered),
        cmocka_unit_test(cells_share_nothing),
        cmocka_unit_test(rows_are_lights),
    };
    return cmocka_run_group_tests(tests, prepare, finish);
}
