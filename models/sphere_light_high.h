/* Sphere light in closed form: 109 operations beyond the punctual light. Derived in cases/sphere_light/README.md. */
#ifndef LOBE_SPHERE_LIGHT_HIGH_H
#define LOBE_SPHERE_LIGHT_HIGH_H
#include "sphere_light.h"
#include "coeffs/sphere_light_high.h"

/* The cone of half vectors after the stretch is h Q' h >= 0. The signs are turned over where the light holds the
 * direction opposite to the view (k < 0): one eigenvalue is positive then as well, and its cone is what the light
 * leaves out. The characteristic polynomial is x^3 - t x^2 + c x - d with d >= 0. */
LOBE_FN lobe_real lobe_sphere_light_high(LOBE_COEFFS lobe_real roughness, lobe_sphere light)
{
    lobe_sphere s = lobe_sphere_clamped(light);
    LOBE_LET across = LOBE_R(4.0) * s.tangent2; /* of v + l */
    LOBE_LET v = s.n_dot_v;
    LOBE_LET l = s.n_dot_l;
    LOBE_LET r = s.sine;
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET a2 = a * a;
    LOBE_LET b = LOBE_R(1.0) - a2;
    LOBE_LET bv = b * v;
    LOBE_LET n = a2 + bv * v;
    LOBE_LET root_v = lobe_sqrt(n);
    LOBE_LET s2 = r * r;
    LOBE_LET h = v + l;
    LOBE_LET h2 = h * h;
    LOBE_LET g = LOBE_R(0.5) * (across + h2); /* 1 + v.l */
    LOBE_LET cosine = LOBE_R(1.0) - s.versine;
    LOBE_LET k = g - s.versine;
    LOBE_LET side = lobe_select(k, LOBE_R(1.0), LOBE_R(-1.0));
    LOBE_LET ak = a2 * k;
    LOBE_LET vl = v * l;
    LOBE_LET e2 = s.versine + s.versine;
    LOBE_LET azz = h2 - (e2 * vl + s2);
    LOBE_LET qzz = vl + vl - k;
    LOBE_LET c = a2 * (across - (e2 * (g - LOBE_R(1.0) - vl) + (s2 + s2)) + a2 * azz);
    LOBE_LET apart = g - LOBE_R(1.0) - cosine; /* v.l - cos, which is v Q v */
    LOBE_LET t = side * (b * qzz - a2 * (cosine + cosine + k));
    LOBE_LET a4 = a2 * a2;
    LOBE_LET d = a4 * s2 * (side * k);
    LOBE_LET nq = l - cosine * v;
    LOBE_LET uqu = side * (a4 * apart + bv * ((a2 + a2) * nq + bv * qzz));
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
    LOBE_LET part = x * lobe_sqrt(ak * ak + x * (uqu + n * (x - t))); /* over root_v slope */
    LOBE_LET whole = root_v * slope;
    LOBE_LET lit = lobe_select(k, part, whole - part);
    LOBE_LET z0 =
        l + s2 * (LOBE_SPHERE_LIGHT_HIGH_C1 * v + (LOBE_SPHERE_LIGHT_HIGH_C2 + LOBE_SPHERE_LIGHT_HIGH_C3 * l));
    LOBE_LET width = r * (LOBE_SPHERE_LIGHT_HIGH_C0 * r + (LOBE_R(1.0) + LOBE_SPHERE_LIGHT_HIGH_C4 * a));
    LOBE_LET z = lobe_sphere_risen(z0, width);
    LOBE_LET mask = lobe_sphere_mask(a2, b, v, root_v, z);
    LOBE_LET y = lobe_saturate((z + z) * lobe_max(lit, LOBE_R(0.0)) / (slope * mask + LOBE_R(1e-30)));
    return y;
}
#endif
