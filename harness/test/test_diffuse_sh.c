/* Nine coefficients of Burley's diffuse, as the library gives them, against the closed form in double (which
 * cases/test/test_diffuse_sh.c holds against quadrature): floors of the formats, of the furnace, and of the radiance
 * over random order-3 lighting. */
#define LOBE_DOUBLE 1
#include "../../models/diffuse_sh.h"
#include "../../models/diffuse_zonal.h"
#include "../registry.h"
#include "../../models/lobe.h"
#include "cmocka_first.h"
#include <math.h>

typedef lobe_sh9 formula(double roughness, double n_dot_v);

static lobe_sh9 lambert(double roughness, double n_dot_v)
{
    (void)roughness;
    (void)n_dot_v;
    return lobe_diffuse_sh_lambert();
}

/* What each format adds to the formula at most: f32 the project's floor, q30 what the interface says (its floor is
 * 2^-18); and the floors of light and furnace. */
static const struct tier {
    const char *name;
    formula *in_double;
    double f32, q30, light, furnace_rms, furnace_max;
} tiers[] = {
    {"exact", lobe_diffuse_sh_exact, 2e-6, 2e-8, 2e-6, 2e-6, 2e-6},
    {"medium", lobe_diffuse_sh_medium, 2e-6, 2e-8, 0.016, 0.008, 0.036},
    {"low", lobe_diffuse_sh_low, 2e-6, 2e-8, 0.025, 0.008, 0.036},
    {"zonal", lobe_diffuse_sh_zonal, 2e-6, 2e-8, 0.016, 0.008, 0.036},
    {"zonal_low", lobe_diffuse_sh_zonal_low, 2e-6, 2e-8, 0.025, 0.0143, 0.039},
    {"lambert", lambert, 2e-6, 2e-8, 0.136, 0.126, 1.05},
};
enum { TIERS = sizeof tiers / sizeof tiers[0] };

static void spread(lobe_sh9 a, double c[9])
{
    const double all[9] = {a.c0, a.c1, a.c2, a.c3, a.c4, a.c5, a.c6, a.c7, a.c8};
    int k;
    for (k = 0; k < 9; k++)
        c[k] = all[k];
}

static void evaluate(const lobe_entry *e, double roughness, double n_dot_v, double c[9])
{
    lobe_value in[LOBE_MAX_INPUTS], out[LOBE_MAX_OUTPUTS];
    int k;
    in[0] = lobe_value_nearest(e->format, roughness);
    in[1] = lobe_value_nearest(e->format, n_dot_v);
    e->call(in, out);
    for (k = 0; k < 9; k++)
        c[k] = lobe_value_real(e->format, out[k]);
}

static const lobe_entry *entry(const struct tier *t, int format)
{
    const lobe_entry *e = lobe_find_entry("diffuse_sh", t->name, (lobe_format)format);
    assert_non_null(e);
    return e;
}

static void compare(const struct tier *t, const lobe_entry *e, double roughness, double n_dot_v)
{
    const double allowed = e->format == LOBE_F32 ? t->f32 : t->q30;
    double got[9], want[9];
    int k;
    evaluate(e, roughness, n_dot_v, got);
    spread(t->in_double(roughness, n_dot_v), want);
    for (k = 0; k < 9; k++)
        if (!(fabs(got[k] - want[k]) <= allowed))
            fail_msg("%s at %.9g %.9g: c%d is %.9g, not %.9g within %g", e->kernel, roughness, n_dot_v, k, got[k],
                     want[k], allowed);
}

/* A grid whose step is no power of two, and both ends of NdotV from 2^-24 up, where the root turns. */
static void formats_keep_their_floors(void **state)
{
    int t, format, a, b;
    (void)state;
    for (t = 0; t < TIERS; t++) {
        for (format = 0; format < LOBE_FORMATS; format++) {
            const lobe_entry *e = entry(&tiers[t], format);
            for (a = 0; a <= 640; a++) {
                const double r = floor(a / 640.0 * 16777216.0) / 16777216.0;
                for (b = 0; b <= 643; b++)
                    compare(&tiers[t], e, r, floor(b / 643.0 * 16777216.0) / 16777216.0);
                for (b = 1; b <= 24; b++) {
                    compare(&tiers[t], e, r, ldexp(1.0, -b));
                    compare(&tiers[t], e, r, 1.0 - ldexp(1.0, -b));
                }
            }
        }
    }
}

/* Over lighting with independent coefficients the radiance's relative rms is that of the nine; a constant environment
 * sees coefficient 0 alone. */
static void light_and_furnace(void **state)
{
    enum { SIDE = 33 };
    int t, format, i, k;
    (void)state;
    for (t = 0; t < TIERS; t++) {
        for (format = 0; format < LOBE_FORMATS; format++) {
            const lobe_entry *e = entry(&tiers[t], format);
            double wrong = 0.0, total = 0.0, square = 0.0, most = 0.0;
            for (i = 0; i < SIDE * SIDE; i++) {
                const double r = (i / SIDE) / (SIDE - 1.0), v = (i % SIDE) / (SIDE - 1.0);
                double got[9], want[9], furnace;
                evaluate(e, r, v, got);
                spread(lobe_diffuse_sh_exact(r, v), want);
                for (k = 0; k < 9; k++) {
                    wrong += (got[k] - want[k]) * (got[k] - want[k]);
                    total += want[k] * want[k];
                }
                furnace = got[0] / want[0] - 1.0;
                square += furnace * furnace;
                most = fmax(most, fabs(furnace));
            }
            if (!(sqrt(wrong / total) <= tiers[t].light && sqrt(square / (SIDE * SIDE)) <= tiers[t].furnace_rms &&
                  most <= tiers[t].furnace_max))
                fail_msg("%s: light %g (%g allowed), furnace %g (%g), max %g (%g)", e->kernel, sqrt(wrong / total),
                         tiers[t].light, sqrt(square / (SIDE * SIDE)), tiers[t].furnace_rms, most,
                         tiers[t].furnace_max);
        }
    }
}

/* Known without an integral. At v = 1 the azimuth has no meaning, so all that is not zonal is 0; at roughness 0 the
 * lobe depends on L through n.L alone. */
static void symmetric_where_it_must_be(void **state)
{
    int t, format, i;
    (void)state;
    for (t = 0; t < TIERS; t++) {
        for (format = 0; format < LOBE_FORMATS; format++) {
            const lobe_entry *e = entry(&tiers[t], format);
            for (i = 0; i <= 64; i++) {
                double c[9];
                evaluate(e, i / 64.0, 1.0, c);
                assert_true(c[3] == 0.0 && c[7] == 0.0 && c[8] == 0.0);
                evaluate(e, 0.0, i / 64.0, c);
                assert_true(c[3] == 0.0 && c[7] == 0.0 && c[8] == 0.0);
                evaluate(e, i / 64.0, i / 64.0, c);
                assert_true(c[1] == 0.0 && c[4] == 0.0 && c[5] == 0.0);
            }
        }
    }
}

/* The zonal lobe is what the nine coefficients of its tier are made of, around a unit vector. */
static void one_direction(void **state)
{
    int a, b, low;
    (void)state;
    for (low = 0; low < 2; low++) {
        for (a = 0; a <= 64; a++) {
            for (b = 0; b <= 64; b++) {
                const double r = a / 64.0, v = b / 64.0, s = sqrt(1.0 - v * v);
                const lobe_zonal_f32 z =
                    low ? lobe_diffuse_zonal_low_f32((float)r, (float)v) : lobe_diffuse_zonal_f32((float)r, (float)v);
                const lobe_zonal_q30 q =
                    low ? lobe_diffuse_zonal_low_q30(a << 24, b << 24) : lobe_diffuse_zonal_q30(a << 24, b << 24);
                const double got[2][5] = {
                    {(double)z.z0, (double)z.z1, (double)z.z2, (double)z.along_normal, (double)z.along_view},
                    {q.z0 * 0x1p-30, q.z1 * 0x1p-30, q.z2 * 0x1p-30, q.along_normal * 0x1p-30, q.along_view * 0x1p-30}};
                double want[9], turned[9];
                int format, k;
                spread((low ? lobe_diffuse_sh_zonal_low : lobe_diffuse_sh_zonal)(r, v), want);
                for (format = 0; format < 2; format++) {
                    const double *g = got[format];
                    const lobe_vec3 d = lobe_vec3_of(g[4] * s, 0.0, g[3] + g[4] * v);
                    assert_true(fabs(lobe_vec3_dot(d, d) - 1.0) <= 1e-6);
                    spread(lobe_sh9_zonal(g[0], g[1], g[2], d), turned);
                    for (k = 0; k < 9; k++)
                        assert_true(fabs(turned[k] - want[k]) <= 1e-6);
                }
            }
        }
    }
}

static void other_sign(void **state)
{
    static const int sign[9] = {1, -1, 1, -1, 1, -1, 1, -1, 1}; /* (-1)^m */
    lobe_sh9_f32 f;
    lobe_sh9_q30 q;
    int k;
    (void)state;
    for (k = 0; k < 9; k++) {
        f.c[k] = 0.25f * (float)(k + 1);
        q.c[k] = 12345678 * (k + 1);
    }
    q.c[5] = INT32_MIN;
    const lobe_sh9_f32 g = lobe_sh9_other_sign_f32(f), back = lobe_sh9_other_sign_f32(g);
    const lobe_sh9_q30 p = lobe_sh9_other_sign_q30(q);
    for (k = 0; k < 9; k++) {
        assert_true(g.c[k] == (float)sign[k] * f.c[k] && back.c[k] == f.c[k]);
        assert_true(k == 5 ? p.c[k] == INT32_MAX : p.c[k] == sign[k] * q.c[k]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(formats_keep_their_floors),
        cmocka_unit_test(light_and_furnace),
        cmocka_unit_test(symmetric_where_it_must_be),
        cmocka_unit_test(one_direction),
        cmocka_unit_test(other_sign),
    };
    return cmocka_run_group_tests_name("diffuse_sh", tests, NULL, NULL);
}
