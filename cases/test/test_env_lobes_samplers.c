/* Importance samplers of environment lobes: every density integrates to 1, and what is drawn is distributed by it
 * (chi-square over boxes of the sphere, whose expectations are integrals of the density). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <math.h>
#include <string.h>
#include "../env_lobes/cubature.h"
#include "../env_lobes/gauss.h"
#include "../env_lobes/kernels.h"
#include "../env_lobes/response.h"
#include "../env_lobes/samplers.h"
#include "../env_lobes/visible_normals.h"
#include "../fit/random.h"

enum { SG, ASG, TAP, VISIBLE, KINDS };
static const double pi = 3.14159265358979323846;
static const double first[KINDS][3] = {{.5, 8, 200}, {3, 20, 200}, {.1, .5, 3}, {.1, .4, 1}};
static const double second[KINDS][3] = {{0, 0, 0}, {3, 2, 900}, {0, 0, 0}, {.9, .2, .5}};

typedef struct law {
    int kind;
    double a, b;
} law;

static double density(void *ctx, const double d[3])
{
    const law *w = ctx;
    switch (w->kind) {
    case SG:
        return lobe_sample_sg_density(w->a, d[2]);
    case ASG:
        return lobe_sample_asg_density(w->a, w->b, d);
    case TAP:
        return lobe_sample_tap_density(w->a, d[2]);
    default:
        return lobe_visible_light_density(w->a, w->b, d);
    }
}

static void draw(const law *w, lobe_random *r, double d[3])
{
    const double x = lobe_random_unit(r), y = lobe_random_unit(r);
    switch (w->kind) {
    case SG:
        lobe_sample_sg(w->a, x, y, d);
        break;
    case ASG:
        lobe_sample_asg(w->a, w->b, x, y, d);
        break;
    case TAP:
        lobe_sample_tap(w->a, x, y, d);
        break;
    default:
        lobe_visible_light(w->a, w->b, x, y, d);
    }
}

static void densities_integrate_to_one(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; k++)
        for (int i = 0; i < 3; i++) {
            law w = {k, first[k][i], second[k][i]};
            assert_true(fabs(lobe_cubature(density, &w, 1e-4) - 1) <= 1e-4);
        }
}

enum { BOXES = 64, NODES = 12, DRAWS = 200000, LINES = BOXES * BOXES };

/* Expected parts of boxes in cos(polar angle) and azimuth; both halves of the sphere in y are one. */
static void expect(law *w, double *part)
{
    double node[NODES], weight[NODES];
    lobe_gauss(NODES, node, weight);
    for (int i = 0; i < LINES; i++) {
        part[i] = 0;
        for (int k = 0; k < NODES * NODES; k++) {
            const double z = 2 * (i / BOXES + node[k / NODES]) / BOXES - 1, sine = sqrt(1 - z * z);
            const double turn = pi * (i % BOXES + node[k % NODES]) / BOXES;
            const double d[3] = {sine * cos(turn), sine * sin(turn), z};
            part[i] += weight[k / NODES] * weight[k % NODES] * density(w, d) * 4 * pi / LINES;
        }
    }
}

/* Boxes of fewer than 8 expected are one. 5 standard deviations: chance 3e-7 a case. */
static void draws_follow_their_density(void **state)
{
    static double part[LINES], count[LINES];
    (void)state;
    for (int k = 0; k < KINDS; k++)
        for (int i = 0; i < 3; i++) {
            law w = {k, first[k][i], second[k][i]};
            double sum = 0, rest = DRAWS, rest_count = DRAWS, freedom = 0;
            lobe_random r;
            lobe_random_seed(&r, 21, (uint64_t)(3 * k + i));
            memset(count, 0, sizeof count);
            for (int n = 0; n < DRAWS; n++) {
                double d[3];
                int line, column;
                draw(&w, &r, d);
                assert_true(fabs(d[0] * d[0] + d[1] * d[1] + d[2] * d[2] - 1) <= 1e-9);
                line = (int)fmin(BOXES - 1, 0.5 * (d[2] + 1) * BOXES);
                column = (int)fmin(BOXES - 1, fabs(atan2(d[1], d[0])) / pi * BOXES);
                count[line * BOXES + column]++;
            }
            expect(&w, part);
            for (int n = 0; n < LINES; n++) {
                const double want = part[n] * DRAWS;
                if (want < 8)
                    continue;
                sum += (count[n] - want) * (count[n] - want) / want;
                rest -= want;
                rest_count -= count[n];
                freedom++;
            }
            if (rest >= 8)
                sum += (rest_count - rest) * (rest_count - rest) / rest;
            print_message("# kind %d, %g %g: chi-square %.0f of %.0f\n", k, w.a, w.b, sum, freedom);
            assert_true(freedom >= 5 && sum <= freedom + 5 * sqrt(2 * freedom));
        }
}

/* The response is the visible normals' density times what is not shadowed. */
static void response_is_sampled(void **state)
{
    lobe_random r;
    (void)state;
    lobe_random_seed(&r, 22, 0);
    for (int i = 0; i < 10000; i++) {
        const double alpha = .01 + .99 * lobe_random_unit(&r), v = .01 + .99 * lobe_random_unit(&r);
        double d[3], want;
        lobe_visible_light(alpha, v, lobe_random_unit(&r), lobe_random_unit(&r), d);
        want = lobe_response(alpha, v, d);
        if (d[2] > 1e-6)
            assert_true(fabs(lobe_visible_light_density(alpha, v, d) * lobe_response_shadowing(alpha, v, d[2]) / want -
                             1) <= 1e-6);
        else if (d[2] <= 0)
            assert_true(want == 0);
    }
}

static void kernels_integrate_to_one(void **state)
{
    (void)state;
    for (double t = .003; t < 60; t *= 1.7) {
        double band[4];
        lobe_prefilter_bands(t, 4, band);
        assert_true(fabs(band[0] - 1) <= 1e-9 && band[1] > 0 && band[1] < 1 && band[3] < band[2]);
    }
    /* k = 0 is a clamped cosine: 2/3, 1/4, 0 */
    {
        double band[4];
        lobe_prefilter_bands(1e4, 4, band);
        assert_true(fabs(band[1] - 2. / 3) <= 1e-7 && fabs(band[2] - .25) <= 1e-7 && fabs(band[3]) <= 1e-7);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(densities_integrate_to_one),
        cmocka_unit_test(draws_follow_their_density),
        cmocka_unit_test(response_is_sampled),
        cmocka_unit_test(kernels_integrate_to_one),
    };
    return cmocka_run_group_tests_name("environment lobes, samplers", tests, NULL, NULL);
}
