/* Radiance in world space against the local coefficients, in double, in a frame that is built here: at random
 * directions, at the points where a frame has no sense, and at every bad number. */
#define LOBE_DOUBLE 1
#include "../../models/diffuse_sh.h"
#include "../../models/lobe.h"
#include "cmocka_first.h"
#include <float.h>
#include <math.h>
#include <string.h>

typedef lobe_sh9 formula(double roughness, double n_dot_v);
typedef lobe_vec3_f32 radiance_f32(float, lobe_vec3_f32, lobe_vec3_f32, const lobe_lighting_f32 *);
typedef lobe_vec3_q16 radiance_q30(int32_t, lobe_vec3_q30, lobe_vec3_q30, const lobe_lighting_q16 *);

static const struct tier {
    formula *in_double;
    radiance_f32 *f32;
    radiance_q30 *q30;
} tiers[] = {
    {lobe_diffuse_sh_exact, lobe_diffuse_sh_radiance_exact_f32, lobe_diffuse_sh_radiance_exact_q30},
    {lobe_diffuse_sh_medium, lobe_diffuse_sh_radiance_medium_f32, lobe_diffuse_sh_radiance_medium_q30},
    {lobe_diffuse_sh_low, lobe_diffuse_sh_radiance_low_f32, lobe_diffuse_sh_radiance_low_q30},
};
enum { TIERS = sizeof tiers / sizeof tiers[0] };

static uint64_t random_state = 88172645463325252u;
static double uniform(void)
{
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return (double)(random_state >> 11) / 9007199254740992.0;
}

static void random_direction(double d[3])
{
    const double z = 2.0 * uniform() - 1.0, phi = 6.283185307179586 * uniform(), s = sqrt(1.0 - z * z);
    d[0] = s * cos(phi);
    d[1] = s * sin(phi);
    d[2] = z;
}

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* The basis as the interface prints it. */
static void basis(const double d[3], double b[9])
{
    const double x = d[0], y = d[1], z = d[2];
    const double all[9] = {0.28209479177387814,
                           0.4886025119029199 * y,
                           0.4886025119029199 * z,
                           0.4886025119029199 * x,
                           1.0925484305920792 * x * y,
                           1.0925484305920792 * y * z,
                           0.31539156525252005 * (3.0 * z * z - 1.0),
                           1.0925484305920792 * x * z,
                           0.5462742152960396 * (x * x - y * y)};
    memcpy(b, all, sizeof all);
}

/* The lobe in the direction light, which is what lighting with the basis there as coefficients gives. */
static double lobe_at(formula *f, double roughness, const double n[3], const double view[3], const double light[3])
{
    const double v = fmin(1.0, fmax(0.0, dot(n, view)));
    const lobe_sh9 c = f(roughness, v);
    double t[3], b[3], in_frame[3], y[9], length;
    int k;
    for (k = 0; k < 3; k++)
        t[k] = view[k] - v * n[k];
    length = sqrt(dot(t, t));
    if (length < 1e-6) { /* any tangent: nothing depends on it there */
        t[0] = fabs(n[0]) < 0.7 ? 1.0 - n[0] * n[0] : -n[0] * n[1];
        t[1] = fabs(n[0]) < 0.7 ? -n[0] * n[1] : 1.0 - n[1] * n[1];
        t[2] = fabs(n[0]) < 0.7 ? -n[0] * n[2] : -n[1] * n[2];
        length = sqrt(dot(t, t));
    }
    for (k = 0; k < 3; k++)
        t[k] /= length;
    b[0] = n[1] * t[2] - n[2] * t[1];
    b[1] = n[2] * t[0] - n[0] * t[2];
    b[2] = n[0] * t[1] - n[1] * t[0];
    in_frame[0] = dot(light, t);
    in_frame[1] = dot(light, b);
    in_frame[2] = dot(light, n);
    basis(in_frame, y);
    return c.c0 * y[0] + c.c1 * y[1] + c.c2 * y[2] + c.c3 * y[3] + c.c4 * y[4] + c.c5 * y[5] + c.c6 * y[6] +
           c.c7 * y[7] + c.c8 * y[8];
}

static lobe_vec3_f32 vec_f32(const double d[3])
{
    const lobe_vec3_f32 v = {(float)d[0], (float)d[1], (float)d[2]};
    return v;
}

static int32_t q30(double x) { return (int32_t)floor(x * 0x1p30 + 0.5); }

static lobe_vec3_q30 vec_q30(const double d[3])
{
    const lobe_vec3_q30 v = {q30(d[0]), q30(d[1]), q30(d[2])};
    return v;
}

/* Three lights of one direction each, on a white floor of 20 that keeps every sum above 0. */
static void check(const struct tier *t, double roughness, const double n[3], const double view[3])
{
    double light[3][3], y[9], want[3];
    lobe_lighting_f32 lighting;
    lobe_lighting_q16 fixed;
    lobe_sh9_f32 *const channel[3] = {&lighting.red, &lighting.green, &lighting.blue};
    lobe_sh9_q16 *const fixed_channel[3] = {&fixed.red, &fixed.green, &fixed.blue};
    const double v = fmin(1.0, fmax(0.0, dot(n, view)));
    int k, i;
    for (k = 0; k < 3; k++) {
        random_direction(light[k]);
        basis(light[k], y);
        y[0] += 20.0;
        for (i = 0; i < 9; i++) {
            channel[k]->c[i] = (float)y[i];
            fixed_channel[k]->c[i] = (int32_t)floor(y[i] * 65536.0 + 0.5);
        }
        want[k] = lobe_at(t->in_double, roughness, n, view, light[k]) + 20.0 * t->in_double(roughness, v).c0;
    }
    const lobe_vec3_f32 got = t->f32((float)roughness, vec_f32(n), vec_f32(view), &lighting);
    const lobe_vec3_q16 got_fixed = t->q30(q30(roughness), vec_q30(n), vec_q30(view), &fixed);
    const double g[3] = {(double)got.x, (double)got.y, (double)got.z};
    const int32_t q[3] = {got_fixed.x, got_fixed.y, got_fixed.z};
    for (k = 0; k < 3; k++) {
        if (!(fabs(g[k] - want[k]) <= 2e-5))
            fail_msg("f32 tier %d: %.9g, not %.9g at roughness %g n.v %g", (int)(t - tiers), g[k], want[k], roughness,
                     v);
        /* 9 products and the 9 roundings of the lighting, half a unit each */
        if (!(fabs(q[k] / 65536.0 - want[k]) <= 9.5 / 65536.0))
            fail_msg("q30 tier %d: %.9g, not %.9g at roughness %g n.v %g", (int)(t - tiers), q[k] / 65536.0, want[k],
                     roughness, v);
    }
}

static void as_the_local_coefficients(void **state)
{
    int i, k;
    size_t t;
    (void)state;
    for (i = 0; i < 20000; i++) {
        double n[3], view[3];
        const double roughness = i % 7 == 0 ? 0.0 : i % 7 == 1 ? 1.0 : uniform();
        random_direction(n);
        random_direction(view);
        if (dot(n, view) < 0.0)
            for (k = 0; k < 3; k++)
                view[k] = -view[k];
        if (i % 10 == 0)
            memcpy(view, n, sizeof n);
        for (t = 0; t < TIERS; t++)
            check(&tiers[t], roughness, n, view);
    }
}

/* Around view = normal nothing jumps: steps of 2^-12 in any direction move the radiance by as little. */
static void continuous_where_view_is_normal(void **state)
{
    size_t t;
    int i, k;
    (void)state;
    for (i = 0; i < 2000; i++) {
        double n[3], side[3], view[3], length;
        lobe_lighting_f32 lighting;
        lobe_vec3_f32 at, near;
        random_direction(n);
        random_direction(side);
        for (k = 0; k < 3; k++)
            view[k] = n[k] + 0x1p-12 * side[k];
        length = sqrt(dot(view, view));
        for (k = 0; k < 3; k++)
            view[k] /= length;
        for (k = 0; k < 9; k++)
            lighting.red.c[k] = lighting.green.c[k] = lighting.blue.c[k] = k ? (float)(2.0 * uniform() - 1.0) : 9.0f;
        for (t = 0; t < TIERS; t++) {
            at = tiers[t].f32(1.0f, vec_f32(n), vec_f32(n), &lighting);
            near = tiers[t].f32(1.0f, vec_f32(n), vec_f32(view), &lighting);
            assert_true(fabsf(at.x - near.x) <= 0x1p-10f);
        }
    }
}

static const float bad[] = {0.0f, -0.0f, 1.0f, -1.0f, 1e-45f, 2.0f, 3.4e38f, -3.4e38f, INFINITY, -INFINITY, NAN};
enum { BAD = sizeof bad / sizeof bad[0] };

static float pick_f32(void) { return bad[(int)(uniform() * BAD)]; }

static int32_t pick_q30(void)
{
    static const int32_t ends[] = {INT32_MIN, INT32_MIN + 1, -(1 << 30), -1, 0, 1, 1 << 30, INT32_MAX - 1, INT32_MAX};
    return ends[(int)(uniform() * (double)(sizeof ends / sizeof ends[0]))];
}

static void bad_numbers(void **state)
{
    size_t t;
    int i, k;
    (void)state;
    for (i = 0; i < 100000; i++) {
        lobe_lighting_f32 lighting;
        lobe_lighting_q16 fixed;
        const lobe_vec3_f32 n = {pick_f32(), pick_f32(), pick_f32()}, view = {pick_f32(), pick_f32(), pick_f32()};
        const lobe_vec3_q30 nq = {pick_q30(), pick_q30(), pick_q30()}, vq = {pick_q30(), pick_q30(), pick_q30()};
        for (k = 0; k < 9; k++) {
            lighting.red.c[k] = pick_f32();
            lighting.green.c[k] = i & 1 ? 1.0f : pick_f32();
            lighting.blue.c[k] = i & 2 ? 3.4e38f : pick_f32();
            fixed.red.c[k] = pick_q30();
            fixed.green.c[k] = i & 1 ? 65536 : pick_q30();
            fixed.blue.c[k] = i & 2 ? INT32_MAX : pick_q30();
        }
        for (t = 0; t < TIERS; t++) {
            const lobe_vec3_f32 got = tiers[t].f32(pick_f32(), n, view, &lighting);
            const lobe_vec3_q16 q = tiers[t].q30(pick_q30(), nq, vq, &fixed);
            assert_true(got.x >= 0.0f && got.x <= FLT_MAX && got.y >= 0.0f && got.y <= FLT_MAX && got.z >= 0.0f &&
                        got.z <= FLT_MAX);
            assert_true(q.x >= 0 && q.y >= 0 && q.z >= 0);
        }
    }
}

/* Lighting that a float or Q16.16 cannot answer with its own range is held at its end. */
static void held_at_the_end(void **state)
{
    lobe_lighting_q16 fixed;
    const lobe_vec3_q30 up = {0, 0, LOBE_ONE_Q30};
    int k;
    (void)state;
    memset(&fixed, 0, sizeof fixed);
    for (k = 0; k < 9; k++) {
        fixed.red.c[k] = INT32_MAX;
        fixed.green.c[k] = INT32_MIN;
    }
    for (k = 0; k < TIERS; k++) {
        const lobe_vec3_q16 rgb = tiers[k].q30(LOBE_ONE_Q30 / 2, up, up, &fixed);
        assert_true(rgb.x > INT32_MAX / 2 && rgb.y == 0 && rgb.z == 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(as_the_local_coefficients),
        cmocka_unit_test(continuous_where_view_is_normal),
        cmocka_unit_test(bad_numbers),
        cmocka_unit_test(held_at_the_end),
    };
    return cmocka_run_group_tests_name("diffuse_sh_radiance", tests, NULL, NULL);
}
