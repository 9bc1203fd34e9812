/* What the q30 tiers of sphere lights share: the clamped light and what every formula makes of it first.
 *
 * The formulas are those of ../sphere_light.h and ../sphere_light_high.h. They are written in numbers with a block
 * exponent (core/q30_scaled.h): the square of a lobe, or of a light, of a hundredth of a degree is under 2^-24, and the
 * formulas multiply several. No such number can overflow. What is plain fixed point has its scale beside it: "Q29" is a
 * number with 29 fractional bits. */
#ifndef LOBE_Q30_SPHERE_LIGHT_H
#define LOBE_Q30_SPHERE_LIGHT_H
#include "../lobe.h"
#include "../../core/q30_scaled.h"

/* 1 - 2^-30: heights are held below 1, so that v + l and v - l fit in 32 bits. */
#define LOBE_Q_BELOW_ONE (LOBE_Q30_ONE - 1)

typedef struct lobe_sphere_fixed {
    int32_t v, l;                 /* Q30, |.| < 1 */
    int32_t r;                    /* sine, Q30, in [1e-5, 1] */
    int32_t tangent2;             /* Q30; across, the squared tangential part of v + l, is four times that */
    int32_t cosine;               /* of the half angle, Q30, in [0, 1] */
    lobe_q_scaled alpha, alpha2;  /* at least 1e-3 and 1e-6 */
    lobe_q_scaled b;              /* 1 - alpha2 */
    lobe_q_scaled sine2, versine; /* at least 1e-10 and 5e-11 */
} lobe_sphere_fixed;

/* No input is out of range after the clamps: 33954698 is the root of 1e-3, 10737 is 1e-5. cos^2 = (1 - r)(1 + r) and
 * versine = r^2 / (1 + cos) keep their digits at both ends. */
static inline lobe_sphere_fixed lobe_sphere_fixed_of(int32_t roughness, lobe_sphere_q30 light)
{
    const int32_t rough = lobe_q_clamp(roughness, 33954698, LOBE_Q30_ONE);
    const lobe_q_scaled root_alpha = lobe_qs_of(rough, 0);
    lobe_q_scaled sine, cosine, under, over;
    lobe_sphere_fixed s;
    s.v = lobe_q_clamp(light.n_dot_v, 0, LOBE_Q_BELOW_ONE);
    s.l = lobe_q_clamp(light.n_dot_l, -LOBE_Q_BELOW_ONE, LOBE_Q_BELOW_ONE);
    s.r = lobe_q_clamp(light.sine, 10737, LOBE_Q30_ONE);
    s.tangent2 = lobe_q_clamp(light.tangent2, 0, LOBE_Q30_ONE);
    s.alpha = lobe_qs_mul(root_alpha, root_alpha);
    s.alpha2 = lobe_qs_mul(s.alpha, s.alpha);
    s.b = lobe_qs_of(LOBE_Q30_ONE - lobe_qs_fixed(s.alpha2, 30), 0);
    sine = lobe_qs_of(s.r, 0);
    s.sine2 = lobe_qs_mul(sine, sine);
    under = lobe_qs_of(LOBE_Q30_ONE - s.r, 0);
    over = lobe_qs_of((int32_t)(((uint32_t)LOBE_Q30_ONE + (uint32_t)s.r) >> 1), 1);
    cosine = lobe_qs_sqrt(lobe_qs_mul(under, over));
    s.cosine = lobe_qs_fixed(cosine, 30);
    s.versine = lobe_qs_div(s.sine2, lobe_qs_of((int32_t)(((uint32_t)LOBE_Q30_ONE + (uint32_t)s.cosine) >> 1), 1));
    return s;
}

/* a2 + b z^2 */
static inline lobe_q_scaled lobe_sphere_stretched(const lobe_sphere_fixed *s, lobe_q_scaled z)
{
    return lobe_qs_add(s->alpha2, lobe_qs_mul(s->b, lobe_qs_mul(z, z)));
}

/* The denominator of correlated masking, z root(v) + v root(z): root_v the root of the stretched v. */
static inline lobe_q_scaled lobe_sphere_mask_fixed(const lobe_sphere_fixed *s, lobe_q_scaled v, lobe_q_scaled root_v,
                                                   lobe_q_scaled z)
{
    const lobe_q_scaled root_z = lobe_qs_sqrt(lobe_sphere_stretched(s, z));
    return lobe_qs_add(lobe_qs_mul(z, root_v), lobe_qs_mul(v, root_z));
}

/* max(l, c0 l + c1 r, 0), how high the lit part stands: Q29, under 2. c0 and c1 are Q28, in [-1, 1]. */
static inline int32_t lobe_sphere_height_fixed(const lobe_sphere_fixed *s, int32_t c0, int32_t c1)
{
    const int32_t one = (int32_t)1 << 28; /* Q28 */
    const int32_t limb =
        lobe_q_mul(lobe_q_clamp(c0, -one, one), s->l, 29) + lobe_q_mul(lobe_q_clamp(c1, -one, one), s->r, 29);
    return lobe_q_clamp(lobe_q_max(s->l >> 1, limb), 0, LOBE_Q_BELOW_ONE);
}

/* To the public type, where 0 has the exponent 0; below 0 counts as 0. */
static inline lobe_scaled_q30 lobe_sphere_result_q30(lobe_q_scaled y)
{
    lobe_scaled_q30 out;
    out.mantissa = y.m > 0 ? y.m : 0;
    out.exponent = y.m > 0 ? y.e : 0;
    return out;
}

/* The same for a radiance, which is at most 1. */
static inline lobe_scaled_q30 lobe_sphere_radiance_q30(lobe_q_scaled y)
{
    return lobe_sphere_result_q30(y.m > 0 && y.e > 0 ? lobe_qs_of(LOBE_Q30_ONE, 0) : y);
}

#endif
