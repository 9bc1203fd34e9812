/* The truth of the split sum and of energy against closed forms, limits and the third opinion. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <math.h>
#include <string.h>
#include "../energy/truth_energy.h"
#include "../fit/digest.h"
#include "../fit/sweep.h"
#include "../split_sum/truth_nodes.h"
#include "../split_sum/truth_qmc.h"
#include "../split_sum/truth_split_sum.h"

/* The kernel once more, with a count of what it evaluates. */
static size_t evaluations;
#define LOBE_DOUBLE
#define LOBE_TRUTH_EVALUATED evaluations++
#include "../split_sum/truth_kernel.h"

static void near(double got, double want, double tolerance)
{
    if (!(fabs(got - want) <= tolerance))
        fail_msg("got %.17g, want %.17g within %g", got, want, tolerance);
}

/* E = int l / (2 (l + 1)) dl int 1/pi dphi = 1 - ln 2 where D is constant; separable: the same V at v = 1 */
static void closed_form(void **state)
{
    const double in[2] = {1, 1};
    double out[2];
    size_t count;
    (void)state;
    lobe_truth_energy_rows(in, out, 1);
    near(out[0], 1 - log(2), 1e-14);
    near(lobe_truth_energy(0, 1, 1, LOBE_TRUTH_ORDER, &count), 1 - log(2), 1e-14);
    lobe_truth_split_sum_sep_rows(in, out, 1);
    near(out[0] + out[1], 1 - log(2), 1e-14);
    /* alpha = 1, any v: D = 1/pi and V = 1 / (2 (l + v)) leave E = 1 - v ln((1 + v) / v) */
    lobe_truth_split_sum_order(0, 1, 0.25, LOBE_TRUTH_ORDER, out);
    near(out[0] + out[1], 1 - 0.25 * log(5), 1e-12);
    /* Schlick-Smith at alpha = 1, k = 1/2: V = 1 / ((l + 1)(v + 1)), E = 2 (1 - ln 2) / (1 + v) */
    lobe_truth_split_sum_order(2, 1, 0.25, LOBE_TRUTH_ORDER, out);
    near(out[0] + out[1], 2 * (1 - log(2)) / 1.25, 1e-12);
}

/* A mirror: scale = 1 - (1 - v)^5, bias = (1 - v)^5, but for terms of order (alpha / v)^2 */
static void smooth_limit(void **state)
{
    static const double views[] = {0.1, 0.3, 0.5, 0.8, 1};
    size_t i;
    int smith;
    (void)state;
    for (smith = 0; smith < 3; smith++) {
        for (i = 0; i < sizeof views / sizeof *views; i++) {
            const double v = views[i], f = pow(1 - v, 5), alpha = 1e-6;
            double out[2];
            lobe_truth_split_sum_order(smith, alpha, v, LOBE_TRUTH_ORDER, out);
            /* Schlick-Smith loses light at first order: G1 = 1 - k (1 - v) / v */
            const double loss = smith == 2 ? alpha * (1 - v) / v : 0;
            near(out[0], (1 - loss) * (1 - f), 4e-9);
            near(out[1], (1 - loss) * f, 4e-9);
        }
    }
}

static void counts(void **state)
{
    static const double alpha[] = {1e-6, 0.002, 0.1, 1}, view[] = {0.001, 0.1, 0.5, 1};
    double u[LOBE_TRUTH_ORDER], weight[LOBE_TRUTH_ORDER], out[2];
    size_t i, k, count;
    (void)state;
    lobe_truth_nodes(u, weight, LOBE_TRUTH_ORDER);
    for (i = 0; i < 4; i++) {
        for (k = 0; k < 4; k++) {
            evaluations = 0;
            lobe_truth_split_sum(LOBE_TRUTH_CORRELATED, alpha[i], view[k], u, weight, LOBE_TRUTH_ORDER);
            assert_in_range(evaluations, 1, 2400);
            count = lobe_truth_split_sum_order(0, alpha[i], view[k], LOBE_TRUTH_ORDER, out);
            assert_int_equal(evaluations, count);
            lobe_truth_energy(0, alpha[i], view[k], LOBE_TRUTH_ORDER, &count);
            assert_in_range(count, 1, 84);
        }
    }
}

/* Moments of x on [0, 1]: a rule of n nodes is exact up to x^(2n - 1) */
static void nodes(void **state)
{
    double u[LOBE_TRUTH_NODES_MAX], weight[LOBE_TRUTH_NODES_MAX];
    static const int orders[] = {1, 2, 3, 7, 28, 64, 256};
    size_t k;
    int i, power;
    (void)state;
    for (k = 0; k < sizeof orders / sizeof *orders; k++) {
        const int n = orders[k];
        lobe_truth_nodes(u, weight, n);
        for (power = 0; power < 2 * n && power < 60; power++) {
            double sum = 0;
            for (i = 0; i < n; i++)
                sum += weight[i] * pow(u[i], power);
            near(sum, 1.0 / (power + 1), 1e-14);
        }
        for (i = 1; i < n; i++)
            assert_true(u[i] > u[i - 1]);
    }
}

static void energy_by_another_way(void **state)
{
    int smith, i, k;
    (void)state;
    for (smith = 0; smith < 3; smith++) {
        for (i = 0; i <= 12; i++) {
            for (k = 0; k <= 12; k++) {
                const double alpha = 0.002 * pow(500, i / 12.0), v = 0.001 * pow(1000, k / 12.0);
                double out[2];
                size_t count;
                lobe_truth_split_sum_order(smith, fmin(1, alpha), fmin(1, v), LOBE_TRUTH_ORDER, out);
                near(lobe_truth_energy(smith, fmin(1, alpha), fmin(1, v), LOBE_TRUTH_ORDER, &count), out[0] + out[1],
                     1e-9);
            }
        }
    }
}

/* Five standard errors, and one sample's worth of what a finite set of points can miss in the tail. */
static void third_opinion(void **state)
{
    static const double at[][2] = {{0.0025, 0.3}, {0.01, 0.9}, {0.04, 0.05}, {0.25, 0.5},
                                   {0.25, 1},     {1, 0.02},   {1, 0.9}};
    size_t i;
    int smith, sequence;
    (void)state;
    for (smith = 0; smith < 3; smith++) {
        for (sequence = 0; sequence < 2; sequence++) {
            for (i = 0; i < sizeof at / sizeof *at; i++) {
                lobe_qmc_options options = lobe_qmc_options_default();
                double truth[2], got[2], error[2];
                options.sequence = (lobe_qmc_sequence)sequence;
                options.samples = 8192;
                lobe_truth_split_sum_order(smith, at[i][0], at[i][1], LOBE_TRUTH_ORDER, truth);
                lobe_truth_qmc(smith, at[i][0], at[i][1], &options, got, error);
                near(got[0], truth[0], 5 * error[0] + 1.0 / 8192);
                near(got[1], truth[1], 5 * error[1] + 1.0 / 8192);
                assert_true(error[0] < 1e-4 && error[1] < 1e-4);
            }
        }
    }
}

/* Inside [0, 1], and monotone where the physics is: bias falls with NdotV on a smooth surface */
static void range(void **state)
{
    int smith, i, k;
    (void)state;
    for (smith = 0; smith < 3; smith++) {
        for (i = 0; i <= 24; i++) {
            double before = 2;
            for (k = 0; k <= 24; k++) {
                const double alpha = fmin(1, 1e-6 * pow(1e6, i / 24.0)), v = fmin(1, 0.001 * pow(1000, k / 24.0));
                double out[2];
                lobe_truth_split_sum_order(smith, alpha, v, LOBE_TRUTH_ORDER, out);
                assert_true(out[0] > 0 && out[1] > 0 && out[0] + out[1] <= 1 + 1e-12);
                if (alpha < 1e-5 && smith < 2) /* Schlick-Smith darkens at first order in alpha / v */
                    assert_true(out[1] < before);
                before = out[1];
            }
        }
    }
}

static void threads(void **state)
{
    double in[2 * 1000], one[2 * 1000], many[2 * 1000];
    lobe_sweep_options options = lobe_sweep_options_default();
    size_t i;
    int n;
    (void)state;
    for (i = 0; i < 1000; i++) {
        in[2 * i] = 0.001 + 0.999 * (double)(i % 37) / 36;
        in[2 * i + 1] = 0.001 + 0.999 * (double)(i % 101) / 100;
    }
    options.progress = 0;
    options.threads = 1;
    lobe_sweep(lobe_truth_split_sum_rows, in, 2, one, 2, 1000, &options);
    for (n = 2; n <= 7; n++) {
        memset(many, 0xff, sizeof many);
        options.threads = n;
        lobe_sweep(lobe_truth_split_sum_rows, in, 2, many, 2, 1000, &options);
        assert_memory_equal(one, many, sizeof one);
    }
}

/* The published test values of FNV-1a, 64 bit */
static void digest(void **state)
{
    (void)state;
    assert_true(lobe_digest(LOBE_DIGEST_START, "", 0) == UINT64_C(0xcbf29ce484222325));
    assert_true(lobe_digest(LOBE_DIGEST_START, "a", 1) == UINT64_C(0xaf63dc4c8601ec8c));
    assert_true(lobe_digest(LOBE_DIGEST_START, "foobar", 6) == UINT64_C(0x85944171f73967e8));
    assert_true(lobe_digest(lobe_digest(LOBE_DIGEST_START, "foo", 3), "bar", 3) == UINT64_C(0x85944171f73967e8));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closed_form),   cmocka_unit_test(smooth_limit), cmocka_unit_test(counts),
        cmocka_unit_test(nodes),         cmocka_unit_test(range),        cmocka_unit_test(energy_by_another_way),
        cmocka_unit_test(third_opinion), cmocka_unit_test(threads),      cmocka_unit_test(digest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
