/* The ends of Schlick inside a sphere light in integers, which both forms share. */
#ifndef LOBE_Q30_SPHERE_LIGHT_SCHLICK_H
#define LOBE_Q30_SPHERE_LIGHT_SCHLICK_H
#include "sphere_light.h"

/* What both begin with: (v.h)^2 of the light's centre, half the difference of the heights, r^2, and the part of the
 * lobe that the light fills. */
typedef struct lobe_sphere_schlick_fixed {
    lobe_q_scaled g, off, r, r2, part;
} lobe_sphere_schlick_fixed;

static inline lobe_sphere_schlick_fixed lobe_sphere_schlick_begin(const lobe_sphere_fixed *s, lobe_q_scaled wide,
                                                                  lobe_q_scaled rough)
{
    const lobe_q_scaled tangent2 = lobe_qs_of(s->tangent2, 0), half_height = lobe_qs_of(s->v + s->l, -1);
    lobe_sphere_schlick_fixed y;
    lobe_q_scaled lobe, far;
    y.g = lobe_qs_add(tangent2, lobe_qs_mul(half_height, half_height));
    y.off = lobe_qs_of(s->v - s->l, -1);
    y.r = lobe_qs_of(s->r, 0);
    y.r2 = s->sine2;
    lobe = lobe_qs_add(lobe_qs_mul(wide, s->sine2), lobe_qs_mul(rough, lobe_qs_mul(y.r, s->alpha)));
    far = lobe_qs_add(tangent2, lobe_qs_mul(y.off, y.off));
    y.part = lobe_qs_div(s->sine2, lobe_qs_add(far, lobe));
    return y;
}

/* tangent2 left^2 + up^2 */
static inline lobe_q_scaled lobe_sphere_schlick_moved(const lobe_sphere_fixed *s, lobe_q_scaled left, lobe_q_scaled up)
{
    return lobe_qs_add(lobe_qs_mul(lobe_qs_of(s->tangent2, 0), lobe_qs_mul(left, left)), lobe_qs_mul(up, up));
}

/* (1 - x)^5 of x^2, which is held at [0, 1]: Q30. */
static inline int32_t lobe_sphere_schlick_end(lobe_q_scaled cosine2)
{
    const int32_t x = lobe_q_clamp(lobe_qs_fixed(lobe_qs_sqrt(cosine2), 30), 0, LOBE_Q30_ONE);
    const int32_t y = LOBE_Q30_ONE - x, y2 = lobe_q_mul(y, y, 30);
    return lobe_q_mul(lobe_q_mul(y2, y2, 30), y, 30);
}

#endif
