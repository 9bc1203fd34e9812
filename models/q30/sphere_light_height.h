/* How high the lit part of a light stands in ../sphere_light_high.h, in integers: where its masking is taken, and what
 * its Fresnel needs of it. */
#ifndef LOBE_Q30_SPHERE_LIGHT_HEIGHT_H
#define LOBE_Q30_SPHERE_LIGHT_HEIGHT_H
#include "sphere_light.h"
#include "../../core/dialect.h"
#include "../coeffs/sphere_light_high.h"

static const int32_t lobe_sphere_high_c0 = LOBE_Q_CONSTANT(LOBE_SPHERE_LIGHT_HIGH_C0, 28);
static const int32_t lobe_sphere_high_c1 = LOBE_Q_CONSTANT(LOBE_SPHERE_LIGHT_HIGH_C1, 28);
static const int32_t lobe_sphere_high_c2 = LOBE_Q_CONSTANT(LOBE_SPHERE_LIGHT_HIGH_C2, 28);
static const int32_t lobe_sphere_high_c3 = LOBE_Q_CONSTANT(LOBE_SPHERE_LIGHT_HIGH_C3, 28);
static const int32_t lobe_sphere_high_c4 = LOBE_Q_CONSTANT(LOBE_SPHERE_LIGHT_HIGH_C4, 28);

/* The height of the lit part, Q29 in [0, 2): the light's, moved, with a round corner at the horizon. */
static inline int32_t lobe_sphere_high_height(const lobe_sphere_fixed *s)
{
    const int32_t two = (int32_t)1 << 29; /* Q28 */
    const int32_t alpha = lobe_qs_fixed(s->alpha, 30);
    const int32_t s2 = lobe_q_mul(s->r, s->r, 30);
    const int32_t move = lobe_q_mul(lobe_sphere_high_c1, s->v, 30) + lobe_sphere_high_c2 +
                         lobe_q_mul(lobe_sphere_high_c3, s->l, 30); /* Q28: the three are under 8 together */
    const int32_t z0 = (s->l >> 1) + lobe_q_mul(s2, lobe_q_clamp(move, -two, two), 29); /* Q29, under 3 */
    const int32_t wide = lobe_q_mul(lobe_sphere_high_c0, s->r, 30) + ((int32_t)1 << 28) +
                         lobe_q_mul(lobe_sphere_high_c4, alpha, 30);                       /* Q28 */
    const int32_t width = lobe_q_max(lobe_q_mul(s->r, lobe_q_clamp(wide, 0, two), 29), 1); /* Q29, up to 2 */
    int32_t z = z0;
    if (z0 <= -width)
        return 0;
    if (z0 < width) {                                                                   /* (z0 + width)^2 / (4 width) */
        const int32_t part = lobe_q_ratio((z0 + width) >> 1, lobe_q_reciprocal(width)); /* Q30, up to 1 */
        z = lobe_q_mul(lobe_q_mul(part, part, 30), width, 30);
    }
    return lobe_q_min(z, LOBE_Q_BELOW_ONE);
}

#endif
