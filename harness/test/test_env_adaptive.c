/* The environment lobes whose number of taps follows a need: f32 and q30 against the same kernel in double, a count
 * that is that of the weights, no jump where a tap comes in, and the proof that no sum of the integers leaves 32 bits.
 * What holds for every fan is in test_env_lobes.c, bad numbers too; how near it comes to the truth is judged by
 * radiance (cases/env_lobes). */
#define LOBE_DOUBLE 1
#include "../../models/env_taps.h"
#include "../../models/lobe.h"
#include "../../models/q30/env_lobes_adaptive.h"
#include "cmocka_first.h"
#include <math.h>

enum { TAPS = 6 };

typedef struct fan {
    int count;
    double angle[TAPS], width[TAPS], weight[TAPS];
} fan;
typedef fan evaluator(double roughness, double n_dot_v);

static fan in_double(double r, double v)
{
    const lobe_env_fan6 f = lobe_env_lobes_adaptive(r, v);
    const lobe_env_tap t[TAPS] = {f.t0, f.t1, f.t2, f.t3, f.t4, f.t5};
    fan out = {(int)lobe_env_adaptive_count(r, v), {0}, {0}, {0}};
    int i;
    for (i = 0; i < TAPS; i++)
        out.angle[i] = t[i].angle, out.width[i] = t[i].width, out.weight[i] = t[i].weight;
    return out;
}

static fan in_f32(double r, double v)
{
    lobe_env_tap_f32 t[TAPS];
    fan out = {lobe_env_lobes_adaptive_f32((float)r, (float)v, t), {0}, {0}, {0}};
    int i;
    for (i = 0; i < TAPS; i++)
        out.angle[i] = (double)t[i].angle, out.width[i] = (double)t[i].width, out.weight[i] = (double)t[i].weight;
    return out;
}

static fan in_q30(double r, double v)
{
    lobe_env_tap_q30 t[TAPS];
    fan out = {lobe_env_lobes_adaptive_q30((int32_t)lrint(r * 0x1p30), (int32_t)lrint(v * 0x1p30), t), {0}, {0}, {0}};
    int i;
    for (i = 0; i < TAPS; i++)
        out.angle[i] = t[i].angle * 0x1p-30, out.width[i] = t[i].width * 0x1p-30,
        out.weight[i] = t[i].weight_q16 * 0x1p-16;
    return out;
}

static uint64_t random_state = 88172645463325252u;
/* A multiple of 2^-24: exact in every format. Every fourth is small. */
static double uniform(void)
{
    uint32_t bits;
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    bits = (uint32_t)(random_state >> 32);
    return floor((bits >> 8) / ((bits & 3) ? 1.0 : exp2((bits >> 2) % 20))) * 0x1p-24;
}

/* Taps that one format reads and the other does not weigh nothing; the angle and width of the others agree. */
static void near_the_formula(void **state)
{
    static const double allowed[2][3] = {{1e-4, 4e-5, 1e-4}, {0x1p-15, 0x1p-15, 0x1p-14}};
    double most[2][3] = {{0}};
    int i, f, k;
    (void)state;
    for (i = 0; i < 100000; i++) {
        const double r = i < 4 ? i & 1 : uniform(), v = i < 4 ? i >> 1 : uniform();
        const fan want = in_double(r, v);
        for (f = 0; f < 2; f++) {
            const fan got = (f ? in_q30 : in_f32)(r, v);
            for (k = 0; k < TAPS; k++) {
                const int both = k < want.count && k < got.count;
                most[f][0] = fmax(most[f][0], both ? fabs(got.angle[k] - want.angle[k]) : 0.0);
                most[f][1] = fmax(most[f][1], both ? fabs(got.width[k] - want.width[k]) : 0.0);
                most[f][2] = fmax(most[f][2], fabs(got.weight[k] - want.weight[k]));
            }
        }
    }
    for (f = 0; f < 2; f++) {
        print_message("# %s: angles within %.3g, widths %.3g, weights %.3g\n", f ? "q30" : "f32", most[f][0],
                      most[f][1], most[f][2]);
        for (k = 0; k < 3; k++)
            assert_true(most[f][k] <= allowed[f][k]);
    }
}

/* Read are those up to the count; the rest weigh nothing and look where the first does. */
static void count_is_that_of_the_weights(void **state)
{
    double read[3] = {0};
    int seen[TAPS + 1] = {0}, i, f, k;
    (void)state;
    for (i = 0; i < 128 * 128; i++) {
        const double r = (i / 128 + 0.5) / 128.0, v = (i % 128 + 0.5) / 128.0;
        for (f = 0; f < 3; f++) {
            const fan x = (f == 0 ? in_double : f == 1 ? in_f32 : in_q30)(r, v);
            assert_true(x.count >= 1 && x.count <= TAPS);
            for (k = x.count; k < TAPS; k++)
                assert_true(x.weight[k] == 0.0 && x.angle[k] == x.angle[0] && x.width[k] == x.width[0]);
            read[f] += x.count / (128.0 * 128.0);
            seen[x.count]++;
        }
    }
    print_message("# %.4f taps in the mean\n", read[1]);
    for (k = 1; k <= TAPS; k++)
        assert_true(seen[k] > 0);
    for (f = 0; f < 3; f++)
        assert_true(read[f] <= 2.2);
}

/* The step between neighbouring inputs across which the count changes: what is read on one side only weighs nothing,
 * and nothing else moves. */
static int across(evaluator *call, double unit, double r0, double v0, double r1, double v1)
{
    fan a = call(r0, v0), b = call(r1, v1);
    int k;
    if (a.count == b.count)
        return 0;
    while (fabs(r1 - r0) > unit || fabs(v1 - v0) > unit) {
        const double r = floor((r0 + r1) / 2 / unit) * unit, v = floor((v0 + v1) / 2 / unit) * unit;
        const fan middle = call(r, v);
        if (middle.count == a.count)
            r0 = r, v0 = v, a = middle;
        else
            r1 = r, v1 = v, b = middle;
    }
    for (k = 0; k < TAPS; k++) {
        const int both = k < a.count && k < b.count;
        if (!(fabs(a.weight[k] - b.weight[k]) <= 2e-4 &&
              (!both || (fabs(a.angle[k] - b.angle[k]) <= 2e-4 && fabs(a.width[k] - b.width[k]) <= 2e-4))))
            fail_msg("tap %d jumps at roughness %.9g, n_dot_v %.9g: %g %g %g to %g %g %g", k, r0, v0, a.angle[k],
                     a.width[k], a.weight[k], b.angle[k], b.width[k], b.weight[k]);
    }
    return 1;
}

static void nothing_jumps_where_a_tap_comes_in(void **state)
{
    enum { LINES = 60, STEPS = 128 };
    int f, line, i;
    (void)state;
    for (f = 0; f < 2; f++) {
        evaluator *const call = f ? in_q30 : in_f32;
        int borders = 0;
        for (line = 0; line < LINES; line++)
            for (i = 0; i < STEPS - 1; i++) {
                const double at = 0.05 + floor(0.94 * 0x1p20 * line / LINES) * 0x1p-20, x = 0.02 + i * 0.0076;
                const double here = floor(x * 0x1p20) * 0x1p-20, there = here + 0x1p-7;
                borders += across(call, 0x1p-20, at, here, at, there) + across(call, 0x1p-20, here, at, there, at);
            }
        print_message("# %s: %d borders\n", f ? "q30" : "f32", borders);
        assert_true(borders > 100);
    }
}

/* Products are with numbers in [0, 1]: sums under 2047 in Q20 and 511 in Q22 leave room for roundings. */
static void no_sum_leaves_32_bits(void **state)
{
    static const int32_t need[] = LOBE_ENV_NEED_ROW, rows[][LOBE_ENV_ADAPTIVE_COLUMNS] = LOBE_ENV_ADAPTIVE_ROWS;
    double sum = 0.0;
    int i, k;
    (void)state;
    assert_int_equal(sizeof need / sizeof need[0], LOBE_ENV_ADAPTIVE_NEEDS);
    assert_int_equal(sizeof rows / sizeof rows[0], LOBE_ENV_ADAPTIVE_ROW_COUNT);
    for (k = 0; k < LOBE_ENV_ADAPTIVE_NEEDS; k++)
        sum += fabs((double)need[k]) * 0x1p-22;
    if (!(sum < 511.0))
        fail_msg("the need's coefficients add up to %g", sum);
    for (i = 0; i < LOBE_ENV_ADAPTIVE_ROW_COUNT; i++) {
        for (sum = 0.0, k = 0; k < LOBE_ENV_ADAPTIVE_COLUMNS; k++)
            sum += fabs((double)rows[i][k]) * 0x1p-20;
        if (!(sum < 2047.0))
            fail_msg("row %d: coefficients add up to %g", i, sum);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(near_the_formula),
        cmocka_unit_test(count_is_that_of_the_weights),
        cmocka_unit_test(nothing_jumps_where_a_tap_comes_in),
        cmocka_unit_test(no_sum_leaves_32_bits),
    };
    return cmocka_run_group_tests_name("env_adaptive", tests, NULL, NULL);
}
