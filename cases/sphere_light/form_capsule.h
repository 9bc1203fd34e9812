/* A capsule of radiance 1 (the points nearer than radius to a segment) seen in GGX: a sphere somewhere on the segment,
 * brighter by the part of the line that the lobe sees. Vectors are components, the shading point is the origin, n = z,
 * the view (view_x, 0, view_z); m is the segment's middle, e half the segment from there, so the ends are m - e and
 * m + e. Domain: the segment's line passes farther than 1.5 radius from the origin; alpha .05 to 1. Does not ship.
 *
 * The sphere's place is t in [-1, 1]: towards where the segment is nearest to the mirror ray, but only as far as the
 * line is longer than the lobe is wide. The line adds 4/pi * length / radius spheres, of which the lobe takes the
 * part lobe / (lobe + length), all as angles. The sphere's medium form then masks, bends to the plateau and sets. */
#ifndef LOBE_SPHERE_LIGHT_FORM_CAPSULE_H
#define LOBE_SPHERE_LIGHT_FORM_CAPSULE_H
#include "../../models/sphere_light.h"
#include "forms_coefficients.h"

LOBE_STRUCT(lobe_capsule)
{
    lobe_real mx;
    lobe_real my;
    lobe_real mz;
    lobe_real ex;
    lobe_real ey;
    lobe_real ez;
    lobe_real radius;
};

#if defined(LOBE_FIT)
#define LOBE_CAPSULE_C0 p[6]
#define LOBE_CAPSULE_C1 p[7]
#define LOBE_CAPSULE_C2 p[8]
#define LOBE_CAPSULE_C3 p[9]
#endif

LOBE_FN lobe_real lobe_capsule_light(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v, lobe_capsule c)
{
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET vx = lobe_sqrt(LOBE_R(1.0) - v * v);
    LOBE_LET a = lobe_sphere_alpha(roughness);
    /* nearest to the mirror ray (-vx, 0, v) */
    LOBE_LET re = v * c.ez - vx * c.ex;
    LOBE_LET rm = v * c.mz - vx * c.mx;
    LOBE_LET ee = c.ex * c.ex + c.ey * c.ey + c.ez * c.ez;
    LOBE_LET em = c.ex * c.mx + c.ey * c.my + c.ez * c.mz;
    LOBE_LET mm = c.mx * c.mx + c.my * c.my + c.mz * c.mz;
    LOBE_LET t0 =
        lobe_clamp((re * rm - em) / (ee - re * re + LOBE_R(1e-6) * ee + LOBE_R(1e-20)), LOBE_R(-1.0), LOBE_R(1.0));
    LOBE_LET half_line = lobe_sqrt(ee / mm);
    LOBE_LET lobe = a * (LOBE_CAPSULE_C0 + LOBE_CAPSULE_C1 * v);
    LOBE_LET t = t0 * half_line / (half_line + lobe);
    LOBE_LET px = c.mx + t * c.ex;
    LOBE_LET py = c.my + t * c.ey;
    LOBE_LET pz = c.mz + t * c.ez;
    LOBE_LET pp = px * px + py * py + pz * pz;
    LOBE_LET inv = LOBE_R(1.0) / lobe_sqrt(lobe_max(pp, c.radius * c.radius));
    LOBE_LET sine = lobe_saturate(c.radius * inv);
    LOBE_LET lx = px * inv;
    LOBE_LET ly = py * inv;
    LOBE_LET lz = pz * inv;
    LOBE_LET hx = vx + lx;
    LOBE_LET tangent2 = LOBE_R(0.25) * (hx * hx + ly * ly);
    LOBE_LET versine = sine * sine / (LOBE_R(1.0) + lobe_sqrt(LOBE_R(1.0) - sine * sine));
    /* the length across the line of sight, as an angle */
    LOBE_LET along = (px * c.ex + py * c.ey + pz * c.ez) * inv;
    LOBE_LET across = lobe_sqrt(lobe_max(ee - along * along, LOBE_R(0.0))) * inv;
    LOBE_LET seen = LOBE_CAPSULE_C2 * a + LOBE_CAPSULE_C3 * sine;
    LOBE_LET more = LOBE_R(1.27323954) * (across / sine) * (seen / (seen + across));
    LOBE_LET bright = versine * (LOBE_R(1.0) + more);
    lobe_sphere s;
    s.n_dot_v = v;
    s.n_dot_l = lz;
    s.tangent2 = tangent2;
    s.sine = sine;
    s.versine = bright;
    return lobe_sphere_light_medium(LOBE_COEFFS_HERE roughness, s);
}
#endif
