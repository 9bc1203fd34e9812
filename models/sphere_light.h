/* Sphere lights: the input of every tier, the punctual light they tend to, and the tiers low and medium.
 *
 * The light is a sphere of radiance 1 under GGX with height-correlated Smith, F = 1; a tier returns the reflected
 * radiance. lobe_sphere is what the light is, seen from the point:
 *   n_dot_v, n_dot_l  heights of view and of the light's centre; v in [0, 1], l in [-1, 1]
 *   tangent2          squared length of the part of (v + l)/2 along the surface, in [0, 1]: what tells an alpha of
 *                     1e-3 from a mirror; 2 + 2 v.l - (n.v + n.l)^2 loses it to rounding
 *   sine, versine     sin and 1 - cos of the half angle, in [0, 1]; 1 - cos as sin^2 / (1 + cos), never 1 - cos
 * Each kernel clamps them; NaN counts as the lower end. */
#ifndef LOBE_SPHERE_LIGHT_H
#define LOBE_SPHERE_LIGHT_H
#include "../core/sqrt.h"
#include "coeffs/sphere_light_low.h"
#include "coeffs/sphere_light_medium.h"

LOBE_STRUCT(lobe_sphere)
{
    lobe_real n_dot_v;
    lobe_real n_dot_l;
    lobe_real tangent2;
    lobe_real sine;
    lobe_real versine;
};

LOBE_FN lobe_sphere lobe_sphere_clamped(lobe_sphere s)
{
    lobe_sphere y;
    y.n_dot_v = lobe_saturate(s.n_dot_v);
    y.n_dot_l = lobe_clamp(s.n_dot_l, LOBE_R(-1.0), LOBE_R(1.0));
    y.tangent2 = lobe_clamp(s.tangent2, LOBE_R(0.0), LOBE_R(1.0));
    y.sine = lobe_clamp(s.sine, LOBE_R(1e-5), LOBE_R(1.0));
    y.versine = lobe_clamp(s.versine, LOBE_R(5e-11), LOBE_R(1.0));
    return y;
}

/* alpha of a perceptual roughness, at least 1e-3. */
LOBE_FN lobe_real lobe_sphere_alpha(lobe_real roughness)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET a = lobe_max(r * r, LOBE_R(1e-3));
    return a;
}

/* The denominator of correlated masking at height z: z root(v) + v root(z). */
LOBE_FN lobe_real lobe_sphere_mask(lobe_real a2, lobe_real b, lobe_real v, lobe_real root_v, lobe_real z)
{
    LOBE_LET root_z = lobe_sqrt(a2 + b * (z * z));
    LOBE_LET y = z * root_v + v * root_z;
    return y;
}

/* max(z, 0) with a round corner between -w and w, exactly 0 below -w: how far a disc stands above the horizon. */
LOBE_FN lobe_real lobe_sphere_risen(lobe_real z, lobe_real w)
{
    LOBE_LET t = lobe_clamp(z + w, LOBE_R(0.0), w + w);
    LOBE_LET y = LOBE_R(0.25) * (t * t) / w + lobe_max(z - w, LOBE_R(0.0));
    return y;
}

/* A light from its four numbers. */
LOBE_FN lobe_sphere lobe_sphere_of(lobe_real n_dot_v, lobe_real n_dot_l, lobe_real tangent2, lobe_real sine)
{
    LOBE_LET s = lobe_saturate(sine);
    LOBE_LET s2 = s * s;
    LOBE_LET versine = s2 / (LOBE_R(1.0) + lobe_sqrt(LOBE_R(1.0) - s2));
    lobe_sphere y;
    y.n_dot_v = n_dot_v;
    y.n_dot_l = n_dot_l;
    y.tangent2 = tangent2;
    y.sine = s;
    y.versine = versine;
    return y;
}

/* A punctual light of the same irradiance at normal incidence, 2 pi (1 - cos) D V l: what every tier tends to as
 * the light shrinks, and the unit of cost. */
LOBE_FN lobe_real lobe_sphere_light_punctual(lobe_real roughness, lobe_sphere light)
{
    lobe_sphere s = lobe_sphere_clamped(light);
    LOBE_LET across = LOBE_R(4.0) * s.tangent2; /* of v + l */
    LOBE_LET v = s.n_dot_v;
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET a2 = a * a;
    LOBE_LET b = LOBE_R(1.0) - a2;
    LOBE_LET z = lobe_max(s.n_dot_l, LOBE_R(0.0));
    LOBE_LET h = v + z;
    LOBE_LET h2 = h * h;
    LOBE_LET q = across + h2;
    LOBE_LET t = across + a2 * h2;
    LOBE_LET root_v = lobe_sqrt(a2 + b * (v * v));
    LOBE_LET m = lobe_sphere_mask(a2, b, v, root_v, z);
    LOBE_LET y = s.versine * a2 * (q * q) * z / (t * t * m + LOBE_R(1e-30));
    return y;
}

/* Representative points without finding the point: v and the mirror direction have opposite tangents along the surface,
 * so a point that is moved from the light's centre towards the mirror by a part has v + l shrunk by that part.
 * low shrinks its square by a ratio of two sums, which need neither root nor division: the half vector's cosine is
 * a ratio, and the divisor goes into its other term. */
LOBE_FN lobe_real lobe_sphere_light_low(LOBE_COEFFS lobe_real roughness, lobe_sphere light)
{
    lobe_sphere s = lobe_sphere_clamped(light);
    LOBE_LET across = LOBE_R(4.0) * s.tangent2; /* of v + l */
    LOBE_LET v = s.n_dot_v;
    LOBE_LET l = s.n_dot_l;
    LOBE_LET r = s.sine;
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET a2 = a * a;
    LOBE_LET b = LOBE_R(1.0) - a2;
    LOBE_LET off = v - l;
    LOBE_LET far = across + off * off;
    LOBE_LET within = lobe_max(r - LOBE_SPHERE_LIGHT_LOW_C5 * a * v, LOBE_R(0.0)) * r;
    LOBE_LET above = lobe_max(far - LOBE_SPHERE_LIGHT_LOW_C1 * within, LOBE_R(0.0));
    LOBE_LET below = far + LOBE_SPHERE_LIGHT_LOW_C2 * (r * r);
    LOBE_LET z = lobe_max(lobe_max(l, LOBE_SPHERE_LIGHT_LOW_C0 * (l + r)), LOBE_R(0.0));
    LOBE_LET h = v + z;
    LOBE_LET w = above * across;
    LOBE_LET h2 = below * (h * h);
    LOBE_LET q = w + h2;
    LOBE_LET t = w + a2 * h2;
    LOBE_LET va = v + LOBE_SPHERE_LIGHT_LOW_C3 * a;
    LOBE_LET root_v = lobe_sqrt(a2 + b * (v * v));
    LOBE_LET m = lobe_sphere_mask(a2, b, v, root_v, z);
    LOBE_LET eq = s.versine * a2 * (q * q);
    LOBE_LET y = lobe_saturate(eq * va * z / ((va * (t * t) + LOBE_SPHERE_LIGHT_LOW_C4 * eq) * m + LOBE_R(1e-36)));
    return y;
}

/* The point moves by r^2 / (r + lobe), less than the radius while the lobe is the wider; x / sqrt(1 + knee x + c x^2)
 * bends to the plateau, before masking. */
LOBE_FN lobe_real lobe_sphere_light_medium(LOBE_COEFFS lobe_real roughness, lobe_sphere light)
{
    lobe_sphere s = lobe_sphere_clamped(light);
    LOBE_LET across = LOBE_R(4.0) * s.tangent2; /* of v + l */
    LOBE_LET v = s.n_dot_v;
    LOBE_LET l = s.n_dot_l;
    LOBE_LET r = s.sine;
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET a2 = a * a;
    LOBE_LET b = LOBE_R(1.0) - a2;
    LOBE_LET off = v - l;
    LOBE_LET far = lobe_sqrt(across + off * off);
    LOBE_LET reach =
        (r + LOBE_SPHERE_LIGHT_MEDIUM_C1 * a * (v + LOBE_SPHERE_LIGHT_MEDIUM_C2 * a)) * far + LOBE_R(1e-18);
    LOBE_LET left = lobe_saturate(LOBE_R(1.0) - r * r / reach);
    LOBE_LET z = lobe_max(lobe_max(l, LOBE_SPHERE_LIGHT_MEDIUM_C0 * (l + r)), LOBE_R(0.0));
    LOBE_LET h = v + z;
    LOBE_LET h2 = h * h;
    LOBE_LET w = left * left * across;
    LOBE_LET q = w + h2;
    LOBE_LET t = w + a2 * h2;
    LOBE_LET root_v = lobe_sqrt(a2 + b * (v * v));
    LOBE_LET va = v + root_v;
    LOBE_LET vk = v + LOBE_SPHERE_LIGHT_MEDIUM_C3 * a;
    /* x = top / bottom is the part of the lobe in the light if that were small */
    LOBE_LET top = s.versine * a2 * (q * q);
    LOBE_LET bottom = t * t * va;
    LOBE_LET knee = LOBE_SPHERE_LIGHT_MEDIUM_C4 * bottom + LOBE_SPHERE_LIGHT_MEDIUM_C5 * (vk * top);
    LOBE_LET bend = lobe_sqrt(vk * (vk * (bottom * bottom) + top * knee));
    LOBE_LET m = lobe_sphere_mask(a2, b, v, root_v, z);
    LOBE_LET y = lobe_saturate(top * va * vk * z / (bend * m + LOBE_R(1e-36)));
    return y;
}

#endif
