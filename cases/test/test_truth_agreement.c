/* Two integrators that share nothing, and the production rule against its own limit. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <math.h>
#include <stdint.h>
#include "../fit/random.h"
#include "../split_sum/truth_half.h"
#include "../split_sum/truth_split_sum.h"

static void near(double got, double want, double tolerance, double alpha, double v)
{
    if (!(fabs(got - want) <= tolerance))
        fail_msg("alpha %.17g v %.17g: got %.17g, want %.17g within %g", alpha, v, got, want, tolerance);
}

/* Half of the points uniform, half logarithmic, so that narrow lobes and grazing views are among them. */
static double draw(lobe_random *random, double lo, int logarithmic)
{
    const double u = lobe_random_unit(random);
    return logarithmic ? pow(lo, 1 - u) : lo + (1 - lo) * u;
}

static void light_against_half(int smith)
{
    lobe_random random;
    int i;
    lobe_random_seed(&random, 2024, (uint64_t)smith);
    for (i = 0; i < 40; i++) {
        const double alpha = draw(&random, 0.002, i & 1), v = draw(&random, 0.001, i & 2);
        double light[2], half[2];
        lobe_truth_split_sum_order(smith, alpha, v, 64, light);
        lobe_truth_half(smith, alpha, v, 1.0 / 24, half);
        near(light[0], half[0], 1e-12, alpha, v);
        near(light[1], half[1], 1e-12, alpha, v);
        near(light[0] + light[1], half[0] + half[1], 1e-12, alpha, v);
    }
}

static void correlated(void **state)
{
    (void)state;
    light_against_half(0);
}

static void separable(void **state)
{
    (void)state;
    light_against_half(1);
}

static void schlick_smith(void **state)
{
    (void)state;
    light_against_half(2);
}

/* alpha from roughness .001, where `lobefit truth` begins */
static void production(void **state)
{
    int smith, i, k;
    (void)state;
    for (smith = 0; smith < 3; smith++) {
        for (i = 0; i <= 20; i++) {
            for (k = 0; k <= 20; k++) {
                const double alpha = fmin(1, 1e-6 * pow(1e6, i / 20.0)), v = fmin(1, 0.001 * pow(1000, k / 20.0));
                double fast[2], slow[2];
                lobe_truth_split_sum_order(smith, alpha, v, LOBE_TRUTH_ORDER, fast);
                lobe_truth_split_sum_order(smith, alpha, v, 64, slow);
                near(fast[0], slow[0], 1e-9, alpha, v);
                near(fast[1], slow[1], 1e-9, alpha, v);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(correlated),
        cmocka_unit_test(separable),
        cmocka_unit_test(schlick_smith),
        cmocka_unit_test(production),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
