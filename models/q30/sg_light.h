/* What the q30 tiers of spherical Gaussian lights share. The formulas are those of ../sg_light.h and
 * ../sg_light_high.h, in numbers with a block exponent: products of a lobe's and a light's square span 2^-80 to 1. No
 * such number can overflow. */
#ifndef LOBE_Q30_SG_LIGHT_H
#define LOBE_Q30_SG_LIGHT_H
#include "sphere_light.h"
#include "../../core/q30_exp2.h"

/* The clamped light, and what every tier makes of it first; letters as in ../sg_light.h. */
typedef struct lobe_sg_fixed {
    lobe_sphere_fixed s; /* v, l, tangent2, alpha, alpha2, b; the rest is not set */
    lobe_q_scaled v, l, w, bent, off, far, lobe_g, y, n, root_v;
} lobe_sg_fixed;

/* 33954698 is the root of an alpha of 1e-3, 1074 a versine of 1e-6. */
static inline lobe_sg_fixed lobe_sg_fixed_of(int32_t roughness, lobe_sg_q30 light)
{
    const lobe_q_scaled root_alpha = lobe_qs_of(lobe_q_clamp(roughness, 33954698, LOBE_Q30_ONE), 0);
    const int32_t v = lobe_q_clamp(light.n_dot_v, 0, LOBE_Q_BELOW_ONE);
    const int32_t l = lobe_q_clamp(light.n_dot_l, -LOBE_Q_BELOW_ONE, LOBE_Q_BELOW_ONE);
    lobe_sg_fixed f;
    lobe_q_scaled across, h;
    f.s.alpha = lobe_qs_mul(root_alpha, root_alpha);
    f.s.alpha2 = lobe_qs_mul(f.s.alpha, f.s.alpha);
    f.s.b = lobe_qs_of(LOBE_Q30_ONE - lobe_qs_fixed(f.s.alpha2, 30), 0);
    f.v = lobe_qs_of(v, 0);
    f.l = lobe_qs_of(l, 0);
    f.w = lobe_qs_of(lobe_q_clamp(light.versine, 1074, LOBE_Q30_ONE), 0);
    across = lobe_qs_of(lobe_q_clamp(light.tangent2, 0, LOBE_Q30_ONE), 2);
    h = lobe_qs_of(v + l, 0);
    f.off = lobe_qs_of(v - l, 0);
    f.far = lobe_qs_add(across, lobe_qs_mul(f.off, f.off));
    f.lobe_g = lobe_qs_mul(f.s.alpha2, lobe_qs_add(across, lobe_qs_mul(h, h)));
    f.bent = lobe_qs_mul(f.s.b, across);
    f.y = lobe_qs_mul(f.s.alpha2, f.bent);
    f.n = lobe_sphere_stretched(&f.s, f.v);
    f.root_v = lobe_qs_sqrt(f.n);
    return f;
}

/* The larger of two. */
static inline lobe_q_scaled lobe_sg_larger(lobe_q_scaled x, lobe_q_scaled y) { return lobe_qs_less(x, y) ? y : x; }

#endif
