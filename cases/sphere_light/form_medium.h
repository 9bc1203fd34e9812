/* Sphere light by a moved half vector and a plateau: 39 operations beyond the punctual light. Does not ship. */
#ifndef LOBE_SPHERE_LIGHT_FORM_MEDIUM_H
#define LOBE_SPHERE_LIGHT_FORM_MEDIUM_H
#include "forms.h"
#if defined(LOBE_FIT)
#define LOBE_SPHERE_LIGHT_MEDIUM_C0 p[0]
#define LOBE_SPHERE_LIGHT_MEDIUM_C1 p[1]
#define LOBE_SPHERE_LIGHT_MEDIUM_C2 p[2]
#define LOBE_SPHERE_LIGHT_MEDIUM_C3 p[3]
#define LOBE_SPHERE_LIGHT_MEDIUM_C4 p[4]
#define LOBE_SPHERE_LIGHT_MEDIUM_C5 p[5]
#else
#include "forms_coefficients.h"
#endif

/* The point moves by r^2 / (r + lobe), less than the radius while the lobe is the wider; x / sqrt(1 + knee x + c x^2)
 * bends to the plateau, before masking. */
LOBE_FN lobe_real lobe_sphere_light_medium(LOBE_COEFFS lobe_real roughness, lobe_sphere light)
{
    const lobe_sphere s = lobe_sphere_clamped(light);
    LOBE_LET v = s.n_dot_v;
    LOBE_LET l = s.n_dot_l;
    LOBE_LET r = s.sine;
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET a2 = a * a;
    LOBE_LET b = LOBE_R(1.0) - a2;
    LOBE_LET off = v - l;
    LOBE_LET far = lobe_sqrt(s.tangent2 + off * off);
    LOBE_LET reach =
        (r + LOBE_SPHERE_LIGHT_MEDIUM_C1 * a * (v + LOBE_SPHERE_LIGHT_MEDIUM_C2 * a)) * far + LOBE_R(1e-18);
    LOBE_LET left = lobe_saturate(LOBE_R(1.0) - r * r / reach);
    LOBE_LET z = lobe_max(lobe_max(l, LOBE_SPHERE_LIGHT_MEDIUM_C0 * (l + r)), LOBE_R(0.0));
    LOBE_LET h = v + z;
    LOBE_LET h2 = h * h;
    LOBE_LET w = left * left * s.tangent2;
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
    LOBE_LET y = top * va * vk * z / (bend * m + LOBE_R(1e-36));
    return y;
}

#endif
