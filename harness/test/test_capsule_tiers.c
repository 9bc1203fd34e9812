/* Capsule lights: f32 and q30 against the same formula in double, what every tier tends to, and that nothing breaks it:
 * no length, no radius, a point inside, any bits. */
#include "../../models/lobe.h"
#include "cmocka_first.h"
#include <math.h>
#include <string.h>

#define LOBE_DOUBLE
#include "../../models/capsule_light_high.h"

typedef struct tier {
    const char *name;
    float (*f32)(float roughness, lobe_capsule_f32 light);
    lobe_scaled_q30 (*q30)(int32_t roughness, lobe_capsule_q30 light);
    double (*formula)(double roughness, lobe_capsule light);
    double (*sphere)(double roughness, lobe_sphere light);
} tier;

static const tier tiers[] = {
    {"low", lobe_capsule_light_low_f32, lobe_capsule_light_low_q30, lobe_capsule_light_low, lobe_sphere_light_low},
    {"medium", lobe_capsule_light_medium_f32, lobe_capsule_light_medium_q30, lobe_capsule_light_medium,
     lobe_sphere_light_medium},
    {"high", lobe_capsule_light_high_f32, lobe_capsule_light_high_q30, lobe_capsule_light_high, lobe_sphere_light_high},
};
enum { TIERS = sizeof tiers / sizeof tiers[0] };

static uint64_t random_state;

static uint32_t random_bits(void)
{
    random_state = random_state * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)(random_state >> 32);
}

/* A multiple of 2^-24 in [-1, 1): exact in f32 and q30. */
static double coordinate(void) { return (double)(random_bits() >> 7) * 0x1p-24 - 1; }

static double between(double lo, double hi)
{
    return floor((lo + (hi - lo) * (random_bits() * 0x1p-32)) * 0x1p24) * 0x1p-24;
}

typedef struct row {
    double roughness;
    lobe_capsule light;
} row;

/* The middle about 1 away, the line no nearer than 1.5 radii and .2: the domain that the header states. */
static row row_of(void)
{
    row r;
    for (;;) {
        lobe_capsule *c = &r.light;
        double m2, em, e2;
        r.roughness = between(.22, 1);
        c->n_dot_v = between(.08, 1);
        c->mx = coordinate();
        c->my = coordinate();
        c->mz = coordinate();
        c->ex = coordinate();
        c->ey = coordinate();
        c->ez = coordinate();
        c->radius = between(.001, .5);
        m2 = c->mx * c->mx + c->my * c->my + c->mz * c->mz;
        e2 = c->ex * c->ex + c->ey * c->ey + c->ez * c->ez;
        em = c->ex * c->mx + c->ey * c->my + c->ez * c->mz;
        if (m2 < .9 || m2 > 1.1 || e2 > 1 || m2 - em * em / e2 < fmax(.04, 2.25 * c->radius * c->radius))
            continue;
        return r;
    }
}

static lobe_capsule_f32 f32_of(lobe_capsule c)
{
    const lobe_capsule_f32 y = {(float)c.n_dot_v,
                                {(float)c.mx, (float)c.my, (float)c.mz},
                                {(float)c.ex, (float)c.ey, (float)c.ez},
                                (float)c.radius};
    return y;
}

static int32_t fixed(double x) { return (int32_t)lrint(x * LOBE_ONE_Q30); }

static lobe_capsule_q30 q30_of(lobe_capsule c)
{
    const lobe_capsule_q30 y = {fixed(c.n_dot_v),
                                {fixed(c.mx), fixed(c.my), fixed(c.mz)},
                                {fixed(c.ex), fixed(c.ey), fixed(c.ez)},
                                fixed(c.radius)};
    return y;
}

static double value(lobe_scaled_q30 y) { return ldexp(y.mantissa, y.exponent - 30); }

static void formats_keep_the_formula(void **state)
{
    double f32[TIERS] = {0}, q30[TIERS] = {0};
    int i, k;
    (void)state;
    random_state = 1;
    for (i = 0; i < 20000; i++) {
        const row r = row_of();
        for (k = 0; k < TIERS; k++) {
            const double y = tiers[k].formula(r.roughness, r.light);
            f32[k] = fmax(f32[k], fabs((double)tiers[k].f32((float)r.roughness, f32_of(r.light)) - y));
            q30[k] = fmax(q30[k], fabs(value(tiers[k].q30(fixed(r.roughness), q30_of(r.light))) - y));
        }
    }
    for (k = 0; k < TIERS; k++) {
        print_message("# %s: f32 within %.1e, q30 within %.1e of the formula\n", tiers[k].name, f32[k], q30[k]);
        assert_true(f32[k] <= 2e-5 && q30[k] <= 0x1p-16);
    }
}

/* The sphere at the middle, from the same numbers. */
static lobe_sphere sphere_of(lobe_capsule c)
{
    const double d = sqrt(c.mx * c.mx + c.my * c.my + c.mz * c.mz), x = c.mx / d + sqrt(1 - c.n_dot_v * c.n_dot_v);
    return lobe_sphere_of(c.n_dot_v, c.mz / d, .25 * (x * x + c.my / d * (c.my / d)), c.radius / d);
}

static void no_length_is_a_sphere(void **state)
{
    double worst = 0, fixed_worst = 0;
    int i, k;
    (void)state;
    random_state = 2;
    for (i = 0; i < 2000; i++) {
        row r = row_of();
        r.light.ex = r.light.ey = r.light.ez = 0;
        for (k = 0; k < TIERS; k++) {
            const double y = tiers[k].sphere(r.roughness, sphere_of(r.light));
            const double q = value(tiers[k].q30(fixed(r.roughness), q30_of(r.light)));
            worst = fmax(worst, fabs(tiers[k].formula(r.roughness, r.light) - y) / (y + 1e-9));
            fixed_worst = fmax(fixed_worst, fabs(q - y));
        }
    }
    print_message("# without a length: %.1e relative of the sphere, q30 %.1e\n", worst, fixed_worst);
    assert_true(worst <= 1e-9 && fixed_worst <= 0x1p-16);
}

/* A thin tube's light is in proportion to its radius, a small sphere's to the square of it. */
static void thin_is_a_line(void **state)
{
    int i, k;
    (void)state;
    random_state = 3;
    for (i = 0; i < 2000; i++) {
        row r = row_of();
        if (sqrt(r.light.ex * r.light.ex + r.light.ey * r.light.ey + r.light.ez * r.light.ez) < .2 || r.light.mz < .2)
            continue;
        for (k = 0; k < TIERS; k++) {
            double wide, thin;
            r.light.radius = 2e-4;
            wide = tiers[k].formula(r.roughness, r.light);
            r.light.radius = 1e-4;
            thin = tiers[k].formula(r.roughness, r.light);
            assert_true(wide > 0 && fabs(thin / wide - .5) <= .01);
        }
    }
}

/* Nothing depends on the unit, on which end is first, or on the side of the plane of incidence. */
static void symmetries(void **state)
{
    int i, k;
    (void)state;
    random_state = 4;
    for (i = 0; i < 5000; i++) {
        const row r = row_of();
        const float roughness = (float)r.roughness;
        lobe_capsule_f32 c = f32_of(r.light), far = c, turned = c, mirrored = c;
        lobe_capsule_q30 q = q30_of(r.light), small = q;
        int n;
        float *length[7] = {&far.middle.x, &far.middle.y, &far.middle.z, &far.arm.x,
                            &far.arm.y,    &far.arm.z,    &far.radius};
        int32_t *units[7] = {&small.middle.x, &small.middle.y, &small.middle.z, &small.arm.x,
                             &small.arm.y,    &small.arm.z,    &small.radius};
        for (n = 0; n < 7; n++) {
            *length[n] *= 4096.0f;
            *units[n] /= 16384; /* to Q16.16 */
        }
        turned.arm.x = -c.arm.x;
        turned.arm.y = -c.arm.y;
        turned.arm.z = -c.arm.z;
        mirrored.middle.y = -c.middle.y;
        mirrored.arm.y = -c.arm.y;
        for (k = 0; k < TIERS; k++) {
            const float y = tiers[k].f32(roughness, c);
            assert_true(tiers[k].f32(roughness, far) == y);
            assert_true(tiers[k].f32(roughness, mirrored) == y);
            assert_true(fabsf(tiers[k].f32(roughness, turned) - y) <= 2e-5f);
            /* a unit of Q16.16 is 1.5e-5, and radiance may change by 1 within alpha = .05 of it */
            assert_true(fabs(value(tiers[k].q30(fixed(r.roughness), small)) -
                             value(tiers[k].q30(fixed(r.roughness), q))) <= 2e-2);
        }
    }
}

static float any_float(void)
{
    const uint32_t bits = random_bits(), kind = random_bits() % 8;
    float x;
    memcpy(&x, &bits, sizeof x);
    return kind == 0 ? x : kind == 1 ? 0.0f : kind == 2 ? (float)(random_bits() % 3) - 1.0f : (float)coordinate();
}

static int32_t any_int(void)
{
    static const int32_t ends[6] = {0, 1, -1, INT32_MIN, INT32_MAX, LOBE_ONE_Q30};
    const uint32_t kind = random_bits() % 4;
    return kind == 0 ? ends[random_bits() % 6] : (int32_t)random_bits() >> (kind == 1 ? random_bits() % 31 : 0);
}

static void any_bits_are_taken(void **state)
{
    int i, k;
    (void)state;
    random_state = 5;
    for (i = 0; i < 300000; i++) {
        lobe_capsule_f32 c = {
            any_float(), {any_float(), any_float(), any_float()}, {any_float(), any_float(), any_float()}, any_float()};
        lobe_capsule_q30 q = {
            any_int(), {any_int(), any_int(), any_int()}, {any_int(), any_int(), any_int()}, any_int()};
        const float roughness = any_float();
        const int32_t rough = any_int();
        if (i % 7 == 0) { /* a sphere; the point at the middle; both */
            memset(&c.arm, 0, sizeof c.arm);
            memset(&q.arm, 0, sizeof q.arm);
        }
        if (i % 5 == 0) {
            memset(&c.middle, 0, sizeof c.middle);
            memset(&q.middle, 0, sizeof q.middle);
        }
        for (k = 0; k < TIERS; k++) {
            const float y = tiers[k].f32(roughness, c);
            const lobe_scaled_q30 z = tiers[k].q30(rough, q);
            assert_true(y >= 0.0f && y <= 1.0f);
            assert_true(z.mantissa == 0 || (z.mantissa >= LOBE_ONE_Q30 / 2 && z.mantissa <= LOBE_ONE_Q30));
            assert_true(value(z) <= 1);
        }
    }
}

typedef struct frame {
    double x[3], y[3], z[3];
} frame;

/* Any turn of the world. */
static frame frame_of(void)
{
    frame f;
    double n = 0, d = 0, t = 0;
    int k;
    for (k = 0; k < 3; k++) {
        f.z[k] = coordinate();
        f.x[k] = coordinate();
        n += f.z[k] * f.z[k];
    }
    for (k = 0; k < 3; k++) {
        f.z[k] /= sqrt(n);
        d += f.z[k] * f.x[k];
    }
    for (k = 0; k < 3; k++) {
        f.x[k] -= d * f.z[k];
        t += f.x[k] * f.x[k];
    }
    for (k = 0; k < 3; k++)
        f.x[k] /= sqrt(t);
    f.y[0] = f.z[1] * f.x[2] - f.z[2] * f.x[1];
    f.y[1] = f.z[2] * f.x[0] - f.z[0] * f.x[2];
    f.y[2] = f.z[0] * f.x[1] - f.z[1] * f.x[0];
    return f;
}

static lobe_vec3_f32 world(const frame *f, double x, double y, double z)
{
    const lobe_vec3_f32 w = {(float)(x * f->x[0] + y * f->y[0] + z * f->z[0]),
                             (float)(x * f->x[1] + y * f->y[1] + z * f->z[1]),
                             (float)(x * f->x[2] + y * f->y[2] + z * f->z[2])};
    return w;
}

static void seen_from_any_side(void **state)
{
    double worst = 0, lean = 0;
    int i;
    (void)state;
    random_state = 6;
    for (i = 0; i < 20000; i++) {
        const row r = row_of();
        const frame f = frame_of();
        const lobe_capsule *c = &r.light;
        const double s = i % 4 ? sqrt(1 - c->n_dot_v * c->n_dot_v) : .01, v = i % 4 ? c->n_dot_v : sqrt(1 - 1e-4);
        const lobe_capsule_f32 y = lobe_capsule_seen_f32(
            world(&f, 0, 0, 1), world(&f, s, 0, v), world(&f, c->mx - c->ex, c->my - c->ey, c->mz - c->ez),
            world(&f, c->mx + c->ex, c->my + c->ey, c->mz + c->ez), (float)c->radius);
        const double off[6] = {y.middle.x - c->mx, y.middle.y - c->my, y.middle.z - c->mz,
                               y.arm.x - c->ex,    y.arm.y - c->ey,    y.arm.z - c->ez};
        double most = fabs((double)y.n_dot_v - v);
        int k;
        for (k = 0; k < 6; k++)
            most = fmax(most, fabs(off[k]));
        if (i % 4)
            worst = fmax(worst, most * s);
        else
            lean = fmax(lean, most * .01);
        assert_true(y.radius == (float)c->radius);
    }
    print_message("# seen: %.1e over the lean of the view, %.1e where that is .01\n", worst, lean);
    assert_true(worst <= 1e-6 && lean <= 1e-6);
}

/* The view on the normal: any frame will do, and the radiance is that of the true one. */
static void seen_along_the_normal(void **state)
{
    int i;
    (void)state;
    random_state = 7;
    for (i = 0; i < 2000; i++) {
        const frame f = frame_of();
        const row r = row_of();
        lobe_capsule c = r.light;
        const lobe_vec3_f32 n = world(&f, 0, 0, 1);
        lobe_capsule_f32 y = lobe_capsule_seen_f32(n, n, world(&f, c.mx - c.ex, c.my - c.ey, c.mz - c.ez),
                                                   world(&f, c.mx + c.ex, c.my + c.ey, c.mz + c.ez), (float)c.radius);
        c.n_dot_v = 1;
        y.n_dot_v = 1; /* where the sum of three squares of a unit vector is rounded down, the view leans */
        assert_true(fabs((double)lobe_capsule_light_high_f32((float)r.roughness, y) -
                         lobe_capsule_light_high(r.roughness, c)) <= 1e-4);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(formats_keep_the_formula), cmocka_unit_test(no_length_is_a_sphere),
        cmocka_unit_test(thin_is_a_line),           cmocka_unit_test(symmetries),
        cmocka_unit_test(any_bits_are_taken),       cmocka_unit_test(seen_from_any_side),
        cmocka_unit_test(seen_along_the_normal),
    };
    return cmocka_run_group_tests_name("capsule light tiers", tests, NULL, NULL);
}
