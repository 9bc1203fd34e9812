/* lobe_sg_light_high of ../sg_light_high.h in integers: its letters, and the order of its lines. */
#include "sg_light.h"
#include "../../core/dialect.h"
#include "../coeffs/sg_light_high.h"

static const lobe_q_scaled lobe_sg_high_c0 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_HIGH_C0);
static const lobe_q_scaled lobe_sg_high_c1 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_HIGH_C1);
static const lobe_q_scaled lobe_sg_high_c2 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_HIGH_C2);
static const lobe_q_scaled lobe_sg_high_c3 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_HIGH_C3);
static const lobe_q_scaled lobe_sg_high_c4 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_HIGH_C4);
static const lobe_q_scaled lobe_sg_high_c5 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_HIGH_C5);
static const lobe_q_scaled lobe_sg_high_c6 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_HIGH_C6);
static const lobe_q_scaled lobe_sg_high_c7 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_HIGH_C7);
static const lobe_q_scaled lobe_sg_high_c8 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_HIGH_C8);
static const lobe_q_scaled lobe_sg_high_c9 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_HIGH_C9);
static const lobe_q_scaled lobe_sg_high_c10 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_HIGH_C10);
static const lobe_q_scaled lobe_sg_high_c11 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_HIGH_C11);
static const lobe_q_scaled lobe_sg_high_c12 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_HIGH_C12);
static const lobe_q_scaled lobe_sg_high_c13 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_HIGH_C13);
static const lobe_q_scaled lobe_sg_high_c14 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_HIGH_C14);
static const lobe_q_scaled lobe_sg_high_c15 = LOBE_QS_CONSTANT(LOBE_SG_LIGHT_HIGH_C15);

static lobe_q_scaled lobe_sg_part_fixed(const lobe_sg_fixed *f, lobe_q_scaled widest, lobe_q_scaled count,
                                        lobe_q_scaled slope, lobe_q_scaled tail, lobe_q_scaled seen)
{
    const lobe_q_scaled aside0 = lobe_qs_add(f->lobe_g, lobe_qs_mul(lobe_sg_high_c12, widest));
    const lobe_q_scaled q0 = lobe_qs_mul(lobe_qs_add(f->s.alpha2, widest), aside0);
    const lobe_q_scaled counts = lobe_qs_div(q0, lobe_qs_add(q0, lobe_qs_mul(count, f->y)));
    const lobe_q_scaled e = lobe_qs_mul(widest, counts);
    const lobe_q_scaled aside = lobe_qs_add(f->lobe_g, lobe_qs_mul(lobe_sg_high_c12, e));
    const lobe_q_scaled q = lobe_qs_mul(lobe_qs_add(f->s.alpha2, e), aside);
    const lobe_q_scaled below = lobe_qs_add(q, lobe_qs_mul(tail, f->y));
    const lobe_q_scaled fall = lobe_qs_div(lobe_qs_mul(lobe_qs_mul(e, counts), slope), below);
    const lobe_q_scaled spread = lobe_qs_sqrt(lobe_qs_mul(lobe_qs_add(f->lobe_g, lobe_qs_mul(seen, e)), aside));
    const lobe_q_scaled t = lobe_qs_add(q, f->y);
    const lobe_q_scaled top = lobe_qs_mul(lobe_qs_mul(spread, q), lobe_qs_exp2_minus(fall));
    return lobe_qs_div(top, lobe_qs_mul(t, t));
}

/* The height of the middle of the product, with a round corner at the horizon. */
static lobe_q_scaled lobe_sg_high_height(const lobe_sg_fixed *f)
{
    const lobe_q_scaled e = lobe_qs_mul(lobe_sg_high_c1, f->w);
    const lobe_q_scaled sum = lobe_qs_add(e, f->s.alpha2);
    const lobe_q_scaled seen =
        lobe_qs_add(lobe_qs_mul(lobe_sg_high_c14, f->v), lobe_qs_mul(lobe_sg_high_c15, f->root_v));
    const lobe_q_scaled z0 = lobe_qs_div(lobe_qs_add(lobe_qs_mul(f->s.alpha2, f->l), lobe_qs_mul(e, seen)), sum);
    const lobe_q_scaled corner = lobe_qs_div(lobe_qs_mul(lobe_sg_high_c0, lobe_qs_mul(f->w, f->s.alpha2)), sum);
    const lobe_q_scaled root = lobe_qs_sqrt(lobe_qs_add(lobe_qs_mul(z0, z0), corner));
    return lobe_qs_positive(lobe_qs_shifted(lobe_qs_add(z0, root), -1));
}

lobe_scaled_q30 lobe_sg_light_high_q30(int32_t roughness, lobe_sg_q30 light)
{
    const lobe_sg_fixed f = lobe_sg_fixed_of(roughness, light);
    const lobe_q_scaled one = {LOBE_Q30_ONE / 2, 1}, none = {0, LOBE_QS_ZERO};
    const lobe_q_scaled vh = lobe_qs_add(lobe_qs_mul(lobe_sg_high_c3, f.v), lobe_qs_mul(lobe_sg_high_c4, f.root_v));
    const lobe_q_scaled seen = lobe_qs_mul(vh, vh);
    const lobe_q_scaled narrow = lobe_sg_part_fixed(&f, lobe_qs_mul(lobe_sg_high_c5, f.w), lobe_sg_high_c6,
                                                    lobe_qs_mul(lobe_sg_high_c7, f.far), lobe_sg_high_c8, seen);
    const lobe_q_scaled wide = lobe_sg_part_fixed(&f, lobe_qs_mul(lobe_sg_high_c9, f.w), lobe_sg_high_c10,
                                                  lobe_qs_mul(lobe_sg_high_c11, f.far), none, seen);
    const lobe_q_scaled sum = lobe_qs_add(narrow, lobe_qs_mul(lobe_sg_high_c13, lobe_qs_sub(wide, narrow)));
    const lobe_q_scaled z = lobe_sg_high_height(&f);
    const lobe_q_scaled m = lobe_sphere_mask_fixed(&f.s, f.v, f.root_v, z);
    const lobe_q_scaled level = lobe_qs_add(one, lobe_qs_mul(lobe_sg_high_c2, f.w));
    const lobe_q_scaled top = lobe_qs_mul(f.w, lobe_qs_mul(sum, z));
    return lobe_sphere_radiance_q30(lobe_qs_div(top, lobe_qs_mul(m, level)));
}
