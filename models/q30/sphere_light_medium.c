/* lobe_sphere_light_medium of ../sphere_light.h in integers: its letters, and the order of its lines.
 *
 * Difference to the formula in double over 3.6 million lights, half angle .01 to 90 degrees: 7.3e-8
 * (2^-23.7) of the peak; relative to results of a thousandth of the peak and more 2.1e-5, near the horizon. Down to
 * roughness .05 and n_dot_v .02, 1.2e-6 of the peak; at n_dot_v .0005, 4e-6. (Without the guard of 1e-20, which at such
 * views is larger than what it guards.) */
#include "sphere_light.h"
#include "../../core/dialect.h"
#include "../coeffs/sphere_light_medium.h"

static const int32_t lobe_sphere_medium_c0 = LOBE_Q_CONSTANT(LOBE_SPHERE_LIGHT_MEDIUM_C0, 28);
static const int32_t lobe_sphere_medium_c1 = LOBE_Q_CONSTANT(LOBE_SPHERE_LIGHT_MEDIUM_C1, 28);
static const lobe_q_scaled lobe_sphere_medium_c2 = LOBE_QS_CONSTANT(LOBE_SPHERE_LIGHT_MEDIUM_C2);
static const lobe_q_scaled lobe_sphere_medium_c3 = LOBE_QS_CONSTANT(LOBE_SPHERE_LIGHT_MEDIUM_C3);
static const lobe_q_scaled lobe_sphere_medium_c4 = LOBE_QS_CONSTANT(LOBE_SPHERE_LIGHT_MEDIUM_C4);
static const lobe_q_scaled lobe_sphere_medium_c5 = LOBE_QS_CONSTANT(LOBE_SPHERE_LIGHT_MEDIUM_C5);
static const lobe_q_scaled lobe_sphere_medium_c6 = LOBE_QS_CONSTANT(LOBE_SPHERE_LIGHT_MEDIUM_C6);
static const lobe_q_scaled lobe_sphere_medium_c7 = LOBE_QS_CONSTANT(LOBE_SPHERE_LIGHT_MEDIUM_C7);
static const lobe_q_scaled lobe_sphere_medium_c8 = LOBE_QS_CONSTANT(LOBE_SPHERE_LIGHT_MEDIUM_C8);
static const lobe_q_scaled lobe_sphere_medium_c9 = LOBE_QS_CONSTANT(LOBE_SPHERE_LIGHT_MEDIUM_C9);

lobe_scaled_q30 lobe_sphere_light_medium_q30(int32_t roughness, lobe_sphere_q30 light)
{
    const lobe_sphere_fixed s = lobe_sphere_fixed_of(roughness, light);
    const lobe_q_scaled v = lobe_qs_of(s.v, 0), r = lobe_qs_of(s.r, 0), one = {LOBE_Q30_ONE / 2, 1};
    const lobe_q_scaled across = lobe_qs_of(s.tangent2, 2);
    const int32_t height = lobe_sphere_height_fixed(&s, lobe_sphere_medium_c0, lobe_sphere_medium_c1);
    const lobe_q_scaled z = lobe_qs_of(height, 1);
    const lobe_q_scaled off = lobe_qs_of(s.v - s.l, 0);
    const lobe_q_scaled far = lobe_qs_sqrt(lobe_qs_add(across, lobe_qs_mul(off, off)));
    const lobe_q_scaled wide =
        lobe_qs_mul(lobe_qs_add(lobe_sphere_medium_c2, lobe_qs_mul(lobe_sphere_medium_c3, v)), lobe_qs_mul(s.alpha, v));
    const lobe_q_scaled reach = lobe_qs_mul(lobe_qs_add(r, wide), far);
    const lobe_q_scaled part = lobe_qs_div(s.sine2, reach);
    const lobe_q_scaled moved = lobe_qs_less(part, one) ? part : one;
    const lobe_q_scaled left = lobe_qs_sub(one, moved);
    const lobe_q_scaled h = lobe_qs_add(lobe_qs_of((s.v >> 1) + height, 1), lobe_qs_mul(moved, off));
    const lobe_q_scaled h2 = lobe_qs_mul(h, h);
    const lobe_q_scaled w = lobe_qs_mul(lobe_qs_mul(left, left), across);
    const lobe_q_scaled q = lobe_qs_add(w, h2);
    const lobe_q_scaled t = lobe_qs_add(w, lobe_qs_mul(s.alpha2, h2));
    const lobe_q_scaled root_v = lobe_qs_sqrt(lobe_sphere_stretched(&s, v));
    const lobe_q_scaled mask = lobe_sphere_mask_fixed(&s, v, root_v, z);
    const lobe_q_scaled va = lobe_qs_add(v, lobe_qs_mul(lobe_sphere_medium_c4, s.alpha));
    const lobe_q_scaled zk = lobe_qs_add(z, lobe_qs_mul(lobe_sphere_medium_c5, v));
    const lobe_q_scaled knee_a = lobe_qs_mul(lobe_sphere_medium_c7, s.alpha);
    const lobe_q_scaled knee_v = lobe_qs_mul(lobe_sphere_medium_c8, v);
    const lobe_q_scaled knee = lobe_qs_add(lobe_qs_add(lobe_sphere_medium_c6, knee_a), knee_v);
    const lobe_q_scaled top = lobe_qs_mul(lobe_qs_mul(s.versine, s.alpha2), lobe_qs_mul(q, q));
    const lobe_q_scaled full = lobe_qs_mul(top, zk);
    const lobe_q_scaled bottom = lobe_qs_mul(lobe_qs_mul(t, t), lobe_qs_mul(va, zk));
    const lobe_q_scaled early = lobe_qs_mul(bottom, lobe_qs_add(bottom, lobe_qs_mul(knee, top)));
    const lobe_q_scaled late = lobe_qs_mul(lobe_sphere_medium_c9, lobe_qs_mul(full, full));
    const lobe_q_scaled bend = lobe_qs_sqrt(lobe_qs_add(early, late));
    const lobe_q_scaled lit = lobe_qs_mul(full, lobe_qs_mul(va, z));
    return lobe_sphere_radiance_q30(lobe_qs_div(lit, lobe_qs_mul(bend, mask)));
}
