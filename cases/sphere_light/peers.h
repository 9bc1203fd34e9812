/* The published approximations of a sphere light, and two simple ideas beside them. Sources: Karis, "Real Shading in
 * Unreal Engine 4" (2013); Iwanicki and Pesce, "Approximate Models For Physically Based Rendering" (2015). All take the
 * representative point as the nearest point of the sphere to the mirror ray, at distance 1. */
#ifndef LOBE_SPHERE_LIGHT_PEERS_H
#define LOBE_SPHERE_LIGHT_PEERS_H
#include "../../core/power.h"
#include "../../models/sphere_light.h"

LOBE_STRUCT(lobe_peer_point)
{
    lobe_real z;        /* n.l of the point */
    lobe_real tangent2; /* as in lobe_sphere, for the point */
};

/* part: how far from the centre to the mirror ray's foot the point is, in [0, 1] */
LOBE_FN lobe_peer_point lobe_peer_point_of(lobe_sphere s, lobe_real part)
{
    LOBE_LET v = s.n_dot_v;
    LOBE_LET l = s.n_dot_l;
    LOBE_LET off = v - l;
    LOBE_LET far = LOBE_R(4.0) * s.tangent2 + off * off;
    LOBE_LET foot = LOBE_R(1.0) - LOBE_R(0.5) * far; /* r.l */
    LOBE_LET out = far * (LOBE_R(1.0) - LOBE_R(0.25) * far);
    LOBE_LET left = LOBE_R(1.0) - part;
    LOBE_LET norm = lobe_sqrt(lobe_max(left * left * out + foot * foot, LOBE_R(1e-12)));
    LOBE_LET z = (left * l + part * (foot * v)) / norm;
    LOBE_LET h = v + l;
    LOBE_LET c = LOBE_R(0.5) * (LOBE_R(4.0) * s.tangent2 + h * h) - LOBE_R(1.0);
    LOBE_LET pc = (left * c + part * (foot * (LOBE_R(2.0) * v * v - LOBE_R(1.0)))) / norm;
    LOBE_LET hz = v + z;
    LOBE_LET t2 = lobe_max(LOBE_R(0.5) + LOBE_R(0.5) * pc - LOBE_R(0.25) * (hz * hz), LOBE_R(0.0));
    lobe_peer_point y;
    y.z = z;
    y.tangent2 = t2;
    return y;
}

/* radius over the distance of the centre from the mirror ray */
LOBE_FN lobe_real lobe_peer_part(lobe_sphere s, lobe_real radius)
{
    LOBE_LET off = s.n_dot_v - s.n_dot_l;
    LOBE_LET far = LOBE_R(4.0) * s.tangent2 + off * off;
    LOBE_LET out = lobe_sqrt(lobe_max(far * (LOBE_R(1.0) - LOBE_R(0.25) * far), LOBE_R(1e-14)));
    LOBE_LET y = radius / out;
    return y;
}

LOBE_FN lobe_real lobe_peer_lit(lobe_real roughness, lobe_sphere s, lobe_real part)
{
    const lobe_peer_point q = lobe_peer_point_of(s, part);
    lobe_sphere y = s;
    y.n_dot_l = q.z;
    y.tangent2 = q.tangent2;
    return lobe_sphere_light_punctual(roughness, y);
}

/* Karis: normalised by (a / a')^2, a' = sat(a + widening * sine); widening 1/2 (the engine) or 1/3 (the notes). */
LOBE_FN lobe_real lobe_peer_karis(lobe_real roughness, lobe_sphere s, lobe_real widening)
{
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET n = a / lobe_saturate(a + widening * s.sine);
    LOBE_LET part = lobe_saturate(lobe_peer_part(s, s.sine));
    LOBE_LET f = lobe_peer_lit(roughness, s, part);
    LOBE_LET y = n * n * f;
    return y;
}

/* Iwanicki-Pesce: the saturation is the soft minimum (x^-3 + 1)^(-1/3); normalised by 1 / (x + y t / a^z)^2, t the
 * tangent of the half angle. Printed: .962406, .375892, .962406, read as a square: the printed text is garbled. */
LOBE_FN lobe_real lobe_peer_smooth_point(lobe_real roughness, lobe_sphere s, lobe_real nx, lobe_real ny, lobe_real nz)
{
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET x = lobe_peer_part(s, s.sine);
    LOBE_LET x3 = x * x * x;
    LOBE_LET u = x3 / (LOBE_R(1.0) + x3);
    LOBE_LET part = lobe_saturate(lobe_pow(lobe_clamp(u, LOBE_R(1e-30), LOBE_R(1.0)), LOBE_R(0.333333333)));
    LOBE_LET t = s.sine / lobe_max(LOBE_R(1.0) - s.versine, LOBE_R(1e-3));
    LOBE_LET n = nx + ny * t / lobe_pow(a, nz);
    LOBE_LET f = lobe_peer_lit(roughness, s, part);
    LOBE_LET y = f / (n * n);
    return y;
}

/* One constant: hard point of radius r^2 / (r + q a), E / (1 + E / cap). */
LOBE_FN lobe_real lobe_peer_capped_point(lobe_real roughness, lobe_sphere s, lobe_real q, lobe_real cap)
{
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET rho = s.sine * s.sine / (s.sine + q * a);
    LOBE_LET part = lobe_saturate(lobe_peer_part(s, rho));
    LOBE_LET f = lobe_peer_lit(roughness, s, part);
    LOBE_LET y = f / (LOBE_R(1.0) + f / cap);
    return y;
}

/* A wider lobe for a wider light, a' = sqrt(a^2 + (k sine)^2), softly capped at cap: (f^s + cap^s)^(1/s), s = -10,
 * written around the smaller of the two. cap >= 1e6 leaves it out. */
LOBE_FN lobe_real lobe_peer_wider(lobe_real roughness, lobe_sphere s, lobe_real k, lobe_real cap)
{
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET ks = k * s.sine;
    LOBE_LET wide = lobe_sqrt(lobe_sqrt(lobe_min(a * a + ks * ks, LOBE_R(1.0))));
    LOBE_LET f = lobe_sphere_light_punctual(wide, s);
    LOBE_LET lo = lobe_min(f, cap);
    LOBE_LET hi = lobe_max(f, cap);
    LOBE_LET u = lo / (hi + LOBE_R(1e-30));
    LOBE_LET u2 = u * u;
    LOBE_LET u5 = u2 * u2 * u;
    LOBE_LET y = lo / lobe_pow(LOBE_R(1.0) + u5 * u5, LOBE_R(0.1));
    return y;
}
#endif
