/* lobe_sg_diffuse_high of ../sg_diffuse.h in integers: its letters, and the order of its lines. A narrow light's
 * versine and its inverse span 2^-20 to 2^20, hence the block exponents; nothing can overflow. */
#include "../lobe.h"
#include "../../core/dialect.h"
#include "../../core/q30_exp2.h"
#include "../coeffs/sg_diffuse_high.h"

static const lobe_q_scaled lobe_sg_diffuse_c0 = LOBE_QS_CONSTANT(LOBE_SG_DIFFUSE_HIGH_C0);
static const lobe_q_scaled lobe_sg_diffuse_c1 = LOBE_QS_CONSTANT(LOBE_SG_DIFFUSE_HIGH_C1);
static const lobe_q_scaled lobe_sg_diffuse_c2 = LOBE_QS_CONSTANT(LOBE_SG_DIFFUSE_HIGH_C2);
static const lobe_q_scaled lobe_sg_diffuse_c3 = LOBE_QS_CONSTANT(LOBE_SG_DIFFUSE_HIGH_C3);
static const lobe_q_scaled lobe_sg_diffuse_back = LOBE_QS_CONSTANT(2.88539008);
static const lobe_q_scaled lobe_sg_diffuse_quarter_turn = LOBE_QS_CONSTANT(1.57079633);

/* 1074 is a versine of 1e-6; the largest, 2 - 2^-30, is what the format has. */
lobe_scaled_q30 lobe_sg_diffuse_high_q30(int32_t n_dot_l, int32_t versine)
{
    const lobe_q_scaled one = {LOBE_Q30_ONE / 2, 1};
    const lobe_q_scaled c = lobe_qs_of(lobe_q_clamp(n_dot_l, -LOBE_Q30_ONE, LOBE_Q30_ONE), 0);
    const lobe_q_scaled w = lobe_qs_of(lobe_q_clamp(versine, 1074, 0x7ffffffe), 0);
    const lobe_q_scaled sharp = lobe_qs_div(one, w);
    const lobe_q_scaled behind = lobe_qs_exp2_minus(lobe_qs_mul(lobe_sg_diffuse_back, sharp));
    const lobe_q_scaled whole = lobe_qs_sub(one, behind);
    const lobe_q_scaled ac = lobe_qs_mul(c, lobe_qs_sub(lobe_qs_add(one, behind), lobe_qs_mul(whole, w)));
    const lobe_q_scaled below = lobe_qs_add(lobe_qs_mul(w, lobe_qs_add(lobe_qs_shifted(w, 2), lobe_sg_diffuse_c1)),
                                            lobe_qs_mul(lobe_sg_diffuse_quarter_turn, lobe_sg_diffuse_c0));
    const lobe_q_scaled even = lobe_qs_div(lobe_qs_mul(w, lobe_qs_add(w, lobe_sg_diffuse_c0)), below);
    const lobe_q_scaled fall = lobe_qs_div(lobe_qs_mul(lobe_qs_mul(lobe_sg_diffuse_c2, lobe_qs_mul(c, c)), sharp),
                                           lobe_qs_add(one, lobe_qs_mul(lobe_sg_diffuse_c3, w)));
    const lobe_q_scaled spread = lobe_qs_mul(lobe_qs_mul(whole, whole), lobe_qs_mul(even, lobe_qs_exp2_minus(fall)));
    const lobe_q_scaled root = lobe_qs_sqrt(lobe_qs_add(lobe_qs_mul(ac, ac), spread));
    const lobe_q_scaled y = lobe_qs_mul(w, lobe_qs_add(ac, root));
    lobe_scaled_q30 out;
    out.mantissa = y.m > 0 ? y.m : 0;
    out.exponent = y.m > 0 ? y.e : 0;
    return out;
}
