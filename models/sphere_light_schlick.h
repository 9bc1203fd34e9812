/* Schlick's Fresnel for a sphere light, beside the tiers low and medium: an effective (1 - v.h)^5 in [0, 1], so that
 *   radiance (f0 + (1 - f0) schlick)
 * is the light under Schlick with reflectance f0 at normal incidence. high has its own (sphere_light_high.h).
 *
 * (v.h)^2 of the light's centre is tangent2 + ((v + l)/2)^2: a sum, no vectors. A light that fills the lobe is met
 * about the mirror direction, where v.h is n.v: the half sum moves towards the normal by the part of the lobe that the
 * light fills, and the lobe's width adds to (v.h)^2. Fitted: cases/sphere_light/README.md. */
#ifndef LOBE_SPHERE_LIGHT_SCHLICK_H
#define LOBE_SPHERE_LIGHT_SCHLICK_H
#include "sphere_light.h"
#include "coeffs/sphere_light_schlick.h"

/* (1 - x)^5 of a squared cosine, which is saturated. */
LOBE_FN lobe_real lobe_sphere_schlick_of(lobe_real cosine2)
{
    LOBE_LET x = lobe_sqrt(lobe_saturate(cosine2));
    LOBE_LET y = LOBE_R(1.0) - x;
    LOBE_LET y2 = y * y;
    LOBE_LET y5 = y2 * y2 * y;
    return y5;
}

/* (v.h)^2 of the light's centre. */
LOBE_FN lobe_real lobe_sphere_cosine2(lobe_sphere s)
{
    LOBE_LET half_height = LOBE_R(0.5) * (s.n_dot_v + s.n_dot_l);
    LOBE_LET g = s.tangent2 + half_height * half_height;
    return g;
}

/* 33 operations, some 20 more than (1 - v.h)^5 of the light's centre. */
LOBE_FN lobe_real lobe_sphere_light_schlick(LOBE_COEFFS lobe_real roughness, lobe_sphere light)
{
    lobe_sphere s = lobe_sphere_clamped(light);
    LOBE_LET v = s.n_dot_v;
    LOBE_LET r = s.sine;
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET g = lobe_sphere_cosine2(s);
    LOBE_LET off = LOBE_R(0.5) * (v - s.n_dot_l);
    LOBE_LET lobe = r * (LOBE_SPHERE_LIGHT_SCHLICK_C0 * r + LOBE_SPHERE_LIGHT_SCHLICK_C1 * a);
    LOBE_LET part = r * r / (s.tangent2 + off * off + lobe);
    LOBE_LET left = LOBE_R(1.0) - LOBE_SPHERE_LIGHT_SCHLICK_C2 * part;
    LOBE_LET up = v - left * off;
    LOBE_LET wide = r * a * part * (LOBE_SPHERE_LIGHT_SCHLICK_C3 + LOBE_SPHERE_LIGHT_SCHLICK_C4 * g);
    LOBE_LET q = s.tangent2 * (left * left) + up * up + wide;
    return lobe_sphere_schlick_of(q);
}

#endif
