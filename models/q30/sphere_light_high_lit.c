/* lobe_sphere_high_schlick of ../sphere_light_high.h in integers, beside high: its letters, and the order of its lines.
 */
#include "sphere_light_height.h"
#include "sphere_light_schlick.h"

#define C(i) LOBE_QS_CONSTANT(LOBE_SPHERE_LIGHT_HIGH_C##i)
static const lobe_q_scaled lobe_sphere_lit_c5 = C(5), lobe_sphere_lit_c6 = C(6), lobe_sphere_lit_c7 = C(7);
static const lobe_q_scaled lobe_sphere_lit_c8 = C(8), lobe_sphere_lit_c9 = C(9), lobe_sphere_lit_c10 = C(10);
static const lobe_q_scaled lobe_sphere_lit_c11 = C(11), lobe_sphere_lit_c12 = C(12), lobe_sphere_lit_c13 = C(13);
static const lobe_q_scaled lobe_sphere_lit_c14 = C(14), lobe_sphere_lit_c15 = C(15), lobe_sphere_lit_c16 = C(16);

/* a + b x */
static lobe_q_scaled lobe_sphere_lit_line(lobe_q_scaled a, lobe_q_scaled b, lobe_q_scaled x)
{
    return lobe_qs_add(a, lobe_qs_mul(b, x));
}

lobe_sphere_lit_q30 lobe_sphere_light_high_lit_q30(int32_t roughness, lobe_sphere_q30 light)
{
    const lobe_sphere_fixed s = lobe_sphere_fixed_of(roughness, light);
    const lobe_sphere_schlick_fixed k = lobe_sphere_schlick_begin(&s, lobe_sphere_lit_c6, lobe_sphere_lit_c7);
    const lobe_q_scaled one = lobe_qs_of(LOBE_Q30_ONE, 0), v = lobe_qs_of(s.v, 0), l = lobe_qs_of(s.l, 0);
    const lobe_q_scaled height = lobe_qs_of(lobe_sphere_high_height(&s), 1);
    const lobe_q_scaled left = lobe_qs_positive(lobe_qs_sub(one, lobe_qs_mul(lobe_sphere_lit_c5, k.part)));
    const lobe_q_scaled through = lobe_qs_positive(lobe_qs_sub(s.sine2, lobe_qs_mul(l, l)));
    const lobe_q_scaled lift = lobe_sphere_lit_line(lobe_sphere_lit_line(lobe_sphere_lit_c11, lobe_sphere_lit_c12, v),
                                                    lobe_sphere_lit_c10, s.alpha);
    const lobe_q_scaled up = lobe_qs_sub(v, lobe_qs_mul(left, lobe_qs_sub(k.off, lobe_qs_mul(through, lift))));
    const lobe_q_scaled wide = lobe_sphere_lit_line(lobe_sphere_lit_line(lobe_sphere_lit_c14, lobe_sphere_lit_c15, k.g),
                                                    lobe_sphere_lit_c16, s.alpha);
    const lobe_q_scaled lobed = lobe_qs_mul(lobe_qs_mul(lobe_qs_mul(k.r, s.alpha), k.part),
                                            lobe_sphere_lit_line(lobe_sphere_lit_c8, lobe_sphere_lit_c9, k.g));
    const lobe_q_scaled below = lobe_qs_positive(lobe_qs_sub(k.r, l));
    const lobe_q_scaled set = lobe_qs_mul(lobe_qs_mul(lobe_sphere_lit_c13, below), height);
    const lobe_q_scaled spread = lobe_qs_mul(left, lobe_qs_add(set, lobe_qs_mul(s.sine2, wide)));
    lobe_sphere_lit_q30 y;
    y.radiance = lobe_sphere_light_high_q30(roughness, light);
    y.schlick =
        lobe_sphere_schlick_end(lobe_qs_add(lobe_sphere_schlick_moved(&s, left, up), lobe_qs_add(lobed, spread)));
    return y;
}
