/* Fans of taps from tables: f32 and q30 against the same lookup in double, how a shader addresses the nodes, weights
 * that sum to the albedo, no angle at normal incidence, the mirror, and lookups without jumps. Any bits at all:
 * test_env_lobes.c. How near the taps come to the truth is judged by radiance (cases/env_lobes). */
#define LOBE_DOUBLE 1
#include "../../models/env_lobes_table.h"
#include "../../models/energy.h"
#include "../../models/lobe.h"
#include "cmocka_first.h"
#include <math.h>

enum { SIDE = LOBE_ENV_TABLE16_SIDE, TAPS = 8 };

static const struct table {
    int taps;
    const int16_t *nodes;
    void (*f32)(float, float, lobe_env_tap_f32 *);
    void (*q30)(int32_t, int32_t, lobe_env_tap_q30 *);
} tables[] = {
    {1, lobe_env_lobes1_table16_i16, lobe_env_lobes1_table16_f32, lobe_env_lobes1_table16_q30},
    {2, lobe_env_lobes2_table16_i16, lobe_env_lobes2_table16_f32, lobe_env_lobes2_table16_q30},
    {4, lobe_env_lobes4_table16_i16, lobe_env_lobes4_table16_f32, lobe_env_lobes4_table16_q30},
    {8, lobe_env_lobes8_table16_i16, lobe_env_lobes8_table16_f32, lobe_env_lobes8_table16_q30},
};
enum { TABLES = sizeof tables / sizeof tables[0] };

static uint64_t random_state = 88172645463325252u;
/* A multiple of 2^-24: exact in every format. Every fourth is small. */
static double uniform(void)
{
    uint32_t bits;
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    bits = (uint32_t)(random_state >> 32);
    return floor((bits >> 8) / ((bits & 3) ? 1.0 : exp2((double)(random_state % 20)))) * 0x1p-24;
}

/* A texture unit with channels that hold number / 32767: linear filter, clamp to edge. */
static double fetch(const struct table *t, lobe_table_uv uv, int number)
{
    const double x = fmin(fmax(uv.u * SIDE - 0.5, 0.0), SIDE - 1.0), y = fmin(fmax(uv.v * SIDE - 0.5, 0.0), SIDE - 1.0);
    const int k = (int)fmin(x, SIDE - 2), i = (int)fmin(y, SIDE - 2), numbers = 3 * t->taps - 1;
    const int16_t *p = t->nodes + numbers * (SIDE * i + k) + number, *below = p + numbers * SIDE;
    const double a = x - k, b = y - i;
    return ((p[0] * (1.0 - a) + p[numbers] * a) * (1.0 - b) + (below[0] * (1.0 - a) + below[numbers] * a) * b) / 32767;
}

/* As a shader does it. */
static void by_texture(const struct table *t, double r, double v, double *x)
{
    const lobe_table_uv uv = lobe_split_sum_table_uv(r, v, SIDE);
    const double e = lobe_energy_high(r, v);
    const lobe_env_table_scales p = lobe_env_table_scales_of(r, v, e, 32767.0);
    double rest = e;
    int i;
    for (i = 0; i < t->taps; i++) {
        const double weight = i < t->taps - 1 ? p.weight * fetch(t, uv, 3 * i + 2) : rest;
        const lobe_env_tap tap = lobe_env_table_tap(p, fetch(t, uv, 3 * i), fetch(t, uv, 3 * i + 1), weight);
        x[3 * i] = tap.angle, x[3 * i + 1] = tap.width, x[3 * i + 2] = weight;
        rest -= weight;
    }
}

static void by_f32(const struct table *t, double r, double v, double *x)
{
    lobe_env_tap_f32 taps[TAPS];
    int i;
    t->f32((float)r, (float)v, taps);
    for (i = 0; i < t->taps; i++)
        x[3 * i] = (double)taps[i].angle, x[3 * i + 1] = (double)taps[i].width, x[3 * i + 2] = (double)taps[i].weight;
}

static void by_q30(const struct table *t, double r, double v, double *x)
{
    lobe_env_tap_q30 taps[TAPS];
    int i;
    t->q30((int32_t)lrint(r * 0x1p30), (int32_t)lrint(v * 0x1p30), taps);
    for (i = 0; i < t->taps; i++)
        x[3 * i] = taps[i].angle * 0x1p-30, x[3 * i + 1] = taps[i].width * 0x1p-30,
              x[3 * i + 2] = taps[i].weight_q16 * 0x1p-16;
}

static void near_the_formula_and_the_albedo(void **state)
{
    static const double f32_allowed[] = {1e-4, 4e-5, 4e-5}, q30_allowed[] = {0x1p-16, 0x1p-16, 0x1p-15};
    int t, i, k;
    (void)state;
    for (t = 0; t < TABLES; t++) {
        double worst[2][3] = {{0.0}};
        for (i = 0; i < 50000; i++) {
            const double r = i < 4 ? i & 1 : uniform(), v = i < 4 ? i >> 1 : uniform();
            const double e = (double)lobe_energy_high_f32((float)r, (float)v);
            double want[3 * TAPS], f32[3 * TAPS], q30[3 * TAPS], sum_f32 = 0.0, sum_q30 = 0.0;
            by_texture(&tables[t], r, v, want);
            by_f32(&tables[t], r, v, f32);
            by_q30(&tables[t], r, v, q30);
            for (k = 0; k < 3 * tables[t].taps; k++) {
                /* the last weight has the others' rounding */
                const double half = k == 3 * tables[t].taps - 1 ? 0.5 : 1.0;
                worst[0][k % 3] = fmax(worst[0][k % 3], fabs(f32[k] - want[k]));
                worst[1][k % 3] = fmax(worst[1][k % 3], half * fabs(q30[k] - want[k]));
                sum_f32 += k % 3 == 2 ? f32[k] : 0.0;
                sum_q30 += k % 3 == 2 ? q30[k] : 0.0;
            }
            if (!(fabs(sum_f32 - e) <= 1e-5 && fabs(sum_q30 - e) <= 1e-5))
                fail_msg("%d taps at roughness %.9g, n_dot_v %.9g: sums %.9g and %.9g, albedo %.9g", tables[t].taps, r,
                         v, sum_f32, sum_q30, e);
        }
        print_message("# %d taps: f32 within %.2g, %.2g, %.2g of the formula in double, q30 %.2g, %.2g, %.2g\n",
                      tables[t].taps, worst[0][0], worst[0][1], worst[0][2], worst[1][0], worst[1][1], worst[1][2]);
        for (k = 0; k < 3; k++)
            assert_true(worst[0][k] <= f32_allowed[k] && worst[1][k] <= q30_allowed[k]);
    }
}

/* Where there is no plane of incidence no tap leans, and at roughness 0 all stand at the mirror and read its mip. */
static void normal_incidence_and_mirror(void **state)
{
    int t, i, k, f;
    (void)state;
    for (t = 0; t < TABLES; t++) {
        for (f = 0; f < 2; f++) {
            for (i = 0; i <= 1000; i++) {
                double x[3 * TAPS];
                (f ? by_q30 : by_f32)(&tables[t], i / 1000.0, 1.0, x);
                for (k = 0; k < tables[t].taps; k++)
                    assert_true(x[3 * k] == 0.0);
                (f ? by_q30 : by_f32)(&tables[t], 0.0, i / 1000.0, x);
                for (k = 0; k < tables[t].taps; k++)
                    assert_true(fabs(x[3 * k] - acos(i / 1000.0)) <= 0x1p-16 && x[3 * k + 1] == 0.0);
            }
        }
    }
}

/* Steps of 1e-3 in roughness and in the view's angle (its cosine has no slope at the normal), where taps were fitted.
 */
static void continuous(void **state)
{
    static const double allowed[] = {0.02, 0.02, 0.1};
    int t, a, b, k, side;
    (void)state;
    for (t = 0; t < TABLES; t++) {
        double most[3] = {0.0};
        for (a = 0; a < 250; a++) {
            for (b = 0; b < 250; b++) {
                const double r = 0.2 + 0.798 * a / 249.0, theta = acos(0.05) * b / 249.0;
                double x[3 * TAPS], y[3 * TAPS];
                by_f32(&tables[t], r, cos(theta), x);
                for (side = 0; side < 2; side++) {
                    by_f32(&tables[t], r + (side ? 0.0 : 1e-3), cos(theta + (side ? 1e-3 : 0.0)), y);
                    for (k = 0; k < 3 * tables[t].taps; k++)
                        most[k % 3] = fmax(most[k % 3], fabs(y[k] - x[k]));
                }
            }
        }
        print_message("# %d taps: a step of 1e-3 moves angles by %.3g, widths by %.3g, weights by %.3g\n",
                      tables[t].taps, most[0], most[1], most[2]);
        for (k = 0; k < 3; k++)
            assert_true(most[k] <= allowed[k]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(near_the_formula_and_the_albedo),
        cmocka_unit_test(normal_incidence_and_mirror),
        cmocka_unit_test(continuous),
    };
    return cmocka_run_group_tests_name("environment lobes from tables", tests, NULL, NULL);
}
