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
static const lobe_q_scaled lobe_sg_medium_c6 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_MEDIUM_C6);

/* Height and mask of the middle of the product have the factor along. */
static lobe_q_scaled lobe_sg_medium_mask(const lobe_sg_fixed *f, lobe_q_scaled along, lobe_q_scaled z)
{
    const lobe_q_scaled flat = lobe_qs_mul(f->s.alpha2, lobe_qs_mul(along, along));
    const lobe_q_scaled root_z = lobe_qs_sqrt(lobe_qs_add(flat, lobe_qs_mul(f->s.b, lobe_qs_mul(z, z))));
    return lobe_qs_add(lobe_qs_mul(z, f->root_v), lobe_qs_mul(f->v, root_z));
}

lobe_scaled_q30 lobe_sg_light_medium_q30(int32_t roughness, lobe_sg_q30 light)
{
    const lobe_sg_fixed f = lobe_sg_fixed_of(roughness, light);
    const lobe_q_scaled widest = lobe_qs_mul(lobe_sg_medium_c0, f.w);
    const lobe_q_scaled aside0 = lobe_qs_add(f.lobe_g, lobe_qs_mul(lobe_sg_medium_c1, widest));
    const lobe_q_scaled counts = lobe_qs_div(aside0, lobe_qs_add(aside0, lobe_qs_mul(lobe_sg_medium_c2, f.bent)));
    const lobe_q_scaled e = lobe_qs_mul(widest, counts);
    const lobe_q_scaled along = lobe_qs_add(f.s.alpha2, e);
    const lobe_q_scaled aside = lobe_qs_add(f.lobe_g, lobe_qs_mul(lobe_sg_medium_c1, e));
    const lobe_q_scaled q = lobe_qs_mul(along, aside);
    const lobe_q_scaled x = lobe_qs_mul(lobe_qs_mul(e, counts), f.far);
    const lobe_q_scaled t = lobe_qs_add(lobe_qs_add(q, f.y), lobe_qs_mul(lobe_sg_medium_c3, x));
    const lobe_q_scaled v2 = lobe_qs_mul(f.v, f.v);
    const lobe_q_scaled seen = lobe_qs_add(lobe_qs_mul(lobe_sg_medium_c4, v2), lobe_qs_mul(lobe_sg_medium_c5, f.n));
    const lobe_q_scaled spread = lobe_qs_sqrt(lobe_qs_mul(lobe_qs_add(f.lobe_g, lobe_qs_mul(seen, e)), aside));
    const lobe_q_scaled middle = lobe_qs_add(lobe_qs_mul(f.s.alpha2, f.l), lobe_qs_mul(e, f.v));
    const lobe_q_scaled z = lobe_sg_larger(middle, lobe_qs_mul(lobe_sg_medium_c6, lobe_qs_mul(f.w, along)));
    const lobe_q_scaled m = lobe_sg_medium_mask(&f, along, z);
    const lobe_q_scaled fall = lobe_qs_exp2_minus(lobe_qs_div(x, q));
    const lobe_q_scaled top = lobe_qs_mul(lobe_qs_mul(f.w, lobe_qs_mul(spread, q)), lobe_qs_mul(z, fall));
    return lobe_sphere_radiance_q30(lobe_qs_div(top, lobe_qs_mul(lobe_qs_mul(t, t), m)));
}
