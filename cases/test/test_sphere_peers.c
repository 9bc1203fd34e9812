/* The published forms of a sphere light: that they are what their sources say, in two spellings; and the arithmetic of
 * linearly transformed cosines against eigenvectors and quadrature. */
#define LOBE_DOUBLE 1
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include "../fit/random.h"
#include "../sphere_light/ltc.h"
#include "../sphere_light/peers.h"
#include "../sphere_light/peers_fitted.h"
#include "../sphere_light/peers_ltc.h"
#include "../sphere_light/peers_vector.h"
#include "../sphere_light/row.h"
#include "../sphere_light/truth_sphere.h"

static const double pi = 3.14159265358979323846;

/* Within the domain of the cells, half of them near the mirror direction. */
static void draw(lobe_random *r, double row[5])
{
    const double near = lobe_random_unit(r) < .5 ? .2 : 1;
    row[0] = .22 + .78 * lobe_random_unit(r);
    row[1] = .08 + .91 * lobe_random_unit(r);
    row[4] = .01 + .77 * lobe_random_unit(r);
    row[2] = fmin(.99, fmax(-sin(row[4]), row[1] + near * (2 * lobe_random_unit(r) - 1)));
    row[3] = pi - near * pi * lobe_random_unit(r);
}

static void vectors_of(const double row[5], double v[3], double l[3])
{
    const double sv = sqrt(1 - row[1] * row[1]), sl = sqrt(1 - row[2] * row[2]);
    v[0] = sv;
    v[1] = 0;
    v[2] = row[1];
    l[0] = sl * cos(row[3]);
    l[1] = sl * sin(row[3]);
    l[2] = row[2];
}

static lobe_peer_scene scene_of(const double row[5])
{
    double v[3], l[3];
    lobe_peer_scene s;
    vectors_of(row, v, l);
    s.normal = lobe_vec3_of(0, 0, 1);
    s.view = lobe_vec3_of(v[0], v[1], v[2]);
    s.light = lobe_vec3_of(l[0], l[1], l[2]);
    s.sine = sin(row[4]);
    s.versine = 2 * sin(.5 * row[4]) * sin(.5 * row[4]);
    return s;
}

/* Karis's listing: L to the sphere's centre at distance d, R its radius, r the mirror ray. */
static double karis_as_printed(const double row[5], double distance, double divisor)
{
    const double a = row[0] * row[0], radius = distance * sin(row[4]),
                 wide = fmin(1, a + radius / (divisor * distance));
    double v[3], l[3], r[3], c[3], along = 0, out = 0, length = 0, light;
    int k;
    vectors_of(row, v, l);
    r[0] = -v[0];
    r[1] = -v[1];
    r[2] = v[2];
    for (k = 0; k < 3; k++) {
        l[k] *= distance;
        along += l[k] * r[k];
    }
    for (k = 0; k < 3; k++) {
        c[k] = along * r[k] - l[k];
        out += c[k] * c[k];
    }
    for (k = 0; k < 3; k++) {
        l[k] += c[k] * fmin(1, radius / sqrt(out));
        length += l[k] * l[k];
    }
    for (k = 0; k < 3; k++)
        l[k] /= sqrt(length);
    if (l[2] <= 0)
        return 0;
    light = 2 * pi * (1 - cos(row[4]));
    return light * lobe_truth_sphere_brdf(a, v, l, 1) * (a / wide) * (a / wide);
}

static void karis_is_as_printed(void **state)
{
    lobe_random r;
    double worst = 0, worst_vector = 0;
    int i, lit = 0;
    (void)state;
    lobe_random_seed(&r, 71, 0);
    for (i = 0; i < 20000; i++) {
        const double divisor = i % 2 ? 2 : 3;
        double row[5], want;
        draw(&r, row);
        want = karis_as_printed(row, 1 + i % 7, divisor);
        if (want <= 1e-6)
            continue;
        lit++;
        worst = fmax(worst, fabs(lobe_peer_karis(row[0], lobe_sphere_of_row(row), 1 / divisor) / want - 1));
        worst_vector = fmax(worst_vector, fabs(lobe_peer_karis_vector(row[0], scene_of(row), 1 / divisor) / want - 1));
    }
    print_message("# %d lights, from heights within %.1e, from vectors within %.1e\n", lit, worst, worst_vector);
    assert_true(lit > 10000);
    assert_true(worst <= 1e-7 && worst_vector <= 1e-7);
}

static void spellings_agree(void **state)
{
    lobe_random r;
    double worst = 0;
    int i;
    (void)state;
    lobe_random_seed(&r, 72, 0);
    for (i = 0; i < 20000; i++) {
        double row[5], a, b;
        draw(&r, row);
        a = lobe_peer_smooth_point(row[0], lobe_sphere_of_row(row), LOBE_PEER_SMOOTH_POINT);
        b = lobe_peer_smooth_point_vector(row[0], scene_of(row), LOBE_PEER_SMOOTH_POINT);
        worst = fmax(worst, fabs(a - b) / (a + 1e-6));
        a = lobe_peer_capped_point(row[0], lobe_sphere_of_row(row), LOBE_PEER_CAPPED_POINT);
        b = lobe_peer_capped_point_vector(row[0], scene_of(row), LOBE_PEER_CAPPED_POINT);
        worst = fmax(worst, fabs(a - b) / (a + 1e-6));
    }
    print_message("# within %.1e\n", worst);
    assert_true(worst <= 1e-7);
}

/* The soft minima, in the form that their sources print. */
static void soft_minima(void **state)
{
    const double row[5] = {.5, .7, .6, 2.5, .3};
    const lobe_sphere s = lobe_sphere_of_row(row);
    const double lit = lobe_peer_wider(row[0], s, .5);
    double x;
    (void)state;
    for (x = .05; x < 20; x *= 1.3)
        assert_true(fabs(lobe_peer_smooth_part(x) / pow(pow(x, -3) + 1, -1. / 3) - 1) <= 1e-7);
    for (x = .1 * lit; x < 10 * lit; x *= 1.3)
        assert_true(fabs(lobe_peer_wider_capped(row[0], s, .5, x) / pow(pow(lit, -10) + pow(x, -10), -.1) - 1) <= 1e-7);
}

/* The short arithmetic that is counted, against Jacobi's eigenvectors: one Newton step leaves a little. */
static void ltc_arithmetic(void **state)
{
    lobe_random r;
    double length = 0, height = 0, square = 0;
    int i;
    (void)state;
    lobe_random_seed(&r, 73, 0);
    for (i = 0; i < 20000; i++) {
        double row[5], c[LOBE_LTC_VALUES];
        lobe_peer_ltc_cell cell;
        lobe_peer_ltc_factor got;
        lobe_ltc_factor want;
        draw(&r, row);
        lobe_ltc_at(row[0], row[1], c);
        cell.inv11 = c[LOBE_LTC_INV11];
        cell.inv13 = c[LOBE_LTC_INV13];
        cell.inv31 = c[LOBE_LTC_INV31];
        cell.inv33 = c[LOBE_LTC_INV33];
        cell.albedo = c[LOBE_LTC_ALBEDO];
        got = lobe_peer_ltc_factor_of(cell, lobe_sphere_of_row(row));
        want = lobe_ltc_factor_of(c, row);
        square += (got.length / want.length - 1) * (got.length / want.length - 1);
        length = fmax(length, fabs(got.length / want.length - 1));
        height = fmax(height, fabs(got.height - want.height));
    }
    print_message("# length within %.1e, rms %.1e, height within %.1e\n", length, sqrt(square / i), height);
    assert_true(length <= .3 && height <= .1 && sqrt(square / i) <= .03);
}

/* The lobe itself over the light, by midpoints: what the clipped form factor stands for. */
static double by_midpoints(const double c[LOBE_LTC_VALUES], const double row[5])
{
    enum { RINGS = 400, TURNS = 200 };
    const double sl = sqrt(1 - row[2] * row[2]), det = fabs(c[0] * c[3] - c[1] * c[2]);
    const double half = sin(.5 * row[4]), ring = 2 * half * half / RINGS;
    double sum = 0;
    int i, j;
    for (i = 0; i < RINGS; i++) {
        const double up = 1 - ring * (i + .5), out = sqrt(1 - up * up);
        for (j = 0; j < 2 * TURNS; j++) {
            const double turn = pi * (j + .5) / TURNS, x = out * cos(turn), y = out * sin(turn);
            const double along = up * sl + x * row[2], z = up * row[2] - x * sl;
            const double lx = along * cos(row[3]) - y * sin(row[3]), ly = along * sin(row[3]) + y * cos(row[3]);
            const double u = c[0] * lx + c[1] * z, w = c[2] * lx + c[3] * z, n = u * u + ly * ly + w * w;
            sum += w > 0 ? det * w / (pi * n * n) : 0;
        }
    }
    return c[LOBE_LTC_ALBEDO] * sum * ring * pi / TURNS;
}

static void ltc_clip_is_exact(void **state)
{
    lobe_random r;
    double worst = 0, round = 0;
    int i;
    (void)state;
    lobe_random_seed(&r, 74, 0);
    for (i = 0; i < 60; i++) {
        double row[5], c[LOBE_LTC_VALUES], want;
        draw(&r, row);
        row[0] = fmax(row[0], .5); /* narrow lobes fall between the midpoints */
        lobe_ltc_at(row[0], row[1], c);
        want = by_midpoints(c, row);
        worst = fmax(worst, fabs(lobe_ltc_clipped_ellipse(c, row) - want) / (want + 1e-4));
        round = fmax(round, fabs(lobe_ltc_clipped_sphere(c, row) - want) / (want + 1e-4));
    }
    print_message("# clipped ellipse within %.1e, clipped round cone within %.1e\n", worst, round);
    assert_true(worst <= 3e-3 && round > 10 * worst);
}

/* The whole sky is the albedo: no light is lost between table and form factor. */
static void ltc_of_the_sky(void **state)
{
    double v;
    (void)state;
    for (v = .2; v <= 1; v += .2) {
        const double row[5] = {.3, v, 1, 0, .999999 * pi / 2};
        double c[LOBE_LTC_VALUES];
        lobe_ltc_at(row[0], row[1], c);
        assert_true(fabs(lobe_ltc_clipped_ellipse(c, row) / c[LOBE_LTC_ALBEDO] - 1) <= .02);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(karis_is_as_printed), cmocka_unit_test(spellings_agree),   cmocka_unit_test(soft_minima),
        cmocka_unit_test(ltc_arithmetic),      cmocka_unit_test(ltc_clip_is_exact), cmocka_unit_test(ltc_of_the_sky),
    };
    return cmocka_run_group_tests_name("sphere light peers", tests, NULL, NULL);
}
