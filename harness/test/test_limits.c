/* What is known without any integral: limits of the split sum, and the shape of its bias. The tolerances are
 * the stated bounds, so these tests sharpen with the models. Those of diffuse_sh are in test_diffuse_sh.c. */
#include "../registry.h"
#include "cmocka_first.h"
#include <math.h>

/* Albedos of GGX: their outputs add up to E. */
static int is_ggx(const lobe_entry *e) { return e->sums || lobe_same(e->model, "energy"); }

static void evaluate(const lobe_entry *e, double roughness, double n_dot_v, double *out)
{
    lobe_value in[LOBE_MAX_INPUTS], raw[LOBE_MAX_OUTPUTS];
    int k;
    in[0] = lobe_value_nearest(e->format, roughness);
    in[1] = lobe_value_nearest(e->format, n_dot_v);
    e->call(in, raw);
    for (k = 0; k < e->outputs; k++)
        out[k] = lobe_value_real(e->format, raw[k]);
}

static double albedo(const lobe_entry *e, double roughness, double n_dot_v)
{
    double out[LOBE_MAX_OUTPUTS];
    double sum = 0.0;
    int k;
    evaluate(e, roughness, n_dot_v, out);
    for (k = 0; k < e->outputs; k++)
        sum += out[k];
    return sum;
}

/* At roughness 1 and normal incidence both Smith forms give the integral of u / (1 + u) over [0, 1]. */
static void rough_and_normal(void **state)
{
    size_t i;
    (void)state;
    for (i = 0; i < lobe_entry_count; i++) {
        const lobe_entry *e = &lobe_entries[i];
        const double got = albedo(e, 1.0, 1.0), want = 1.0 - log(2.0);
        if (is_ggx(e) && !(fabs(got - want) <= e->max))
            fail_msg("%s: E(1, 1) = %.9g, not %.9g within %g", e->kernel, got, want, e->max);
    }
}

/* As alpha goes to 0 the lobe becomes a mirror: E = 1 and bias = (1 - v)^5. */
static void mirror(void **state)
{
    size_t i;
    int b;
    (void)state;
    for (i = 0; i < lobe_entry_count; i++) {
        const lobe_entry *e = &lobe_entries[i];
        for (b = 1; is_ggx(e) && b <= 64; b++) {
            const double v = b / 64.0, roughness = 1.0 / 512;
            double out[LOBE_MAX_OUTPUTS];
            if (!(fabs(albedo(e, roughness, v) - 1.0) <= e->below_max + 1e-3))
                fail_msg("%s: E(%g, %g) = %.9g, not 1 within %g", e->kernel, roughness, v, albedo(e, roughness, v),
                         e->below_max);
            evaluate(e, roughness, v, out);
            if (e->sums && !(fabs(out[1] - pow(1.0 - v, 5.0)) <= e->below_max + 1e-3))
                fail_msg("%s: bias(%g, %g) = %.9g, not %.9g within %g", e->kernel, roughness, v, out[1],
                         pow(1.0 - v, 5.0), e->below_max);
        }
    }
}

/* From n_dot_v = .05 on the true bias falls for every roughness, so a model may rise by two errors at most. (Below it
 * there is a dip: at roughness .0886 the truth is .790 at .01 and .8075 at .022.) */
static void bias_falls_with_the_view(void **state)
{
    size_t i;
    int a, b;
    (void)state;
    for (i = 0; i < lobe_entry_count; i++) {
        const lobe_entry *e = &lobe_entries[i];
        for (a = 1; e->sums && a <= 100; a++) {
            double least = 2.0;
            for (b = 0; b <= 1000; b++) {
                const double lo = e->ranges[0].lo, r = lo + (1.0 - lo) * a / 100.0;
                const double v = fmin(1.0, 0.05 + 0.95 * b / 1000.0);
                double out[LOBE_MAX_OUTPUTS];
                evaluate(e, r, v, out);
                if (!(out[1] <= least + 2.0 * e->max))
                    fail_msg("%s: bias rises from %.9g to %.9g at %g %g", e->kernel, least, out[1], r, v);
                least = fmin(least, out[1]);
            }
        }
    }
}

/* Moves input k across an end of its domain, the others being at parts of theirs that differ. */
static void cross(const lobe_entry *e, int k, double edge, int b)
{
    const double step = 0x1p-20;
    lobe_value in[LOBE_MAX_INPUTS], below[LOBE_MAX_OUTPUTS], above[LOBE_MAX_OUTPUTS];
    int i;
    for (i = 0; i < e->inputs; i++) {
        const lobe_range *r = &e->ranges[i];
        const double part = ((b * (i < 2 ? 1 : 2 * i + 1)) % 512 + 1) / 512.0;
        in[i] = lobe_value_nearest(e->format, r->least + (r->most - r->least) * part);
    }
    in[k] = lobe_value_nearest(e->format, edge - step);
    e->call(in, below);
    in[k] = lobe_value_nearest(e->format, edge + step);
    e->call(in, above);
    for (i = 0; i < e->outputs; i++) {
        const double from = lobe_value_real(e->format, below[i]), to = lobe_value_real(e->format, above[i]);
        if (!(fabs(from - to) <= 0x1p-10 * fmax(1.0, fabs(from))))
            fail_msg("%s: output %d jumps from %.9g to %.9g across %g of input %d, place %d", e->kernel, i, from, to,
                     edge, k, b);
    }
}

/* Nothing jumps where the domain of the fit ends: across 2^-20 no output moves by more than 2^-10, of itself where it
 * is more than 1. */
static void no_jump_at_the_edge(void **state)
{
    size_t i;
    int b, k;
    (void)state;
    for (i = 0; i < lobe_entry_count; i++) {
        const lobe_entry *e = &lobe_entries[i];
        for (k = 0; k < e->inputs; k++) {
            for (b = 0; b < 512; b++) {
                if (e->inputs == 2 || e->ranges[k].lo > e->ranges[k].least)
                    cross(e, k, e->ranges[k].lo, b);
                if (e->ranges[k].hi < e->ranges[k].most)
                    cross(e, k, e->ranges[k].hi, b);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rough_and_normal),
        cmocka_unit_test(mirror),
        cmocka_unit_test(bias_falls_with_the_view),
        cmocka_unit_test(no_jump_at_the_edge),
    };
    return cmocka_run_group_tests_name("limits", tests, NULL, NULL);
}
