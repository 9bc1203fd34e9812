/* lobe_sphere_light_low of ../sphere_light.h in integers: its letters, and the order of its lines.
 *
 * Difference to the formula in double over 3.6 million lights, half angle .01 to 90 degrees: 1.4e-7
 * (2^-22.8) of the peak; relative to results of a thousandth of the peak and more 1.5e-5, near the horizon. Down to
 * roughness .05 and n_dot_v .02, 1.6e-6 of the peak; at n_dot_v .0005, 4.2e-6. (Without the guard of 1e-36, which at
 * such views is larger than what it guards.) */
#include "sphere_light.h"
#include "../../core/dialect.h"
#include "../coeffs/sphere_light_low.h"

static const int32_t lobe_sphere_low_c0 = LOBE_Q_CONSTANT(LOBE_SPHERE_LIGHT_LOW_C0, 28);
static const int32_t lobe_sphere_low_c1 = LOBE_Q_CONSTANT(LOBE_SPHERE_LIGHT_LOW_C1, 28);
static const lobe_q_scaled lobe_sphere_low_c2 = LOBE_QS_CONSTANT(LOBE_SPHERE_LIGHT_LOW_C2);
static const lobe_q_scaled lobe_sphere_low_c3 = LOBE_QS_CONSTANT(LOBE_SPHERE_LIGHT_LOW_C3);
static const lobe_q_scaled lobe_sphere_low_c4 = LOBE_QS_CONSTANT(LOBE_SPHERE_LIGHT_LOW_C4);
static const lobe_q_scaled lobe_sphere_low_c5 = LOBE_QS_CONSTANT(LOBE_SPHERE_LIGHT_LOW_C5);
static const lobe_q_scaled lobe_sphere_low_c6 = LOBE_QS_CONSTANT(LOBE_SPHERE_LIGHT_LOW_C6);
static const lobe_q_scaled lobe_sphere_low_c7 = LOBE_QS_CONSTANT(LOBE_SPHERE_LIGHT_LOW_C7);

lobe_scaled_q30 lobe_sphere_light_low_q30(int32_t roughness, lobe_sphere_q30 light)
{
    const lobe_sphere_fixed s = lobe_sphere_fixed_of(roughness, light);
    const lobe_q_scaled v = lobe_qs_of(s.v, 0);
    const lobe_q_scaled across = lobe_qs_of(s.tangent2, 2);
    const int32_t height = lobe_sphere_height_fixed(&s, lobe_sphere_low_c0, lobe_sphere_low_c1);
    const lobe_q_scaled z = lobe_qs_of(height, 1);
    const lobe_q_scaled h = lobe_qs_of((s.v >> 1) + height, 1);
    const lobe_q_scaled h2 = lobe_qs_mul(h, h);
    const lobe_q_scaled y2 = lobe_qs_mul(s.alpha2, h2);
    const lobe_q_scaled off = lobe_qs_of(s.v - s.l, 0);
    const lobe_q_scaled apart = lobe_qs_add(across, lobe_qs_mul(off, off));
    const lobe_q_scaled lobe2 =
        lobe_qs_add(lobe_qs_mul(lobe_sphere_low_c3, y2), lobe_qs_mul(lobe_sphere_low_c4, s.alpha2));
    const lobe_q_scaled far = lobe_qs_add(apart, lobe_qs_add(lobe_qs_mul(lobe_sphere_low_c2, s.sine2), lobe2));
    const lobe_q_scaled left = lobe_qs_positive(lobe_qs_sub(far, lobe_qs_mul(lobe_sphere_low_c5, s.sine2)));
    const lobe_q_scaled w = lobe_qs_mul(left, across);
    const lobe_q_scaled q = lobe_qs_add(w, lobe_qs_mul(far, h2));
    const lobe_q_scaled t = lobe_qs_add(w, lobe_qs_mul(far, y2));
    const lobe_q_scaled va = lobe_qs_add(v, lobe_qs_mul(lobe_sphere_low_c6, s.alpha));
    const lobe_q_scaled root_v = lobe_qs_sqrt(lobe_sphere_stretched(&s, v));
    const lobe_q_scaled mask = lobe_sphere_mask_fixed(&s, v, root_v, z);
    const lobe_q_scaled eq = lobe_qs_mul(lobe_qs_mul(s.versine, s.alpha2), lobe_qs_mul(q, q));
    const lobe_q_scaled full = lobe_qs_mul(va, lobe_qs_mul(t, t));
    const lobe_q_scaled bottom = lobe_qs_mul(lobe_qs_add(full, lobe_qs_mul(lobe_sphere_low_c7, eq)), mask);
    return lobe_sphere_radiance_q30(lobe_qs_div(lobe_qs_mul(lobe_qs_mul(eq, va), z), bottom));
}
