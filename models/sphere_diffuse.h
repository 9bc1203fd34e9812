/* Irradiance of a sphere of radiance 1, over pi: what Lambert's surface makes of a sphere light, with the part of it
 * that stands below the horizon cut off. In [0, 1].
 *
 *   n_dot_l   height of the light's centre, [-1, 1]
 *   sine      of the light's half angle, radius / distance, (0, 1]
 *
 * With s = sine, c = n_dot_l: s^2 c where the whole light is up (c >= s), 0 where none is (c <= -s), and between
 *     s^2 max(c, 0) + excess,   pi excess = A - q C + |c| s^2 (atan2(|c| C, q) - pi / 2)
 * with C = sqrt(1 - s^2), q = sqrt(s^2 - c^2), A = atan2(q, C) (Snyder 1996, brought into a form that is even but for
 * its first term). c >= s gives the bits of s^2 c in every tier: a light that shrinks becomes a punctual one.
 *
 * low and medium: s^2 times the middle of the three chords max(c, (c + s)/2, 0), less s k C times a ratio, k = q^2.
 * The cap below the horizon vanishes with k; the factor C makes a light of half the sky exact, (1 + c)/2. */
#ifndef LOBE_SPHERE_DIFFUSE_H
#define LOBE_SPHERE_DIFFUSE_H
#include "../core/arc.h"
#include "../core/sign.h"
#include "../core/sqrt.h"
#include "coeffs/sphere_diffuse_low.h"
#include "coeffs/sphere_diffuse_medium.h"

/* No division, no arc function. Next to half the sky 1 - s^2 has lost digits: 6e-7 in float. */
LOBE_FN lobe_real lobe_sphere_diffuse_low(LOBE_COEFFS lobe_real n_dot_l, lobe_real sine)
{
    LOBE_LET c = lobe_clamp(n_dot_l, LOBE_R(-1.0), LOBE_R(1.0));
    LOBE_LET s = lobe_saturate(sine);
    LOBE_LET s2 = s * s;
    LOBE_LET k = lobe_max(s2 - c * c, LOBE_R(0.0));
    LOBE_LET cosine = lobe_sqrt(LOBE_R(1.0) - s2);
    LOBE_LET middle = LOBE_R(0.5) * (c + s);
    LOBE_LET chord = lobe_max(lobe_max(c, middle), LOBE_R(0.0));
    LOBE_LET ratio = LOBE_SPHERE_DIFFUSE_LOW_C0 + LOBE_SPHERE_DIFFUSE_LOW_C1 * cosine + LOBE_SPHERE_DIFFUSE_LOW_C2 * k;
    LOBE_LET y = s2 * chord - s * k * cosine * ratio;
    return lobe_saturate(y);
}

/* No arc function. sqrt(1 - c^2) is the radius of the circle that the light's centre runs on about the normal. */
LOBE_FN lobe_real lobe_sphere_diffuse_medium(LOBE_COEFFS lobe_real n_dot_l, lobe_real sine)
{
    LOBE_LET c = lobe_clamp(n_dot_l, LOBE_R(-1.0), LOBE_R(1.0));
    LOBE_LET s = lobe_saturate(sine);
    LOBE_LET s2 = s * s;
    LOBE_LET c2 = c * c;
    LOBE_LET k = lobe_max(s2 - c2, LOBE_R(0.0));
    LOBE_LET q = lobe_sqrt(k);
    LOBE_LET cosine = lobe_sqrt((LOBE_R(1.0) - s) * (LOBE_R(1.0) + s));
    LOBE_LET run = lobe_sqrt(LOBE_R(1.0) - c2);
    LOBE_LET middle = LOBE_R(0.5) * (c + s);
    LOBE_LET chord = lobe_max(lobe_max(c, middle), LOBE_R(0.0));
    LOBE_LET top = LOBE_SPHERE_DIFFUSE_MEDIUM_C0 * s2 + LOBE_SPHERE_DIFFUSE_MEDIUM_C1 * k;
    LOBE_LET sum = cosine + LOBE_SPHERE_DIFFUSE_MEDIUM_C2 * run + LOBE_SPHERE_DIFFUSE_MEDIUM_C3 * q +
                   LOBE_SPHERE_DIFFUSE_MEDIUM_C4 * k;
    LOBE_LET bottom = lobe_max(s * sum, LOBE_R(1e-30));
    LOBE_LET y = s2 * chord - k * cosine * top / bottom;
    return lobe_saturate(y);
}

/* The closed form. A - q C is written as the segment A - sin A cos A and c^2 sin A cos A, so that all that is added has
 * one sign but |c| s^2 (pi / 2 - ...), and a small light loses nothing. */
LOBE_FN lobe_real lobe_sphere_diffuse_exact(lobe_real n_dot_l, lobe_real sine)
{
    LOBE_LET c = lobe_clamp(n_dot_l, LOBE_R(-1.0), LOBE_R(1.0));
    LOBE_LET s = lobe_saturate(sine);
    LOBE_LET s2 = s * s;
    LOBE_LET m = lobe_abs(c);
    LOBE_LET k = lobe_max((s - m) * (s + m), LOBE_R(0.0));
    LOBE_LET q = lobe_sqrt(k);
    LOBE_LET cosine = lobe_sqrt((LOBE_R(1.0) - s) * (LOBE_R(1.0) + s));
    LOBE_LET run2 = lobe_max((LOBE_R(1.0) - m) * (LOBE_R(1.0) + m), LOBE_R(1e-30));
    LOBE_LET product = m * m * q * cosine / run2 * LOBE_INVERSE_PI;
    LOBE_LET mc = m * cosine;
    LOBE_LET excess = lobe_arc_segment(q, cosine) + product - m * s2 * lobe_arc(q, mc);
    LOBE_LET y = s2 * lobe_max(c, LOBE_R(0.0)) + lobe_max(excess, LOBE_R(0.0));
    return lobe_saturate(y);
}

#endif
