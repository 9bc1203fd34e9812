/* The objective of the sphere light's fit is the metric: its sum of squares is what the judge says of the same cells,
 * and its hinges are silent or not as their caps say. */
#define LOBE_DOUBLE 1
#define LOBE_FIT 1
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../sphere_light/judge.h"
#include "../sphere_light/lit_objective.h"
#include "../sphere_light/objective.h"
#include "../sphere_light/row.h"

static lobe_sphere_cells cells[2];

static double half_again(const double *p, double roughness, lobe_sphere light)
{
    return p[0] * lobe_sphere_light_punctual(roughness, light);
}

static int make_cells(void **state)
{
    lobe_sweep_options options = lobe_sweep_options_default();
    (void)state;
    options.progress = 0;
    return lobe_sphere_cells_make(&cells[0], false, false, &options) &&
                   lobe_sphere_cells_make(&cells[1], false, true, &options) &&
                   lobe_sphere_cells_add_dark(&cells[0], &options) && lobe_sphere_cells_add_dark(&cells[1], &options)
               ? 0
               : -1;
}

static int free_cells(void **state)
{
    (void)state;
    lobe_sphere_cells_free(&cells[0]);
    lobe_sphere_cells_free(&cells[1]);
    return 0;
}

/* Through the judge of held-out cells. */
static void score_of(const lobe_sphere_tier *tier, const double *p, lobe_sphere_score score[2])
{
    double *y = malloc(LOBE_SPHERE_COUNT * sizeof *y);
    int set, i;
    assert_non_null(y);
    for (set = 0; set < 2; set++) {
        for (i = 0; i < LOBE_SPHERE_COUNT; i++)
            y[i] = tier->call(p, cells[set].in[5 * i], lobe_sphere_of_row(cells[set].in + 5 * i));
        lobe_sphere_judge_values(y, &cells[set], &score[set]);
    }
    free(y);
}

static void sum_is_the_metric(void **state)
{
    lobe_sphere_tier tier = {.name = "try", .call = half_again, .count = 1, .set_weight = {1, .5}};
    const double p[2] = {1, 1.5};
    static lobe_sphere_score score[2];
    lobe_sphere_problem problem;
    double sum[2], *rows;
    size_t i, k;
    (void)state;
    assert_true(lobe_sphere_problem_make(&problem, &tier, cells, 1));
    rows = malloc(2 * problem.rows * sizeof *rows);
    assert_non_null(rows);
    lobe_sphere_sum(&problem, p, 2, sum);
    lobe_sphere_residuals(&problem, p, 2, rows);
    for (k = 0; k < 2; k++) {
        double squares = 0, metric;
        for (i = 0; i < problem.rows; i++)
            squares += rows[k * problem.rows + i] * rows[k * problem.rows + i];
        score_of(&tier, p + k, score);
        metric = score[0].all * score[0].all + .25 * score[1].all * score[1].all;
        assert_true(fabs(squares / sum[k] - 1) <= 1e-12);
        assert_true(fabs(sum[k] / metric - 1) <= 1e-9);
    }
    free(rows);
    lobe_sphere_problem_free(&problem);
}

/* What the hinges add, against the same from the judge's figures of every cell. */
static void hinges(void **state)
{
    lobe_sphere_tier tier = {.name = "try", .call = half_again, .count = 1, .set_weight = {1, 0}};
    const double p = 1.5, one = 1;
    static lobe_sphere_score scaled[2], punctual[2];
    lobe_sphere_problem problem;
    double plain, with, expected = 0;
    int cell;
    (void)state;
    score_of(&tier, &p, scaled);
    score_of(&tier, &one, punctual);
    assert_true(lobe_sphere_problem_make(&problem, &tier, cells, 1));
    lobe_sphere_sum(&problem, &p, 1, &plain);
    lobe_sphere_problem_free(&problem);
    tier.excess_weight = 2;
    tier.excess_cap = .01;
    assert_true(lobe_sphere_problem_make(&problem, &tier, cells, 1));
    lobe_sphere_sum(&problem, &p, 1, &with);
    lobe_sphere_problem_free(&problem);
    for (cell = 0; cell < LOBE_SPHERE_CELLS; cell++) {
        const double *row = cells[0].in + 5 * LOBE_SPHERE_POSITIONS * cell;
        if (sin(row[4]) < .505 * row[0] * row[0])
            expected += pow(2 * fmax(0, scaled[0].cell[cell] - punctual[0].cell[cell] - .01), 2);
    }
    assert_true(expected > .1);
    assert_true(fabs((with - plain) / expected - 1) <= 1e-9);
    /* a cap above the worst cell's error is never felt, one just below it is */
    tier.excess_weight = 0;
    tier.energy_weight = 1;
    tier.energy_cap = fabs(scaled[0].energy) * (1 + 1e-9);
    assert_true(lobe_sphere_problem_make(&problem, &tier, cells, 1));
    lobe_sphere_sum(&problem, &p, 1, &with);
    lobe_sphere_problem_free(&problem);
    assert_true(with == plain);
    tier.energy_cap = fabs(scaled[0].energy) - .1;
    assert_true(lobe_sphere_problem_make(&problem, &tier, cells, 1));
    lobe_sphere_sum(&problem, &p, 1, &with);
    lobe_sphere_problem_free(&problem);
    assert_true(with - plain >= .01 * (1 - 1e-6));
}

/* The box of the global search holds what was found in it. */
static void tiers_are_whole(void **state)
{
    size_t k;
    int i;
    (void)state;
    for (i = 0; lobe_sphere_tier_at(i); i++) {
        const lobe_sphere_tier *t = lobe_sphere_tier_at(i);
        assert_true(t->count >= 1 && t->count <= LOBE_SPHERE_MOST && t->searches >= 1 && t->generations >= 1);
        for (k = 0; k < t->count; k++)
            assert_true(t->box[k][0] < t->box[k][1]);
    }
    assert_int_equal(i, 2);
    for (i = 0; lobe_sphere_lit_tier_at(i); i++) {
        const lobe_sphere_lit_tier *t = lobe_sphere_lit_tier_at(i);
        assert_true(t->count >= 1 && t->count <= LOBE_SPHERE_LIT_MOST && t->searches >= 1 && t->generations >= 1);
        assert_true(t->own + t->true_one <= 1 && (t->own + t->true_one == 1) == !t->under[0]);
        for (k = 0; k < t->count; k++)
            assert_true(t->box[k][0] < t->box[k][1]);
    }
    assert_int_equal(i, 2);
}

/* Radiance p[0] times the punctual light, schlick p[1]. */
static lobe_sphere_lit flat(const double *p, double roughness, lobe_sphere light)
{
    const lobe_sphere_lit lit = {p[0] * lobe_sphere_light_punctual(roughness, light), p[1]};
    return lit;
}

static double mean_square(const double *radiance[2], double schlick, double f0)
{
    static lobe_sphere_score score;
    double *s = malloc(LOBE_SPHERE_COUNT * sizeof *s), sum = 0;
    int set, i;
    assert_non_null(s);
    for (i = 0; i < LOBE_SPHERE_COUNT; i++)
        s[i] = schlick;
    for (set = 0; set < 2; set++) {
        lobe_sphere_judge_lit(radiance[set], s, f0, &cells[set], &score);
        sum += score.all * score.all;
    }
    free(s);
    return sum;
}

/* With Fresnel: its own radiance, the true one, and one that is given, each at two f0, against the judge. */
static void lit_sum_is_the_metric(void **state)
{
    lobe_sphere_lit_tier tier = {.name = "try", .call = flat, .count = 2, .weight = {0, 3, 0, 0, 1}};
    const double p[2] = {.7, .2};
    double *mine[2], *given[LOBE_SPHERE_BASES][2] = {{NULL}};
    int way, set, i;
    (void)state;
    for (set = 0; set < 2; set++) {
        mine[set] = malloc(2 * LOBE_SPHERE_COUNT * sizeof *mine[set]);
        assert_non_null(mine[set]);
        given[0][set] = mine[set] + LOBE_SPHERE_COUNT;
        for (i = 0; i < LOBE_SPHERE_COUNT; i++) {
            const double *row = cells[set].in + 5 * i;
            mine[set][i] = .7 * lobe_sphere_light_punctual(row[0], lobe_sphere_of_row(row));
            given[0][set][i] = .3 * cells[set].truth[i] + .001;
        }
    }
    for (way = 0; way < 3; way++) {
        const double *radiance[2];
        lobe_sphere_lit_problem problem;
        double expected, sum, squares = 0, *rows;
        size_t k;
        for (set = 0; set < 2; set++)
            radiance[set] = way == 0 ? mine[set] : way == 1 ? cells[set].truth : given[0][set];
        tier.own = way == 0;
        tier.true_one = way == 1;
        tier.under[0] = way == 2 ? "given" : NULL;
        assert_true(lobe_sphere_lit_problem_make(&problem, &tier, cells, given, 1));
        rows = malloc(problem.rows * sizeof *rows);
        assert_non_null(rows);
        lobe_sphere_lit_sum(&problem, p, 1, &sum);
        lobe_sphere_lit_residuals(&problem, p, 1, rows);
        for (k = 0; k < problem.rows; k++)
            squares += rows[k] * rows[k];
        expected = .75 * mean_square(radiance, p[1], .5) + .25 * mean_square(radiance, p[1], .02);
        assert_true(fabs(sum / expected - 1) <= 1e-9);
        assert_true(fabs(squares / expected - 1) <= 1e-9);
        free(rows);
        lobe_sphere_lit_problem_free(&problem);
    }
    free(mine[0]);
    free(mine[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tiers_are_whole),
        cmocka_unit_test(sum_is_the_metric),
        cmocka_unit_test(hinges),
        cmocka_unit_test(lit_sum_is_the_metric),
    };
    return cmocka_run_group_tests_name("sphere_light fit", tests, make_cells, free_cells);
}
