/* lobe_sphere_light_medium of ../sphere_light.h in integers: its letters, and the order of its lines. */
#include "sphere_light.h"
#include "../../core/dialect.h"
#include "../coeffs/sphere_light_medium.h"

static const int32_t lobe_sphere_medium_c0 = LOBE_Q_CONSTANT(LOBE_SPHERE_LIGHT_MEDIUM_C0, 28);
static const lobe_q_scaled lobe_sphere_medium_c1 = LOBE_QS_CONSTANT(LOBE_SPHERE_LIGHT_MEDIUM_C1);
static const lobe_q_scaled lobe_sphere_medium_c2 = LOBE_QS_CONSTANT(LOBE_SPHERE_LIGHT_MEDIUM_C2);
static const lobe_q_scaled lobe_sphere_medium_c3 = LOBE_QS_CONSTANT(LOBE_SPHERE_LIGHT_MEDIUM_C3);
static const lobe_q_scaled lobe_sphere_medium_c4 = LOBE_QS_CONSTANT(LOBE_SPHERE_LIGHT_MEDIUM_C4);
static const lobe_q_scaled lobe_sphere_medium_c5 = LOBE_QS_CONSTANT(LOBE_SPHERE_LIGHT_MEDIUM_C5);

lobe_scaled_q30 lobe_sphere_light_medium_q30(int32_t roughness, lobe_sphere_q30 light)
{
    const lobe_sphere_fixed s = lobe_sphere_fixed_of(roughness, light);
    const lobe_q_scaled v = lobe_qs_of(s.v, 0), r = lobe_qs_of(s.r, 0), one = {LOBE_Q30_ONE / 2, 1};
    const lobe_q_scaled across = lobe_qs_of(s.tangent2, 2);
    const lobe_q_scaled off = lobe_qs_of(s.v - s.l, 0);
    const lobe_q_scaled far = lobe_qs_sqrt(lobe_qs_add(across, lobe_qs_mul(off, off)));
    const lobe_q_scaled lobe = lobe_qs_mul(lobe_qs_mul(lobe_sphere_medium_c1, s.alpha),
                                           lobe_qs_add(v, lobe_qs_mul(lobe_sphere_medium_c2, s.alpha)));
    const lobe_q_scaled reach = lobe_qs_mul(lobe_qs_add(r, lobe), far);
    const lobe_q_scaled left = lobe_qs_positive(lobe_qs_sub(one, lobe_qs_div(s.sine2, reach)));
    const int32_t height = lobe_sphere_height_fixed(&s, lobe_sphere_medium_c0, lobe_sphere_medium_c0);
    const lobe_q_scaled z = lobe_qs_of(height, 1);
    const lobe_q_scaled h = lobe_qs_of((s.v >> 1) + height, 1);
    const lobe_q_scaled h2 = lobe_qs_mul(h, h);
    const lobe_q_scaled w = lobe_qs_mul(lobe_qs_mul(left, left), across);
    const lobe_q_scaled q = lobe_qs_add(w, h2);
    const lobe_q_scaled t = lobe_qs_add(w, lobe_qs_mul(s.alpha2, h2));
    const lobe_q_scaled root_v = lobe_qs_sqrt(lobe_sphere_stretched(&s, v));
    const lobe_q_scaled va = lobe_qs_add(v, root_v);
    const lobe_q_scaled vk = lobe_qs_add(v, lobe_qs_mul(lobe_sphere_medium_c3, s.alpha));
    const lobe_q_scaled top = lobe_qs_mul(lobe_qs_mul(s.versine, s.alpha2), lobe_qs_mul(q, q));
    const lobe_q_scaled bottom = lobe_qs_mul(lobe_qs_mul(t, t), va);
    const lobe_q_scaled knee = lobe_qs_add(lobe_qs_mul(lobe_sphere_medium_c4, bottom),
                                           lobe_qs_mul(lobe_sphere_medium_c5, lobe_qs_mul(vk, top)));
    const lobe_q_scaled bent = lobe_qs_add(lobe_qs_mul(vk, lobe_qs_mul(bottom, bottom)), lobe_qs_mul(top, knee));
    const lobe_q_scaled bend = lobe_qs_sqrt(lobe_qs_mul(vk, bent));
    const lobe_q_scaled mask = lobe_sphere_mask_fixed(&s, v, root_v, z);
    const lobe_q_scaled lit = lobe_qs_mul(lobe_qs_mul(top, va), lobe_qs_mul(vk, z));
    return lobe_sphere_radiance_q30(lobe_qs_div(lit, lobe_qs_mul(bend, mask)));
}
