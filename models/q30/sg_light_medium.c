/* lobe_sg_light_medium of ../sg_light.h in integers: its letters, and the order of its lines. */
#include "sg_light.h"
#include "../../core/dialect.h"
#include "../coeffs/sg_light_medium.h"

static const lobe_q_scaled lobe_sg_medium_c0 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_MEDIUM_C0);
static const lobe_q_scaled lobe_sg_medium_c1 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_MEDIUM_C1);
static const lobe_q_scaled lobe_sg_medium_c2 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_MEDIUM_C2);
static const lobe_q_scaled lobe_sg_medium_c3 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_MEDIUM_C3);
static const lobe_q_scaled lobe_sg_medium_c4 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_MEDIUM_C4);
static const lobe_q_scaled lobe_sg_medium_c5 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_MEDIUM_C5);

lobe_scaled_q30 lobe_sg_light_medium_q30(int32_t roughness, lobe_sg_q30 light)
{
    const lobe_sg_fixed f = lobe_sg_fixed_of(roughness, light);
    const lobe_q_scaled e = lobe_qs_mul(lobe_sg_medium_c0, f.w);
    const lobe_q_scaled along = lobe_qs_add(e, f.lobe);
    const lobe_q_scaled aside = lobe_qs_add(lobe_qs_shifted(e, 1), f.lobe_g);
    const lobe_q_scaled q = lobe_qs_mul(along, aside);
    const lobe_q_scaled tail = lobe_qs_add(q, lobe_qs_mul(lobe_sg_medium_c2, f.y));
    const lobe_q_scaled fall = lobe_qs_div(lobe_qs_mul(lobe_sg_medium_c1, lobe_qs_mul(f.w, f.far)), tail);
    const lobe_q_scaled v2 = lobe_qs_mul(f.v, f.v);
    const lobe_q_scaled seen = lobe_qs_add(lobe_qs_mul(lobe_sg_medium_c3, v2), lobe_qs_mul(lobe_sg_medium_c4, f.n));
    const lobe_q_scaled spread = lobe_qs_sqrt(lobe_qs_mul(lobe_qs_add(f.lobe_g, lobe_qs_mul(seen, e)), aside));
    const lobe_q_scaled middle = lobe_qs_div(lobe_qs_add(lobe_qs_mul(f.lobe, f.l), lobe_qs_mul(e, f.v)), along);
    const lobe_q_scaled least = lobe_qs_mul(lobe_sg_medium_c5, f.w);
    const lobe_q_scaled z = lobe_qs_less(middle, least) ? least : middle;
    const lobe_q_scaled m = lobe_sphere_mask_fixed(&f.s, f.v, f.root_v, z);
    const lobe_q_scaled t = lobe_qs_add(q, f.y);
    const lobe_q_scaled top = lobe_qs_mul(lobe_qs_mul(lobe_qs_shifted(f.w, 1), lobe_qs_mul(spread, q)),
                                          lobe_qs_mul(z, lobe_qs_exp2_minus(fall)));
    return lobe_sphere_radiance_q30(lobe_qs_div(top, lobe_qs_mul(lobe_qs_mul(t, t), m)));
}
