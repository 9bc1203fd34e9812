/* From directions to the numbers of a sphere light, against trigonometry in double at the same floats; and where there
 * is nothing to see: inside the sphere, no direction, bad numbers. */
#include "../../models/lobe.h"
#include "cmocka_first.h"
#include <math.h>
#include <string.h>

static uint64_t random_state = 2463534242u;
static uint32_t random_bits(void)
{
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return (uint32_t)(random_state >> 32);
}
static double uniform(void) { return random_bits() * 0x1p-32; }

static lobe_vec3_f32 random_direction(double length)
{
    const double z = 2.0 * uniform() - 1.0, phi = 6.283185307179586 * uniform(), s = sqrt(1.0 - z * z);
    lobe_vec3_f32 d;
    d.x = (float)(length * s * cos(phi));
    d.y = (float)(length * s * sin(phi));
    d.z = (float)(length * z);
    return d;
}

static double angle_between(const double a[3], const double b[3])
{
    const double x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2], z = a[0] * b[1] - a[1] * b[0];
    return atan2(sqrt(x * x + y * y + z * z), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

/* The direction, of length 1 in double too; returns the length. */
static double to_double(lobe_vec3_f32 a, double out[3])
{
    const double x = (double)a.x, y = (double)a.y, z = (double)a.z, length = sqrt(x * x + y * y + z * z);
    out[0] = x / length;
    out[1] = y / length;
    out[2] = z / length;
    return length;
}

/* The azimuths' difference around n. */
static double azimuth(const double n[3], const double a[3], const double b[3])
{
    const double c = a[1] * b[2] - a[2] * b[1], d = a[2] * b[0] - a[0] * b[2], e = a[0] * b[1] - a[1] * b[0];
    const double an = a[0] * n[0] + a[1] * n[1] + a[2] * n[2], bn = b[0] * n[0] + b[1] * n[1] + b[2] * n[2];
    return atan2(c * n[0] + d * n[1] + e * n[2], a[0] * b[0] + a[1] * b[1] + a[2] * b[2] - an * bn);
}

static void check(lobe_vec3_f32 normal, lobe_vec3_f32 view, lobe_vec3_f32 to_centre, float radius)
{
    const lobe_sphere_f32 got = lobe_sphere_seen_f32(normal, view, to_centre, radius);
    double n[3], w[3], c[3], distance, sine, half, theta_v, theta_l, phi, root;
    double bad;
    to_double(normal, n);
    to_double(view, w);
    distance = to_double(to_centre, c);
    sine = fmin((double)radius / distance, 1.0);
    half = asin(sine);
    theta_v = angle_between(n, w);
    theta_l = angle_between(n, c);
    phi = azimuth(n, w, c);
    root = 0.5 * sqrt(pow(sin(theta_v) - sin(theta_l), 2) + 4.0 * sin(theta_v) * sin(theta_l) * pow(cos(0.5 * phi), 2));
    bad = fabs((double)got.n_dot_v - fmax(cos(theta_v), 0.0)) / 3e-7;
    bad = fmax(bad, fabs((double)got.n_dot_l - cos(theta_l)) / 3e-7);
    bad = fmax(bad, fabs((double)got.tangent2 - root * root) / (6e-7 * root + 1e-13));
    bad = fmax(bad, fabs((double)got.sine - sine) / (0x1p-22 * sine));
    /* near 90 degrees 1 - cos moves faster than the sine can say */
    bad = fmax(bad, fabs((double)got.versine - 2.0 * pow(sin(0.5 * half), 2)) /
                        (0x1p-21 * 2.0 * pow(sin(0.5 * half), 2) * (1.0 + 1.0 / (1e-3 + cos(half)))));
    if (!(bad <= 1.0))
        fail_msg(
            "n %a %a %a v %a %a %a c %a %a %a radius %a: got %.9g %.9g %.9g %.9g %.9g, want %.9g %.9g %.9g %.9g %.9g",
            n[0], n[1], n[2], w[0], w[1], w[2], c[0], c[1], c[2], (double)radius, (double)got.n_dot_v,
            (double)got.n_dot_l, (double)got.tangent2, (double)got.sine, (double)got.versine, cos(theta_v),
            cos(theta_l), root * root, sine, 2.0 * pow(sin(0.5 * half), 2));
}

static void is_trigonometry(void **state)
{
    int i;
    (void)state;
    for (i = 0; i < 400000; i++) {
        const double distance = pow(10.0, 12.0 * uniform() - 6.0);
        const lobe_vec3_f32 normal = random_direction(1.0), view = random_direction(1.0);
        lobe_vec3_f32 c = random_direction(distance);
        const float radius = (float)(distance * (i % 2 ? uniform() : pow(10.0, -6.0 * uniform())));
        if (i % 4 == 0) { /* near the mirror direction, where a narrow lobe needs tangent2 */
            const double d = 2.0 * ((double)normal.x * (double)view.x + (double)normal.y * (double)view.y +
                                    (double)normal.z * (double)view.z);
            const double off = 0.01 * uniform() * uniform();
            c.x = (float)(distance * (d * (double)normal.x - (double)view.x + off));
            c.y = (float)(distance * (d * (double)normal.y - (double)view.y));
            c.z = (float)(distance * (d * (double)normal.z - (double)view.z));
        }
        check(normal, view, c, radius);
    }
}

static void straight_down_and_level(void **state)
{
    static const lobe_vec3_f32 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
    int n, v, c;
    (void)state;
    for (n = 0; n < 6; n++)
        for (v = 0; v < 6; v++)
            for (c = 0; c < 6; c++)
                check(axes[n], axes[v], axes[c], 0.25f);
}

static int is_light(lobe_sphere_f32 s)
{
    return s.n_dot_v >= 0.0f && s.n_dot_v <= 1.0f && s.n_dot_l >= -1.0f && s.n_dot_l <= 1.0f && s.tangent2 >= 0.0f &&
           s.tangent2 <= 1.0f && s.sine >= 0.0f && s.sine <= 1.0f && s.versine >= 0.0f && s.versine <= 1.0f;
}

static void inside_the_sphere(void **state)
{
    const lobe_vec3_f32 up = {0, 0, 1}, none = {0, 0, 0}, near = {0, 0.3f, 0.4f};
    lobe_sphere_f32 s = lobe_sphere_seen_f32(up, up, near, 0.5f);
    (void)state;
    assert_true(s.sine == 1.0f && s.versine == 1.0f);
    s = lobe_sphere_seen_f32(up, up, near, 7.0f);
    assert_true(s.sine == 1.0f && s.versine == 1.0f && fabsf(s.n_dot_l - 0.8f) < 1e-6f);
    s = lobe_sphere_seen_f32(up, up, none, 1.0f); /* in the middle of it */
    assert_true(s.sine == 1.0f && s.versine == 1.0f && s.n_dot_l == 0.0f && s.n_dot_v == 1.0f && is_light(s));
    s = lobe_sphere_seen_f32(up, up, none, 0.0f); /* no light at all */
    assert_true(s.sine == 0.0f && s.versine == 0.0f && is_light(s));
    s = lobe_sphere_seen_f32(up, up, near, -1.0f);
    assert_true(s.sine == 0.0f && s.versine == 0.0f);
    s = lobe_sphere_seen_f32(none, none, near, 0.1f);
    assert_true(s.n_dot_v == 0.0f && s.n_dot_l == 0.0f && is_light(s));
    s = lobe_sphere_seen_f32(up, (lobe_vec3_f32){0, 0, -1}, near, 0.1f);
    assert_true(s.n_dot_v == 0.0f);
}

static void any_bits_are_answered(void **state)
{
    static const uint32_t specials[] = {0x00000000, 0x80000000, 0x00000001, 0x80000001, 0x00800000,
                                        0x0da24260, 0x26901d7d, 0x3f000000, 0x3f800000, 0xbf800000,
                                        0x3f800001, 0x5d5e0b6b, 0x5d5e0b6c, 0x7f7fffff, 0xff7fffff,
                                        0x7f800000, 0xff800000, 0x7fc00000, 0xffc00000, 0x7f800001};
    int i, k;
    (void)state;
    for (i = 0; i < 2000000; i++) {
        float x[10];
        lobe_sphere_f32 s;
        for (k = 0; k < 10; k++) {
            const uint32_t r = random_bits();
            const uint32_t bits = i & 1 ? r : specials[r % (sizeof specials / sizeof specials[0])];
            memcpy(&x[k], &bits, sizeof bits);
        }
        s = lobe_sphere_seen_f32((lobe_vec3_f32){x[0], x[1], x[2]}, (lobe_vec3_f32){x[3], x[4], x[5]},
                                 (lobe_vec3_f32){x[6], x[7], x[8]}, x[9]);
        if (!is_light(s))
            fail_msg("%a %a %a, %a %a %a, %a %a %a, %a: %a %a %a %a %a", (double)x[0], (double)x[1], (double)x[2],
                     (double)x[3], (double)x[4], (double)x[5], (double)x[6], (double)x[7], (double)x[8], (double)x[9],
                     (double)s.n_dot_v, (double)s.n_dot_l, (double)s.tangent2, (double)s.sine, (double)s.versine);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(is_trigonometry),
        cmocka_unit_test(straight_down_and_level),
        cmocka_unit_test(inside_the_sphere),
        cmocka_unit_test(any_bits_are_answered),
    };
    return cmocka_run_group_tests_name("sphere_seen", tests, NULL, NULL);
}
