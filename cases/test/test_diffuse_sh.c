/* The truth of diffuse_sh: two integrators agree, the closed form is what they give, and so it is turned into world
 * space. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <math.h>
#include "../diffuse_sh/closed_form.h"
#include "../diffuse_sh/truth_diffuse.h"

static double distance(const double a[9], const double b[9])
{
    double most = 0;
    int k;
    for (k = 0; k < 9; k++)
        most = fmax(most, fabs(a[k] - b[k]));
    return most;
}

/* 289 points with the edges, where Burley's half vector is used as written. */
static void closed_form_is_the_integral(void **state)
{
    double about_z = 0, about_y = 0, between = 0;
    int i, j;
    (void)state;
    for (i = 0; i <= 16; i++)
        for (j = 0; j <= 16; j++) {
            double z[9], y[9], c[9];
            lobe_diffuse_adaptive(lobe_diffuse_about_z, lobe_burley_2012, i / 16.0, j / 16.0, z);
            lobe_diffuse_adaptive(lobe_diffuse_about_y, lobe_burley_2012, i / 16.0, j / 16.0, y);
            lobe_diffuse_closed_form(i / 16.0, j / 16.0, c);
            about_z = fmax(about_z, distance(c, z));
            about_y = fmax(about_y, distance(c, y));
            between = fmax(between, distance(z, y));
        }
    print_message("# closed form to quadrature: %.1e about the normal, %.1e about the bitangent; between them %.1e\n",
                  about_z, about_y, between);
    assert_true(about_z <= 1e-12 && about_y <= 1e-12 && between <= 2e-14);
}

/* By hand: at roughness .5 and v = 1, where L.V = l, the lobe is l / pi (1 + l / 2 (1 - l)^5). It reflects
 * 2 int l (1 + l / 2 (1 - l)^5) dl = 1 + 1 / 168 of a white environment, which is sqrt(4 pi) c0. */
static void one_point_by_hand(void **state)
{
    const double pi = 3.14159265358979323846;
    double c[9];
    (void)state;
    lobe_diffuse_closed_form(0.5, 1.0, c);
    assert_true(fabs(c[0] * sqrt(4 * pi) - (1 + 1.0 / 168)) <= 1e-15);
    lobe_truth_diffuse_rows((const double[2]){0.5, 1.0}, c, 1);
    assert_true(fabs(c[0] * sqrt(4 * pi) - (1 + 1.0 / 168)) <= 1e-14);
}

/* An integrator that misses its order is noticed: 4 nodes are not enough for the ninth power of n.L. */
static void order_matters(void **state)
{
    double few[9], c[9];
    (void)state;
    lobe_diffuse_about_z(lobe_burley_2012, 1.0, 0.0, 4, few);
    lobe_diffuse_closed_form(1.0, 0.0, c);
    assert_true(distance(few, c) > 1e-8);
}

static double lambert(double n_dot_l, double n_dot_v, double l_dot_v, double roughness)
{
    (void)n_dot_l;
    (void)n_dot_v;
    (void)l_dot_v;
    (void)roughness;
    return 1 / 3.14159265358979323846;
}

/* sqrt(1 / 4 pi), sqrt(1 / 3 pi), sqrt(5 / 64 pi): a clamped cosine (Ramamoorthi and Hanrahan 2001). */
static void lambert_is_lambert(void **state)
{
    const double pi = 3.14159265358979323846;
    const double want[9] = {sqrt(1 / (4 * pi)), 0, sqrt(1 / (3 * pi)), 0, 0, 0, sqrt(5 / (64 * pi)), 0, 0};
    double z[9], y[9];
    (void)state;
    lobe_diffuse_about_z(lambert, 0.3, 0.4, 24, z);
    lobe_diffuse_about_y(lambert, 0.3, 0.4, 24, y);
    assert_true(distance(z, want) <= 1e-14 && distance(y, want) <= 1e-14);
}

/* The turned coefficients against the lobe in its frame, as functions of the direction of light. */
static void turned_is_the_same_lobe(void **state)
{
    int i, k;
    (void)state;
    for (i = 0; i < 400; i++) {
        const double a = 0.37 * i, b = 1.3 * i + 0.2, v = (i % 41) / 40.0, s = sqrt(1 - v * v), u = 0.71 * i;
        const double n[3] = {sin(a) * cos(b), sin(a) * sin(b), cos(a)};
        const double e[3] = {cos(a) * cos(b), cos(a) * sin(b), -sin(a)}, f[3] = {-sin(b), cos(b), 0};
        double t[3], side[3], view[3], light[3], local[9], world[9], in_frame[9], in_world[9], got = 0, want = 0;
        const double x = sin(0.9 * i) * cos(2.1 * i), y = sin(0.9 * i) * sin(2.1 * i), z = cos(0.9 * i);
        for (k = 0; k < 3; k++) {
            t[k] = cos(u) * e[k] + sin(u) * f[k];
            side[k] = -sin(u) * e[k] + cos(u) * f[k];
            view[k] = v * n[k] + s * t[k];
            light[k] = x * t[k] + y * side[k] + z * n[k];
        }
        lobe_diffuse_closed_form((i % 7) / 6.0, v, local);
        lobe_diffuse_closed_form_turned((i % 7) / 6.0, n, view, world);
        lobe_truth_basis(in_frame, x, y, z);
        lobe_truth_basis(in_world, light[0], light[1], light[2]);
        for (k = 0; k < 9; k++) {
            want += local[k] * in_frame[k];
            got += world[k] * in_world[k];
        }
        assert_true(fabs(got - want) <= 1e-14);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closed_form_is_the_integral),
        cmocka_unit_test(one_point_by_hand),
        cmocka_unit_test(order_matters),
        cmocka_unit_test(lambert_is_lambert),
        cmocka_unit_test(turned_is_the_same_lobe),
    };
    return cmocka_run_group_tests_name("diffuse_sh truth", tests, NULL, NULL);
}
