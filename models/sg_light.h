/* Lights that are spherical Gaussians, exp((l.axis - 1) / versine) of amplitude 1, under GGX with height-correlated
 * Smith, F = 1; a tier returns the reflected radiance. lobe_sg is what the light is, seen from the point:
 *   n_dot_v, n_dot_l  heights of view and of the axis; v in [0, 1], l in [-1, 1]
 *   tangent2          squared length of the part of (v + axis)/2 along the surface, in [0, 1], as in sphere_light.h
 *   versine           1 / sharpness, in (0, 1]: the mean of 1 - l.axis over the light, whose irradiance at normal
 *                     incidence is 2 pi versine, as that of a sphere light of this versine is
 * Each kernel clamps them; NaN counts as the lower end. As the light shrinks every tier tends to
 * lobe_sphere_light_punctual.
 *
 * GGX is a sum of Gaussians of half vectors, exactly: D is the integral over t of t exp(-t) exp(-t b T / a2) / (pi a2),
 * a2 = alpha^2, b = 1 - a2, T = 1 - (n.h)^2. About the axis the light is one too: exp(-((d.h)^2 + (v.h)^2 (m.h)^2) 2 /
 * versine), d along v - axis, m along v x axis. The product of the two has a closed integral, in which d and m occur
 * only as |v + axis| and as the distance from the axis to the mirror direction, so that view = axis is no exception.
 * What is left is the sum over t: its Gaussian of the light's own distance is taken at one t (medium) or at two (high),
 * what makes D of Gaussians is summed exactly. Derived in cases/sg_light/README.md. */
#ifndef LOBE_SG_LIGHT_H
#define LOBE_SG_LIGHT_H
#include "../core/exp2.h"
#include "coeffs/sg_light_medium.h"
#include "sphere_light.h"

LOBE_STRUCT(lobe_sg)
{
    lobe_real n_dot_v;
    lobe_real n_dot_l;
    lobe_real tangent2;
    lobe_real versine;
};

LOBE_FN lobe_sg lobe_sg_clamped(lobe_sg s)
{
    lobe_sg y;
    y.n_dot_v = lobe_saturate(s.n_dot_v);
    y.n_dot_l = lobe_clamp(s.n_dot_l, LOBE_R(-1.0), LOBE_R(1.0));
    y.tangent2 = lobe_clamp(s.tangent2, LOBE_R(0.0), LOBE_R(1.0));
    y.versine = lobe_clamp(s.versine, LOBE_R(1e-6), LOBE_R(1.0));
    return y;
}

/* A light from its four numbers. */
LOBE_FN lobe_sg lobe_sg_of(lobe_real n_dot_v, lobe_real n_dot_l, lobe_real tangent2, lobe_real versine)
{
    lobe_sg y;
    y.n_dot_v = n_dot_v;
    y.n_dot_l = n_dot_l;
    y.tangent2 = tangent2;
    y.versine = versine;
    return y;
}

/* One t. Lengths along d and m, the offset and the exponent have the common factor that makes them short. */
LOBE_FN lobe_real lobe_sg_light_medium(LOBE_COEFFS lobe_real roughness, lobe_sg light)
{
    lobe_sg s = lobe_sg_clamped(light);
    LOBE_LET across = LOBE_R(4.0) * s.tangent2; /* of v + axis */
    LOBE_LET v = s.n_dot_v;
    LOBE_LET l = s.n_dot_l;
    LOBE_LET w = s.versine;
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET a2 = a * a;
    LOBE_LET b = LOBE_R(1.0) - a2;
    LOBE_LET h = v + l;
    LOBE_LET off = v - l;
    LOBE_LET g = across + h * h;       /* |v + axis|^2 */
    LOBE_LET far = across + off * off; /* |mirror direction - axis|^2 */
    LOBE_LET e = LOBE_SG_LIGHT_MEDIUM_C0 * w;
    LOBE_LET lobe = a2 + a2;
    LOBE_LET lobe_g = a2 * g;
    LOBE_LET along = e + lobe;
    LOBE_LET aside = e + e + lobe_g;
    LOBE_LET q = along * aside;
    LOBE_LET y = lobe * (b * across);
    LOBE_LET fall = LOBE_SG_LIGHT_MEDIUM_C1 * (w * far) / (q + LOBE_SG_LIGHT_MEDIUM_C2 * y);
    LOBE_LET v2 = v * v;
    LOBE_LET n = a2 + b * v2;
    LOBE_LET root_v = lobe_sqrt(n);
    LOBE_LET seen = LOBE_SG_LIGHT_MEDIUM_C3 * v2 + LOBE_SG_LIGHT_MEDIUM_C4 * n; /* 2 (v.h)^2 of the lobe's middle */
    LOBE_LET spread = lobe_sqrt((lobe_g + seen * e) * aside);
    LOBE_LET z = lobe_max((lobe * l + e * v) / along, LOBE_SG_LIGHT_MEDIUM_C5 * w);
    LOBE_LET m = lobe_sphere_mask(a2, b, v, root_v, z);
    LOBE_LET t = q + y;
    LOBE_LET top = (w + w) * (spread * q) * (z * lobe_exp2(-fall));
    LOBE_LET radiance = lobe_saturate(top / (t * t * m + LOBE_R(1e-36)));
    return radiance;
}

#endif
