/* Sphere lights: the input of every form, and the punctual light. Kernels in the dialect of core/dialect.h, kept here
 * and not in models/ because they do not meet every floor yet (README.md): nothing of this ships.
 *
 * The light is a sphere of radiance 1 under GGX with height-correlated Smith, F = 1; a form returns the reflected
 * radiance. lobe_sphere is what the light is, seen from the point:
 *   n_dot_v, n_dot_l  heights of view and of the light's centre; v in [0, 1], l in [-1, 1]
 *   tangent2          squared length of the part of v + l along the surface, in [0, 4]: what tells an alpha of 1e-3
 *                     from a mirror; 2 + 2 v.l - (n.v + n.l)^2 loses it to rounding
 *   sine, versine     sin and 1 - cos of the half angle, in [0, 1]; 1 - cos as sin^2 / (1 + cos), never 1 - cos
 * Each kernel clamps them; NaN counts as the lower end. */
#ifndef LOBE_SPHERE_LIGHT_FORMS_H
#define LOBE_SPHERE_LIGHT_FORMS_H
#include "../../core/sqrt.h"

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
    y.tangent2 = lobe_clamp(s.tangent2, LOBE_R(0.0), LOBE_R(4.0));
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

/* A punctual light of the same irradiance at normal incidence, 2 pi (1 - cos) D V l: what every tier tends to as
 * the light shrinks, and the unit of cost. */
LOBE_FN lobe_real lobe_sphere_light_punctual(lobe_real roughness, lobe_sphere light)
{
    const lobe_sphere s = lobe_sphere_clamped(light);
    LOBE_LET v = s.n_dot_v;
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET a2 = a * a;
    LOBE_LET b = LOBE_R(1.0) - a2;
    LOBE_LET z = lobe_max(s.n_dot_l, LOBE_R(0.0));
    LOBE_LET h = v + z;
    LOBE_LET h2 = h * h;
    LOBE_LET q = s.tangent2 + h2;
    LOBE_LET t = s.tangent2 + a2 * h2;
    LOBE_LET root_v = lobe_sqrt(a2 + b * (v * v));
    LOBE_LET m = lobe_sphere_mask(a2, b, v, root_v, z);
    LOBE_LET y = s.versine * a2 * (q * q) * z / (t * t * m + LOBE_R(1e-30));
    return y;
}

#endif
