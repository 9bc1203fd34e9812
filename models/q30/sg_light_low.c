/* lobe_sg_light_low of ../sg_light.h in integers: its letters, and the order of its lines. */
#include "sg_light.h"
#include "../../core/dialect.h"
#include "../coeffs/sg_light_low.h"

static const lobe_q_scaled lobe_sg_low_c0 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_LOW_C0);
static const lobe_q_scaled lobe_sg_low_c1 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_LOW_C1);
static const lobe_q_scaled lobe_sg_low_c2 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_LOW_C2);
static const lobe_q_scaled lobe_sg_low_c3 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_LOW_C3);
static const lobe_q_scaled lobe_sg_low_c4 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_LOW_C4);
static const lobe_q_scaled lobe_sg_low_c5 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_LOW_C5);
static const lobe_q_scaled lobe_sg_low_c6 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_LOW_C6);
static const lobe_q_scaled lobe_sg_low_c7 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_LOW_C7);

lobe_scaled_q30 lobe_sg_light_low_q30(int32_t roughness, lobe_sg_q30 light)
{
    const lobe_sg_fixed f = lobe_sg_fixed_of(roughness, light);
    const lobe_q_scaled x = lobe_qs_mul(f.w, f.far);
    const lobe_q_scaled along = lobe_qs_add(f.s.alpha2, lobe_qs_mul(lobe_sg_low_c0, f.w));
    const lobe_q_scaled q = lobe_qs_mul(along, lobe_qs_add(f.lobe_g, lobe_qs_mul(lobe_sg_low_c1, f.w)));
    const lobe_q_scaled t = lobe_qs_add(lobe_qs_add(q, f.y), lobe_qs_mul(lobe_sg_low_c2, x));
    const lobe_q_scaled u = lobe_qs_add(q, lobe_qs_mul(lobe_sg_low_c3, x));
    const lobe_q_scaled seen = lobe_qs_add(lobe_qs_mul(lobe_sg_low_c4, f.v), lobe_qs_mul(lobe_sg_low_c5, f.root_v));
    const lobe_q_scaled spread = lobe_qs_add(f.lobe_g, lobe_qs_mul(f.w, seen));
    const lobe_q_scaled leant = lobe_qs_add(f.l, lobe_qs_mul(lobe_sg_low_c6, lobe_qs_mul(f.w, f.off)));
    const lobe_q_scaled z = lobe_sg_larger(leant, lobe_qs_mul(lobe_sg_low_c7, f.w));
    const lobe_q_scaled m = lobe_sphere_mask_fixed(&f.s, f.v, f.root_v, z);
    const lobe_q_scaled top = lobe_qs_mul(lobe_qs_mul(f.w, lobe_qs_mul(spread, z)), lobe_qs_mul(q, q));
    return lobe_sphere_radiance_q30(lobe_qs_div(top, lobe_qs_mul(lobe_qs_mul(t, t), lobe_qs_mul(m, u))));
}
