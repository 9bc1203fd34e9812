/* The published approximation of a capsule light, Karis, "Real Shading in Unreal Engine 4" (2013): the point of the
 * segment nearest to the mirror ray, the nearest point of the sphere there to that ray, and a normalisation for the
 * sphere and one for the line, a / a' with a' = sat(a + widening * angle); and a punctual light. Both have the
 * irradiance of the whole capsule. Vectors as in lobe_capsule, whose clamps they leave out. */
#ifndef LOBE_CAPSULE_LIGHT_PEERS_H
#define LOBE_CAPSULE_LIGHT_PEERS_H
#include "../../core/vec3.h"
#include "../../models/capsule_light.h"

/* A capsule as a punctual light at (x, y, z) / distance, of that many spheres of that sine: where the disc and the
 * strip of half that length across the line of sight are as large. */
LOBE_FN lobe_real lobe_peer_capsule_lit(lobe_real roughness, lobe_capsule c, lobe_vec3 l, lobe_real sine,
                                        lobe_real across)
{
    LOBE_LET vx = lobe_sqrt(LOBE_R(1.0) - c.n_dot_v * c.n_dot_v);
    LOBE_LET hx = vx + l.x;
    LOBE_LET tangent2 = LOBE_R(0.25) * (hx * hx + l.y * l.y);
    LOBE_LET area = LOBE_R(0.5) * (sine * (sine + LOBE_R(1.27323954) * across));
    lobe_sphere s;
    s.n_dot_v = c.n_dot_v;
    s.n_dot_l = l.z;
    s.tangent2 = tangent2;
    s.sine = sine;
    s.versine = area; /* the punctual light's solid angle is 2 pi versine */
    return lobe_sphere_light_punctual(roughness, s);
}

/* Length across the line of sight to (x, y, z), as an angle. */
LOBE_FN lobe_real lobe_peer_capsule_across(lobe_capsule c, lobe_vec3 p, lobe_real inverse)
{
    LOBE_LET along = (p.x * c.ex + p.y * c.ey + p.z * c.ez) * inverse;
    LOBE_LET ee = c.ex * c.ex + c.ey * c.ey + c.ez * c.ez;
    LOBE_LET across = lobe_sqrt(ee - along * along) * inverse;
    return across;
}

LOBE_FN lobe_real lobe_peer_capsule_point(lobe_real roughness, lobe_capsule c)
{
    lobe_vec3 m = lobe_vec3_of(c.mx, c.my, c.mz);
    LOBE_LET inverse = LOBE_R(1.0) / lobe_sqrt(lobe_vec3_dot(m, m));
    LOBE_LET sine = lobe_saturate(c.radius * inverse);
    LOBE_LET across = lobe_peer_capsule_across(c, m, inverse);
    lobe_vec3 l = lobe_vec3_scale(m, inverse);
    return lobe_peer_capsule_lit(roughness, c, l, sine, across);
}

/* widening: 1/2 (the engine) or 1/3 (the notes). */
LOBE_FN lobe_real lobe_peer_capsule_karis(lobe_real roughness, lobe_capsule c, lobe_real widening)
{
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET v = c.n_dot_v;
    LOBE_LET vx = lobe_sqrt(LOBE_R(1.0) - v * v);
    LOBE_LET re = v * c.ez - vx * c.ex;
    LOBE_LET rm = v * c.mz - vx * c.mx;
    LOBE_LET ee = c.ex * c.ex + c.ey * c.ey + c.ez * c.ez;
    LOBE_LET em = c.ex * c.mx + c.ey * c.my + c.ez * c.mz;
    LOBE_LET t = lobe_clamp((re * rm - em) / (ee - re * re + LOBE_R(1e-12)), LOBE_R(-1.0), LOBE_R(1.0));
    LOBE_LET px = c.mx + t * c.ex;
    LOBE_LET py = c.my + t * c.ey;
    LOBE_LET pz = c.mz + t * c.ez;
    lobe_vec3 p = lobe_vec3_of(px, py, pz);
    LOBE_LET inverse = LOBE_R(1.0) / lobe_sqrt(lobe_vec3_dot(p, p));
    LOBE_LET sine = lobe_saturate(c.radius * inverse);
    LOBE_LET across = lobe_peer_capsule_across(c, p, inverse);
    LOBE_LET foot = v * pz - vx * px;
    LOBE_LET ox = -(foot * vx) - px;
    LOBE_LET oz = foot * v - pz;
    LOBE_LET off = lobe_max(lobe_sqrt(ox * ox + py * py + oz * oz), LOBE_R(1e-9));
    LOBE_LET part = lobe_min(c.radius / off, LOBE_R(1.0));
    LOBE_LET qx = px + part * ox;
    LOBE_LET qy = py - part * py;
    LOBE_LET qz = pz + part * oz;
    lobe_vec3 l = lobe_vec3_normalize(lobe_vec3_of(qx, qy, qz));
    LOBE_LET length = lobe_sqrt(ee) * inverse;
    LOBE_LET disc = a / lobe_saturate(a + widening * sine);
    LOBE_LET line = a / lobe_saturate(a + widening * length);
    LOBE_LET f = lobe_peer_capsule_lit(roughness, c, l, sine, across);
    LOBE_LET y = f * (disc * disc) * line;
    return y;
}

#endif
