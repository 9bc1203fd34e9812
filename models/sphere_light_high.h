/* Sphere light in closed form, and with it Schlick's Fresnel averaged over the light. 97 operations beyond the
 * punctual light; 43 more with Fresnel, some 30 more than high with (1 - v.h)^5 of the light's centre. Derived in
 * cases/sphere_light/README.md. Coefficients 0 to 4 are of the radiance, 5 to 16 of Schlick. */
#ifndef LOBE_SPHERE_LIGHT_HIGH_H
#define LOBE_SPHERE_LIGHT_HIGH_H
#include "sphere_light_schlick.h"
#include "coeffs/sphere_light_high.h"

/* radiance for F = 1; schlick: under reflectance f0 it is radiance (f0 + (1 - f0) schlick). */
LOBE_STRUCT(lobe_sphere_lit)
{
    lobe_real radiance;
    lobe_real schlick;
};

/* height: of the part of the light that stands above the horizon, where masking is taken. */
LOBE_STRUCT(lobe_sphere_risen_lit)
{
    lobe_real radiance;
    lobe_real height;
};

/* The cone of half vectors after the stretch is h Q' h >= 0. The signs are turned over where the light holds the
 * direction opposite to the view (k < 0): one eigenvalue is positive then as well, and its cone is what the light
 * leaves out. The characteristic polynomial is x^3 - t x^2 + c x - d with d >= 0. */
LOBE_FN lobe_sphere_risen_lit lobe_sphere_high_risen(LOBE_COEFFS lobe_real roughness, lobe_sphere light)
{
    lobe_sphere s = lobe_sphere_clamped(light);
    LOBE_LET across = LOBE_R(4.0) * s.tangent2; /* of v + l */
    LOBE_LET v = s.n_dot_v;
    LOBE_LET l = s.n_dot_l;
    LOBE_LET r = s.sine;
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET a2 = a * a;
    LOBE_LET b = LOBE_R(1.0) - a2;
    LOBE_LET n = a2 + b * (v * v);
    LOBE_LET root_v = lobe_sqrt(n);
    LOBE_LET s2 = r * r;
    LOBE_LET h = v + l;
    LOBE_LET h2 = h * h;
    LOBE_LET g = LOBE_R(0.5) * (across + h2); /* 1 + v.l */
    LOBE_LET cosine = LOBE_R(1.0) - s.versine;
    LOBE_LET k = g - s.versine;
    LOBE_LET side = lobe_select(k, LOBE_R(1.0), LOBE_R(-1.0));
    LOBE_LET ak = a2 * (side * k);
    LOBE_LET vl = v * l;
    LOBE_LET e2 = s.versine + s.versine;
    LOBE_LET azz = h2 - (e2 * vl + s2);
    LOBE_LET off = v - l;
    LOBE_LET qzz = s.versine - LOBE_R(0.5) * (across + off * off); /* 2 v.z l.z - k, which loses digits */
    LOBE_LET c = a2 * (across - (e2 * (g - LOBE_R(1.0) - vl) + (s2 + s2)) + a2 * azz);
    LOBE_LET t = side * (b * qzz - a2 * (cosine + cosine + k));
    LOBE_LET d = a2 * s2 * ak;
    /* from above: the root without the cube, or the bound of Laguerre and Samuelson */
    LOBE_LET tn = lobe_min(t, LOBE_R(-1e-18));
    LOBE_LET root = lobe_sqrt(c * c - LOBE_R(4.0) * (d * tn));
    LOBE_LET m = lobe_max(c, -c) + root + LOBE_R(1e-30);
    LOBE_LET x0 = lobe_select(c, d + d, m) / lobe_select(c, m, LOBE_R(-2.0) * tn);
    LOBE_LET wide = lobe_sqrt(t * t - LOBE_R(3.0) * c);
    /* 4e-7: the two parts of the second bound cancel for a round cone, and a start below the root would be noise */
    LOBE_LET x1 = lobe_min(x0, LOBE_R(0.333333333) * t + (LOBE_R(0.666666667) * wide + LOBE_R(4e-7)));
    /* Newton, which comes down to the root and never crosses it */
    LOBE_LET t2 = t + t;
    LOBE_LET f1 = (LOBE_R(3.0) * x1 - t2) * x1 + c + LOBE_R(1e-30);
    LOBE_LET f = ((x1 - t) * x1 + c) * x1 - d;
    LOBE_LET x = lobe_max(x1 - f / f1, LOBE_R(0.0));
    LOBE_LET slope = (LOBE_R(3.0) * x - t2) * x + c;
    /* a4 k^2 + x (u'Q'u + n (x - t)), for u'Q'u - n t is a2 |k| (1 + n) */
    LOBE_LET part = x * lobe_sqrt((ak + x) * (ak + n * x)); /* over root_v slope */
    LOBE_LET whole = root_v * slope;
    LOBE_LET lit = lobe_select(k, part, whole - part);
    LOBE_LET z0 =
        l + s2 * (LOBE_SPHERE_LIGHT_HIGH_C1 * v + (LOBE_SPHERE_LIGHT_HIGH_C2 + LOBE_SPHERE_LIGHT_HIGH_C3 * l));
    LOBE_LET width = r * (LOBE_SPHERE_LIGHT_HIGH_C0 * r + (LOBE_R(1.0) + LOBE_SPHERE_LIGHT_HIGH_C4 * a));
    LOBE_LET z = lobe_sphere_risen(z0, width);
    LOBE_LET mask = lobe_sphere_mask(a2, b, v, root_v, z);
    LOBE_LET y = lobe_saturate((z + z) * lobe_max(lit, LOBE_R(0.0)) / (slope * mask + LOBE_R(1e-30)));
    lobe_sphere_risen_lit lit_light;
    lit_light.radiance = y;
    lit_light.height = z;
    return lit_light;
}

/* The effective (1 - v.h)^5. (v.h)^2 is tangent2 + ((v + l)/2)^2 for the light's centre; the half sum moves towards the
 * normal, for the mirror direction has v.h = n.v, by the part of the lobe that the light fills. left is what is left of
 * the way: 0 for a mirror that sees the light. A light on the horizon counts where it stands above it (lift, and
 * height); the spread of v.h over the light is a term in r^2, that of the lobe one in a r. */
LOBE_FN lobe_real lobe_sphere_high_schlick(LOBE_COEFFS lobe_real roughness, lobe_sphere light, lobe_real height)
{
    lobe_sphere s = lobe_sphere_clamped(light);
    LOBE_LET v = s.n_dot_v;
    LOBE_LET l = s.n_dot_l;
    LOBE_LET r = s.sine;
    LOBE_LET s2 = r * r;
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET middle = LOBE_R(0.5) * (v + l);
    LOBE_LET g = s.tangent2 + middle * middle;
    LOBE_LET off = v - middle;
    LOBE_LET lobe = r * (LOBE_SPHERE_LIGHT_HIGH_C6 * r + LOBE_SPHERE_LIGHT_HIGH_C7 * a);
    LOBE_LET part = s2 / (s.tangent2 + off * off + lobe);
    LOBE_LET left = lobe_max(LOBE_R(1.0) - LOBE_SPHERE_LIGHT_HIGH_C5 * part, LOBE_R(0.0));
    LOBE_LET through = lobe_max(s2 - l * l, LOBE_R(0.0));
    LOBE_LET lift = LOBE_SPHERE_LIGHT_HIGH_C10 * a + (LOBE_SPHERE_LIGHT_HIGH_C11 + LOBE_SPHERE_LIGHT_HIGH_C12 * v);
    LOBE_LET up = v - left * (off - through * lift);
    LOBE_LET wide = LOBE_SPHERE_LIGHT_HIGH_C14 + LOBE_SPHERE_LIGHT_HIGH_C15 * g + LOBE_SPHERE_LIGHT_HIGH_C16 * a;
    LOBE_LET lobed = r * a * part * (LOBE_SPHERE_LIGHT_HIGH_C8 + LOBE_SPHERE_LIGHT_HIGH_C9 * g);
    LOBE_LET set = LOBE_SPHERE_LIGHT_HIGH_C13 * lobe_max(r - l, LOBE_R(0.0)) * height;
    LOBE_LET q = s.tangent2 * (left * left) + up * up + (lobed + left * (set + s2 * wide));
    return lobe_sphere_schlick_of(q);
}

/* For F = 1. */
LOBE_FN lobe_real lobe_sphere_light_high(LOBE_COEFFS lobe_real roughness, lobe_sphere light)
{
    lobe_sphere_risen_lit risen = lobe_sphere_high_risen(LOBE_COEFFS_HERE roughness, light);
    LOBE_LET y = risen.radiance;
    return y;
}

LOBE_FN lobe_sphere_lit lobe_sphere_light_high_lit(LOBE_COEFFS lobe_real roughness, lobe_sphere light)
{
    lobe_sphere_risen_lit risen = lobe_sphere_high_risen(LOBE_COEFFS_HERE roughness, light);
    LOBE_LET schlick = lobe_sphere_high_schlick(LOBE_COEFFS_HERE roughness, light, risen.height);
    lobe_sphere_lit y;
    y.radiance = risen.radiance;
    y.schlick = schlick;
    return y;
}

#endif
