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
 * low shrinks its square by a ratio of two sums, left over far, which need neither root nor division: the half vector's
 * cosine is a ratio, and the divisor goes into its other term. far has the lobe's width in it (y2), so that a light
 * that is small beside the lobe is not moved at all; the plateau bounds what is left of the peak. */
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
    LOBE_LET z = lobe_max(lobe_max(l, LOBE_SPHERE_LIGHT_LOW_C0 * l + LOBE_SPHERE_LIGHT_LOW_C1 * r), LOBE_R(0.0));
    LOBE_LET h = v + z;
    LOBE_LET h2 = h * h;
    LOBE_LET y2 = a2 * h2; /* the lobe's width squared where across is the distance's */
    LOBE_LET r2 = r * r;
    LOBE_LET off = v - l;
    /* the light's centre to the mirror direction, squared, and never less than lobe and light allow */
    LOBE_LET far = across + off * off +
                   (LOBE_SPHERE_LIGHT_LOW_C2 * r2 + (LOBE_SPHERE_LIGHT_LOW_C3 * y2 + LOBE_SPHERE_LIGHT_LOW_C4 * a2));
    LOBE_LET left = lobe_max(far - LOBE_SPHERE_LIGHT_LOW_C5 * r2, LOBE_R(0.0));
    LOBE_LET w = left * across;
    LOBE_LET q = w + far * h2;
    LOBE_LET t = w + far * y2;
    LOBE_LET va = v + LOBE_SPHERE_LIGHT_LOW_C6 * a;
    LOBE_LET root_v = lobe_sqrt(a2 + b * (v * v));
    LOBE_LET m = lobe_sphere_mask(a2, b, v, root_v, z);
    LOBE_LET eq = s.versine * a2 * (q * q);
    LOBE_LET y = lobe_saturate(eq * va * z / ((va * (t * t) + LOBE_SPHERE_LIGHT_LOW_C7 * eq) * m + LOBE_R(1e-36)));
    return y;
}

/* The light's centre moves towards the mirror direction by a part of the way, r^2 / (r + lobe) and never past it: v and
 * the mirror direction have opposite tangents along the surface, so the tangent of v + l shrinks by that part, and the
 * height goes the same part of the way to v. x / sqrt(1 + knee x + c x^2) then bends to the plateau, x = top / bottom
 * being the part of the lobe in the light if that were small. */
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
    /* the height above the horizon, with a second, flatter piece where the light sets */
    LOBE_LET z = lobe_max(lobe_max(l, LOBE_SPHERE_LIGHT_MEDIUM_C0 * l + LOBE_SPHERE_LIGHT_MEDIUM_C1 * r), LOBE_R(0.0));
    LOBE_LET off = v - l;
    LOBE_LET far = lobe_sqrt(across + off * off); /* from the light's centre to the mirror direction */
    LOBE_LET wide = (LOBE_SPHERE_LIGHT_MEDIUM_C2 + LOBE_SPHERE_LIGHT_MEDIUM_C3 * v) * (a * v);
    LOBE_LET reach = (r + wide) * far + LOBE_R(1e-18);
    LOBE_LET moved = lobe_min(r * r / reach, LOBE_R(1.0));
    LOBE_LET left = LOBE_R(1.0) - moved;
    LOBE_LET h = v + z + moved * off;
    LOBE_LET h2 = h * h;
    LOBE_LET w = left * left * across;
    LOBE_LET q = w + h2;
    LOBE_LET t = w + a2 * h2;
    LOBE_LET root_v = lobe_sqrt(a2 + b * (v * v));
    LOBE_LET m = lobe_sphere_mask(a2, b, v, root_v, z);
    LOBE_LET va = v + LOBE_SPHERE_LIGHT_MEDIUM_C4 * a;
    LOBE_LET zk = z + LOBE_SPHERE_LIGHT_MEDIUM_C5 * v;
    LOBE_LET knee = LOBE_SPHERE_LIGHT_MEDIUM_C6 + LOBE_SPHERE_LIGHT_MEDIUM_C7 * a + LOBE_SPHERE_LIGHT_MEDIUM_C8 * v;
    LOBE_LET top = s.versine * a2 * (q * q);
    LOBE_LET full = top * zk;
    LOBE_LET bottom = t * t * (va * zk);
    LOBE_LET bend = lobe_sqrt(bottom * (bottom + knee * top) + LOBE_SPHERE_LIGHT_MEDIUM_C9 * full * full);
    /* 1e-20: with less the squares in bend vanish in float before the rest does */
    LOBE_LET y = lobe_saturate(full * (va * z) / (bend * m + LOBE_R(1e-20)));
    return y;
}

#endif
