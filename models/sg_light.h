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
 * and that t is the one that counts in this place, the smaller the farther out; what makes D of Gaussians is summed
 * exactly. low puts powers for the Gaussians. Derived in cases/sg_light/README.md. */
#ifndef LOBE_SG_LIGHT_H
#define LOBE_SG_LIGHT_H
#include "../core/exp2.h"
#include "coeffs/sg_light_low.h"
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

/* Neither exponential nor root but those of the mask: what the light's distance to the mirror direction costs is added
 * to the offset, and takes a third power of its own. */
LOBE_FN lobe_real lobe_sg_light_low(LOBE_COEFFS lobe_real roughness, lobe_sg light)
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
    LOBE_LET lobe_g = a2 * (across + h * h); /* of |v + axis|^2 */
    LOBE_LET x = w * (across + off * off);   /* of |mirror direction - axis|^2 */
    LOBE_LET q = (a2 + LOBE_SG_LIGHT_LOW_C0 * w) * (lobe_g + LOBE_SG_LIGHT_LOW_C1 * w);
    LOBE_LET t = q + a2 * (b * across) + LOBE_SG_LIGHT_LOW_C2 * x;
    LOBE_LET u = q + LOBE_SG_LIGHT_LOW_C3 * x;
    LOBE_LET root_v = lobe_sqrt(a2 + b * (v * v));
    LOBE_LET spread = lobe_g + w * (LOBE_SG_LIGHT_LOW_C4 * v + LOBE_SG_LIGHT_LOW_C5 * root_v);
    LOBE_LET z = lobe_max(l + LOBE_SG_LIGHT_LOW_C6 * (w * off), LOBE_SG_LIGHT_LOW_C7 * w);
    LOBE_LET m = lobe_sphere_mask(a2, b, v, root_v, z);
    LOBE_LET top = w * (spread * z) * (q * q);
    LOBE_LET radiance = lobe_saturate(top / (t * t * (m * u) + LOBE_R(1e-36)));
    return radiance;
}

/* One t. Lengths along d and m, the offset and the exponent have the common factor that makes them short; so have the
 * height z and the mask m, by along. */
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
    LOBE_LET far = across + off * off;       /* |mirror direction - axis|^2 */
    LOBE_LET lobe_g = a2 * (across + h * h); /* of |v + axis|^2 */
    LOBE_LET bent = b * across;
    LOBE_LET widest = LOBE_SG_LIGHT_MEDIUM_C0 * w;
    LOBE_LET aside0 = lobe_g + LOBE_SG_LIGHT_MEDIUM_C1 * widest;
    LOBE_LET counts = aside0 / (aside0 + LOBE_SG_LIGHT_MEDIUM_C2 * bent); /* the t that counts */
    LOBE_LET e = widest * counts;
    LOBE_LET along = a2 + e;
    LOBE_LET aside = lobe_g + LOBE_SG_LIGHT_MEDIUM_C1 * e;
    LOBE_LET q = along * aside;
    LOBE_LET x = e * counts * far;
    LOBE_LET t = q + a2 * bent + LOBE_SG_LIGHT_MEDIUM_C3 * x;
    LOBE_LET v2 = v * v;
    LOBE_LET n = a2 + b * v2;
    LOBE_LET root_v = lobe_sqrt(n);
    LOBE_LET seen = LOBE_SG_LIGHT_MEDIUM_C4 * v2 + LOBE_SG_LIGHT_MEDIUM_C5 * n; /* (v.h)^2 of the lobe's middle */
    LOBE_LET spread = lobe_sqrt((lobe_g + seen * e) * aside);
    LOBE_LET z = lobe_max(a2 * l + e * v, LOBE_SG_LIGHT_MEDIUM_C6 * (w * along));
    LOBE_LET m = z * root_v + v * lobe_sqrt(a2 * (along * along) + b * (z * z));
    LOBE_LET top = w * (spread * q) * (z * lobe_exp2(-(x / q)));
    LOBE_LET radiance = lobe_saturate(top / (t * t * m + LOBE_R(1e-36)));
    return radiance;
}

#endif
