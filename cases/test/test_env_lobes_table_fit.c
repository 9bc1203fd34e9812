/* What the fit of tables of taps stands on: where nodes lie, the lookup as the kernel's text has it, its start from a
 * closed form, its slopes, its bounds, and the banded solver. How good the tables are: test_env_lobes_fit.c. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include "../../models/lobe.h"
#include "../env_lobes/kernels.h"
#include "../env_lobes/table.h"
#include "../env_lobes/table_band.h"
#include "../env_lobes/table_contenders.h"
#include "../fit/random.h"

enum { SIDE = LOBE_ENV_TABLE_SIDE };

static void places_are_found_again(void **state)
{
    lobe_random r;
    (void)state;
    lobe_random_seed(&r, 51, 0);
    for (int i = 0; i < 2000; i++) {
        const double row = (SIDE - 1) * lobe_random_unit(&r), column = (SIDE - 1) * lobe_random_unit(&r);
        double alpha, n_dot_v, at_row, at_column;
        lobe_env_table_point p;
        lobe_env_table_place(row, column, &alpha, &n_dot_v);
        p = lobe_env_table_point_of(alpha, n_dot_v);
        at_row = p.node / SIDE + p.part[2] + p.part[3];
        at_column = p.node % SIDE + p.part[1] + p.part[3];
        assert_true(fabs(at_row - row) <= 1e-10 && fabs(at_column - column) <= 1e-10);
        assert_true(fabs(p.part[0] + p.part[1] + p.part[2] + p.part[3] - 1) <= 1e-14);
    }
}

static const int16_t *const shipped[] = {lobe_env_lobes1_table16_i16, lobe_env_lobes2_table16_i16,
                                         lobe_env_lobes4_table16_i16, lobe_env_lobes8_table16_i16};

/* What is fitted is what ships, and within its bounds. */
static void lookup_is_the_kernels(void **state)
{
    static double table[LOBE_ENV_TABLE_MOST];
    const double widest = log(lobe_prefilter_t_of_alpha(LOBE_ENV_TABLE_WIDEST * LOBE_ENV_TABLE_WIDEST));
    lobe_random r;
    (void)state;
    lobe_random_seed(&r, 52, 0);
    for (int k = 0; k < LOBE_TABLE_CONTENDERS; k++) {
        const int taps = 1 << k, numbers = lobe_env_table_numbers(taps);
        for (int i = 0; i < LOBE_ENV_TABLE_NODES * numbers; i++) {
            const int kind = i % numbers % 3;
            const double unit = lobe_env_table_unit(kind);
            double least, most;
            table[i] = shipped[k][i] * unit;
            lobe_env_table_bounds(kind, i / numbers, &least, &most);
            assert_true(table[i] >= least - unit && table[i] <= most + unit);
        }
        for (int i = 0; i < 1000; i++) {
            const double alpha = .001 + .9 * lobe_random_unit(&r), v = lobe_random_unit(&r);
            const lobe_env_table_point p = lobe_env_table_point_of(alpha, v);
            const lobe_judge_model *m = &lobe_table_contender[k];
            lobe_cell_tap a[LOBE_CELL_TAPS], b[LOBE_CELL_TAPS];
            lobe_env_table_taps(&p, table, taps, a, NULL);
            assert_int_equal(m->taps(m->ctx, alpha, v, b), taps);
            for (int t = 0; t < taps; t++) {
                assert_true(fabs(a[t].angle - b[t].angle) <= 1e-12 && fabs(a[t].weight - b[t].weight) <= 1e-12);
                assert_true(fabs(a[t].log_t - fmin(widest, b[t].log_t)) <= 1e-9);
            }
        }
    }
}

/* A closed form at its nodes, and the derivative of ln t by a width. */
static void starts_from_the_closed_form(void **state)
{
    enum { TAPS = 4 };
    static double table[LOBE_ENV_TABLE_MOST];
    double p[LOBE_FAN_MOST];
    lobe_random r;
    (void)state;
    lobe_random_seed(&r, 53, 0);
    for (int i = 0; i < LOBE_FAN_MOST; i++)
        p[i] = .3 * (lobe_random_unit(&r) - .5);
    lobe_env_table_start(p, TAPS, table);
    for (int node = SIDE; node < LOBE_ENV_TABLE_NODES; node++) {
        double alpha, n_dot_v, growth[TAPS];
        lobe_cell_tap want[LOBE_CELL_TAPS], got[LOBE_CELL_TAPS], moved[LOBE_CELL_TAPS];
        lobe_env_table_place(node / SIDE, node % SIDE, &alpha, &n_dot_v);
        {
            const lobe_fan_point at = lobe_fan_point_of(alpha, n_dot_v);
            const lobe_env_table_point point = lobe_env_table_point_of(alpha, n_dot_v);
            const int numbers = lobe_env_table_numbers(TAPS);
            double *width = table + node * numbers + 1;
            const double before = *width;
            lobe_fan_taps(&at, p, TAPS, want, NULL);
            lobe_env_table_taps(&point, table, TAPS, got, growth);
            for (int t = 0; t < TAPS; t++) {
                /* the last column's numbers are those a little inside */
                assert_true(fabs(got[t].angle - want[t].angle) <= 1e-5);
                assert_true(fabs(got[t].weight - want[t].weight) <= 1e-5);
                assert_true(fabs(got[t].log_t - want[t].log_t) <= 1e-5);
            }
            *width += 1e-6;
            lobe_env_table_taps(&point, table, TAPS, moved, NULL);
            *width = before;
            assert_true(fabs((moved[0].log_t - got[0].log_t) / 1e-6 - growth[0]) <= 1e-4 * growth[0]);
        }
    }
}

/* Against the product of the matrix with the solution. */
static void band_is_solved(void **state)
{
    enum { SIZE = 60, REACH = 11 };
    static double entry[SIZE * (REACH + 1)];
    static double whole[SIZE][SIZE], want[SIZE], x[SIZE];
    const lobe_band band = {SIZE, REACH, entry};
    lobe_random r;
    (void)state;
    lobe_random_seed(&r, 54, 0);
    for (int i = 0; i < SIZE; i++) {
        want[i] = lobe_random_unit(&r) - .5;
        for (int j = i > REACH ? i - REACH : 0; j <= i; j++) {
            const double a = i == j ? 2.0 * REACH : lobe_random_unit(&r) - .5;
            lobe_band_row(&band, i)[j] = whole[i][j] = whole[j][i] = a;
        }
    }
    for (int i = 0; i < SIZE; i++)
        for (int j = 0; j < SIZE; j++)
            x[i] += whole[i][j] * want[j];
    lobe_band_solve(&band, x);
    for (int i = 0; i < SIZE; i++)
        assert_true(fabs(x[i] - want[i]) <= 1e-13);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(places_are_found_again),
        cmocka_unit_test(lookup_is_the_kernels),
        cmocka_unit_test(starts_from_the_closed_form),
        cmocka_unit_test(band_is_solved),
    };
    return cmocka_run_group_tests_name("environment lobes, fit of tables", tests, NULL, NULL);
}
