/* Cheaper ways to Schlick's Fresnel than those that ship (models/sphere_light_schlick.h, sphere_light_high.h): that of
 * the light's centre, which every engine takes; and five operations more, without a division, which tend to it as r,
 * not as r^2. Of quick the coefficients are from the exploration, for the tiers low and medium of that time. */
#ifndef LOBE_SPHERE_LIGHT_PEERS_SCHLICK_H
#define LOBE_SPHERE_LIGHT_PEERS_SCHLICK_H
#include "../../models/sphere_light_schlick.h"

LOBE_FN lobe_real lobe_peer_schlick_centre(lobe_real roughness, lobe_sphere light)
{
    lobe_sphere s = lobe_sphere_clamped(light);
    (void)roughness;
    return lobe_sphere_schlick_of(lobe_sphere_cosine2(s));
}

LOBE_FN lobe_real lobe_peer_schlick_quick(lobe_real roughness, lobe_sphere light)
{
    lobe_sphere s = lobe_sphere_clamped(light);
    LOBE_LET v = s.n_dot_v;
    LOBE_LET r = s.sine;
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET g = lobe_sphere_cosine2(s);
    LOBE_LET wide = r * (LOBE_R(0.0110470965) + LOBE_R(0.28010191) * a);
    LOBE_LET q = g + r * (LOBE_R(0.942749386) * (v * v) + LOBE_R(-1.15084549) * g + wide);
    return lobe_sphere_schlick_of(q);
}

#endif
