/* The fit of environment lobes: the kernel texts are what the fit moves, weights sum to the albedo, at n_dot_v = 1
 * every tap is at the normal, parameters are continuous; two integrators agree on the shape; and the committed tiers
 * keep their floors on environments that they were not fitted to. */
#define LOBE_DOUBLE 1
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../../models/env_lobes4.h"
#include "../../models/env_lobes8.h"
#include "../env_lobes/adaptive_contender.h"
#include "../env_lobes/asg.h"
#include "../env_lobes/contenders.h"
#include "../env_lobes/fan.h"
#include "../env_lobes/fresnel.h"
#include "../env_lobes/kernels.h"
#include "../env_lobes/rooms.h"
#include "../env_lobes/shape.h"
#include "../env_lobes/table_contenders.h"
#include "../fit/random.h"

static void weights_sum_to_the_albedo(void **state)
{
    lobe_random r;
    (void)state;
    lobe_random_seed(&r, 41, 0);
    for (int i = 0; i < 2000; i++) {
        const double e = lobe_random_unit(&r);
        const lobe_env_fan4 four = lobe_env_lobes_lobes4(lobe_random_unit(&r), lobe_random_unit(&r), e);
        const lobe_env_fan8 eight = lobe_env_lobes_lobes8(lobe_random_unit(&r), lobe_random_unit(&r), e);
        assert_true(fabs(four.t0.weight + four.t1.weight + four.t2.weight + four.t3.weight - e) <= 1e-14);
        assert_true(fabs(eight.t0.weight + eight.t1.weight + eight.t2.weight + eight.t3.weight + eight.t4.weight +
                         eight.t5.weight + eight.t6.weight + eight.t7.weight - e) <= 1e-13);
    }
}

static void at_the_normal_nothing_turns(void **state)
{
    (void)state;
    for (int m = 2; m < LOBE_CONTENDERS; m++)
        for (double alpha = .0025; alpha <= 1; alpha *= 1.5) {
            lobe_cell_tap taps[LOBE_CELL_TAPS];
            const int count = lobe_contender[m].taps(lobe_contender[m].ctx, alpha, 1, taps);
            for (int i = 0; i < count; i++)
                assert_true(taps[i].angle == 0);
        }
}

/* A step of 1e-6 in either input moves no tap by more than 2e-3. */
static void taps_are_continuous(void **state)
{
    lobe_random r;
    (void)state;
    lobe_random_seed(&r, 42, 0);
    for (int i = 0; i < 4000; i++) {
        const double alpha = .001 + .99 * lobe_random_unit(&r), v = .99999 * lobe_random_unit(&r);
        const int m = 2 + i % 4;
        lobe_cell_tap a[LOBE_CELL_TAPS], b[LOBE_CELL_TAPS], c[LOBE_CELL_TAPS];
        const int count = lobe_contender[m].taps(lobe_contender[m].ctx, alpha, v, a);
        lobe_contender[m].taps(lobe_contender[m].ctx, alpha + 1e-6, v, b);
        lobe_contender[m].taps(lobe_contender[m].ctx, alpha, v + 1e-6, c);
        for (int k = 0; k < count; k++) {
            assert_true(fabs(a[k].angle - b[k].angle) <= 2e-3 && fabs(a[k].angle - c[k].angle) <= 2e-3);
            assert_true(fabs(exp(a[k].log_t) - exp(b[k].log_t)) <= 2e-3 * fmax(1, exp(a[k].log_t)));
            assert_true(fabs(a[k].weight - b[k].weight) <= 2e-3 && fabs(a[k].weight - c[k].weight) <= 2e-3);
        }
    }
}

/* The fit's own spelling of a fan, with coefficients that it wrote. */
static void kernels_are_what_is_fitted(void **state)
{
    lobe_random r;
    double p[LOBE_FAN_MOST];
    (void)state;
    lobe_random_seed(&r, 43, 0);
    for (int i = 0; i < LOBE_FAN_MOST; i++)
        p[i] = lobe_random_unit(&r) - .5;
    for (int i = 0; i < 500; i++) {
        const double alpha = .001 + .99 * lobe_random_unit(&r), v = lobe_random_unit(&r);
        const lobe_fan_point point = lobe_fan_point_of(alpha, v);
        const lobe_env_point k = lobe_env_point_of(sqrt(alpha), v);
        double shift, wide;
        lobe_cell_tap taps[2];
        lobe_env_tap first;
        lobe_fan_taps(&point, p, 2, taps, NULL);
        shift = lobe_env_sum(k, p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8], p[9], p[10], p[11]);
        wide = lobe_env_sum(k, p[12], p[13], p[14], p[15], p[16], p[17], p[18], p[19], p[20], p[21], p[22], p[23]);
        first = lobe_env_tap_of(k, shift, wide, 0);
        assert_true(fabs(first.angle - taps[0].angle) <= 1e-12);
        assert_true(fabs(first.width * first.width - lobe_prefilter_alpha_of_t(exp(taps[0].log_t))) <= 1e-12);
        assert_true(fabs(taps[0].weight + taps[1].weight - 1) <= 1e-12);
    }
}

/* Cubature and sampling agree to a hundredth of the error, also with negative weights. */
static void shape_agrees(void **state)
{
    static const double at[][2] = {{.04, 1}, {.1, .5}, {.3, .1}, {.3, .8}, {1, .5}};
    (void)state;
    for (int i = 0; i < 5; i++)
        for (int m = 0; m < LOBE_CONTENDERS; m += 2) {
            lobe_cell_tap taps[LOBE_CELL_TAPS];
            const int count = lobe_contender[m].taps(lobe_contender[m].ctx, at[i][0], at[i][1], taps);
            const double a = lobe_shape_error(at[i][0], at[i][1], taps, count);
            const double b = lobe_shape_error_sampled(at[i][0], at[i][1], taps, count, 400000);
            print_message("# alpha %g, n_dot_v %g, %s: %.4f, sampled %.4f\n", at[i][0], at[i][1],
                          lobe_contender[m].name, a, b);
            assert_true(fabs(a / b - 1) <= .01);
        }
}

/* The floors of the radiance error, as parts of the split sum's, over three environments; and a closed form is at most
 * a point worse than its table. */
static void floors_hold(void **state)
{
    enum {
        TABLES = LOBE_CONTENDERS,
        ADAPTIVE = TABLES + LOBE_TABLE_CONTENDERS,
        MODELS = ADAPTIVE + 1,
        CLOSED = TABLES - LOBE_TABLE_CONTENDERS
    };
    static const double floor_of[MODELS] = {1, 1, .30, .18, .12, .08, .30, .18, .12, .08, .12};
    lobe_judge_model models[MODELS];
    double sum[MODELS] = {0};
    (void)state;
    memcpy(models, lobe_contender, sizeof lobe_contender);
    memcpy(models + TABLES, lobe_table_contender, sizeof lobe_table_contender);
    models[ADAPTIVE] = lobe_adaptive_contender;
    for (int i = 0; i < 3; i++) {
        static const lobe_room room[3] = {LOBE_ROOM_SKY, LOBE_ROOM_LAMPS, LOBE_ROOM_CLOUDS};
        lobe_environment map;
        lobe_judge_error e[MODELS];
        const lobe_judge_options options = {2, 9, 0};
        assert_true(lobe_room_make(&map, room[i], 256, 201));
        assert_true(lobe_judge_environment(&map, &options, models, MODELS, e));
        for (int m = 0; m < MODELS; m++)
            sum[m] += e[m].relative * e[m].relative;
        lobe_environment_free(&map);
    }
    for (int m = 0; m < MODELS; m++) {
        print_message("# %s: %.4f, %.3f of the split sum\n", models[m].name, sqrt(sum[m] / 3), sqrt(sum[m] / sum[0]));
        assert_true(sqrt(sum[m] / sum[0]) <= floor_of[m]);
    }
    for (int k = 0; k < LOBE_TABLE_CONTENDERS; k++)
        assert_true(sqrt(sum[CLOSED + k] / 3) - sqrt(sum[TABLES + k] / 3) <= .01);
    assert_true(lobe_adaptive_contender_mean(512) <= 2.2);
}

/* An ASG's nodes are a quadrature of it, and the fit's error is that of another integrator. */
static double asg_at(void *ctx, const double d[3]) { return lobe_asg_at(ctx, d); }

static void asg_is_integrated(void **state)
{
    static const double at[][2] = {{.1, .25}, {.6, .6}};
    static double rows[5 * LOBE_JUDGE_NODES];
    (void)state;
    for (int i = 0; i < 2; i++) {
        double error, sum = 0, weight;
        lobe_asg asg = lobe_asg_fit(at[i][0], at[i][1], 1, &error);
        const int count = lobe_asg_nodes(&asg, 40, rows);
        for (int k = 0; k < count; k++)
            sum += rows[5 * k + 3];
        assert_true(fabs(sum - 1) <= 1e-6 && fabs(lobe_cubature(asg_at, &asg, 1e-4) - 1) <= 1e-4);
        assert_true(fabs(lobe_shape_error_of(at[i][0], at[i][1], asg_at, &asg) / error - 1) <= 1e-3);
        weight = lobe_asg_fit(at[i][0], at[i][1], 0, &sum).weight;
        assert_true(sum < error && weight < 1);
    }
}

/* At f0 .04 the way that ships takes a third of the error away that one factor on all taps leaves, where there is more
 * than one; at F = 1 there is nothing to give. */
static void fresnel_per_tap_pays(void **state)
{
    static lobe_judge_error e[LOBE_FRESNEL_WAYS][LOBE_FRESNEL_F0S][LOBE_FRESNEL_MODELS];
    const lobe_judge_options options = {2, 9, 0};
    lobe_environment map;
    (void)state;
    assert_true(lobe_room_make(&map, LOBE_ROOM_SKY, 256, 202));
    assert_true(lobe_fresnel_judge(&map, &options, lobe_contender + 2, 4, e));
    lobe_environment_free(&map);
    assert_true(lobe_fresnel_f0[0] == 1 && lobe_fresnel_f0[3] == .04);
    for (int m = 0; m < 4; m++) {
        const double factor = e[LOBE_FRESNEL_FACTOR][3][m].relative, shipped = e[LOBE_FRESNEL_SHIPPED][3][m].relative;
        print_message("# f0 .04, %s: %.4f, one factor %.4f, F = 1 %.4f\n", lobe_contender[2 + m].name, shipped, factor,
                      e[LOBE_FRESNEL_SHIPPED][0][m].relative);
        assert_true(fabs(e[LOBE_FRESNEL_SHIPPED][0][m].relative - e[LOBE_FRESNEL_FACTOR][0][m].relative) <= 1e-9);
        assert_true(m == 0 ? fabs(shipped - factor) <= 1e-9 : shipped <= .667 * factor);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(weights_sum_to_the_albedo),
        cmocka_unit_test(at_the_normal_nothing_turns),
        cmocka_unit_test(taps_are_continuous),
        cmocka_unit_test(kernels_are_what_is_fitted),
        cmocka_unit_test(shape_agrees),
        cmocka_unit_test(floors_hold),
        cmocka_unit_test(asg_is_integrated),
        cmocka_unit_test(fresnel_per_tap_pays),
    };
    return cmocka_run_group_tests_name("environment lobes, fit", tests, NULL, NULL);
}
