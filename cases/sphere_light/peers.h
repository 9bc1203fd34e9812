/* The published approximations of a sphere light, and two simple ideas beside them: the stars on the chart. None ships.
 * Constants are arguments, so that the same text serves the printed ones and those of peers_fitted.h.
 *
 * All but the wider lobe take as representative point the nearest point of the sphere to the mirror ray r =
 * reflect(-v), at distance 1: L + c sat(R / |c|), c = (L.r) r - L, then a punctual light there. What a punctual light
 * of the same power is, the sources leave open, for they scale an intensity: here it has the light's solid angle, 2 pi
 * (1 - cos), which is 17 % more than pi sin^2 at a half angle of 45 degrees and the same for a small light. */
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

/* Karis 2013, "Real Shading in Unreal Engine 4": normalised by (a / a')^2, a' = sat(a + widening R / d), R / d the
 * sine. The widening is R / (2 d) in the engine and R / (3 d) in the course notes, hence two stars. */
LOBE_FN lobe_real lobe_peer_karis_scale(lobe_real roughness, lobe_real sine, lobe_real widening)
{
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET n = a / lobe_saturate(a + widening * sine);
    LOBE_LET y = n * n;
    return y;
}

LOBE_FN lobe_real lobe_peer_karis(lobe_real roughness, lobe_sphere s, lobe_real widening)
{
    LOBE_LET part = lobe_saturate(lobe_peer_part(s, s.sine));
    LOBE_LET f = lobe_peer_lit(roughness, s, part);
    LOBE_LET y = lobe_peer_karis_scale(roughness, s.sine, widening) * f;
    return y;
}

/* Iwanicki and Pesce 2015, "Approximate Models For Physically Based Rendering": the saturation of x = R / |c| is the
 * soft minimum (x^-3 + 1)^(-1/3). The printed normalisation is garbled: three numbers x = .962406, y = .375892,
 * z = .962406 and a fraction of tan(w / 2) and alpha^z, w the cone's angle. Read as 1 / (x + y t / a^z)^2, t the
 * tangent of the half angle of the light, it is nearest to the exact normalisation at normal view (11 % rms, 27 % at
 * most; without the square 165 %). */
LOBE_FN lobe_real lobe_peer_smooth_part(lobe_real x)
{
    LOBE_LET x3 = x * x * x;
    LOBE_LET u = x3 / (LOBE_R(1.0) + x3);
    LOBE_LET part = lobe_saturate(lobe_pow(lobe_clamp(u, LOBE_R(1e-30), LOBE_R(1.0)), LOBE_R(0.333333333)));
    return part;
}

LOBE_FN lobe_real lobe_peer_smooth_scale(lobe_real roughness, lobe_sphere s, lobe_real nx, lobe_real ny, lobe_real nz)
{
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET t = s.sine / lobe_max(LOBE_R(1.0) - s.versine, LOBE_R(1e-3));
    LOBE_LET n = nx + ny * t / lobe_pow(a, nz);
    LOBE_LET y = LOBE_R(1.0) / (n * n);
    return y;
}

LOBE_FN lobe_real lobe_peer_smooth_point(lobe_real roughness, lobe_sphere s, lobe_real nx, lobe_real ny, lobe_real nz)
{
    LOBE_LET part = lobe_peer_smooth_part(lobe_peer_part(s, s.sine));
    LOBE_LET f = lobe_peer_lit(roughness, s, part);
    LOBE_LET y = lobe_peer_smooth_scale(roughness, s, nx, ny, nz) * f;
    return y;
}

/* A hard point at less than the radius, r^2 / (r + q a), and the result bent under a cap, f / (1 + f / cap). */
LOBE_FN lobe_real lobe_peer_capped_radius(lobe_real roughness, lobe_real sine, lobe_real q)
{
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET rho = sine * sine / (sine + q * a);
    return rho;
}

LOBE_FN lobe_real lobe_peer_capped_point(lobe_real roughness, lobe_sphere s, lobe_real q, lobe_real cap)
{
    LOBE_LET part = lobe_saturate(lobe_peer_part(s, lobe_peer_capped_radius(roughness, s.sine, q)));
    LOBE_LET f = lobe_peer_lit(roughness, s, part);
    LOBE_LET y = f * cap / (cap + f);
    return y;
}

/* A wider lobe for a wider light, a' = sqrt(a^2 + (k sine)^2). */
LOBE_FN lobe_real lobe_peer_wider(lobe_real roughness, lobe_sphere s, lobe_real k)
{
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET ks = k * s.sine;
    LOBE_LET wide = lobe_sqrt(lobe_sqrt(lobe_min(a * a + ks * ks, LOBE_R(1.0))));
    return lobe_sphere_light_punctual(wide, s);
}

/* The same under a cap by the soft minimum (f^s + cap^s)^(1/s), s = -10, written around the smaller of the two. */
LOBE_FN lobe_real lobe_peer_wider_capped(lobe_real roughness, lobe_sphere s, lobe_real k, lobe_real cap)
{
    LOBE_LET f = lobe_peer_wider(roughness, s, k);
    LOBE_LET lo = lobe_min(f, cap);
    LOBE_LET hi = lobe_max(f, cap);
    LOBE_LET u = lo / (hi + LOBE_R(1e-30));
    LOBE_LET u2 = u * u;
    LOBE_LET u5 = u2 * u2 * u;
    LOBE_LET y = lo / lobe_pow(LOBE_R(1.0) + u5 * u5, LOBE_R(0.1));
    return y;
}
#endif
