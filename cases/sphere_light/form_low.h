/* Sphere light, the cheapest form that was tried: 19 operations beyond the punctual light. Does not ship. */
#ifndef LOBE_SPHERE_LIGHT_FORM_LOW_H
#define LOBE_SPHERE_LIGHT_FORM_LOW_H
#include "forms.h"
#if defined(LOBE_FIT)
#define LOBE_SPHERE_LIGHT_LOW_C0 p[0]
#define LOBE_SPHERE_LIGHT_LOW_C1 p[1]
#define LOBE_SPHERE_LIGHT_LOW_C2 p[2]
#define LOBE_SPHERE_LIGHT_LOW_C3 p[3]
#define LOBE_SPHERE_LIGHT_LOW_C4 p[4]
#define LOBE_SPHERE_LIGHT_LOW_C5 p[5]
#else
#include "forms_coefficients.h"
#endif

/* Representative points without finding the point: v and the mirror direction have opposite tangents along the surface,
 * so a point that is moved from the light's centre towards the mirror by a part has v + l shrunk by that part.
 * low shrinks its square by a ratio of two sums, which need neither root nor division: the half vector's cosine is
 * a ratio, and the divisor goes into its other term. */
LOBE_FN lobe_real lobe_sphere_light_low(LOBE_COEFFS lobe_real roughness, lobe_sphere light)
{
    const lobe_sphere s = lobe_sphere_clamped(light);
    LOBE_LET v = s.n_dot_v;
    LOBE_LET l = s.n_dot_l;
    LOBE_LET r = s.sine;
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET a2 = a * a;
    LOBE_LET b = LOBE_R(1.0) - a2;
    LOBE_LET off = v - l;
    LOBE_LET far = s.tangent2 + off * off;
    LOBE_LET within = lobe_max(r - LOBE_SPHERE_LIGHT_LOW_C5 * a * v, LOBE_R(0.0)) * r;
    LOBE_LET above = lobe_max(far - LOBE_SPHERE_LIGHT_LOW_C1 * within, LOBE_R(0.0));
    LOBE_LET below = far + LOBE_SPHERE_LIGHT_LOW_C2 * (r * r);
    LOBE_LET z = lobe_max(lobe_max(l, LOBE_SPHERE_LIGHT_LOW_C0 * (l + r)), LOBE_R(0.0));
    LOBE_LET h = v + z;
    LOBE_LET w = above * s.tangent2;
    LOBE_LET h2 = below * (h * h);
    LOBE_LET q = w + h2;
    LOBE_LET t = w + a2 * h2;
    LOBE_LET va = v + LOBE_SPHERE_LIGHT_LOW_C3 * a;
    LOBE_LET root_v = lobe_sqrt(a2 + b * (v * v));
    LOBE_LET m = lobe_sphere_mask(a2, b, v, root_v, z);
    LOBE_LET eq = s.versine * a2 * (q * q);
    LOBE_LET y = eq * va * z / ((va * (t * t) + LOBE_SPHERE_LIGHT_LOW_C4 * eq) * m + LOBE_R(1e-36));
    return y;
}

#endif
