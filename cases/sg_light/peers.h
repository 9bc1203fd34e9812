/* The published forms, as they are used: the NDF as one SG of sharpness 2 / a2 and amplitude 1 / (pi a2), warped about
 * the mirror direction, its integral with the light; visibility (separable Smith, as their code has it) and cosine at
 * the warped lobe's axis. None ships. They are written from the numbers that ours take, which is cheaper than from
 * vectors. Where the view stands on the normal, the frame of the anisotropic warp is 0/0 in print: here any tangent is
 * taken. */
#ifndef LOBE_SG_LIGHT_PEERS_H
#define LOBE_SG_LIGHT_PEERS_H
#include "../../models/sg_light.h"

/* e to the power x. */
LOBE_FN lobe_real lobe_peer_exp(lobe_real x)
{
    LOBE_LET y = lobe_exp2(LOBE_R(1.4426950408889634) * x);
    return y;
}

/* Separable Smith's visibility of one direction, times 2. */
LOBE_FN lobe_real lobe_peer_separable(lobe_real a2, lobe_real z)
{
    LOBE_LET y = LOBE_R(1.0) / (z + lobe_sqrt(a2 + (LOBE_R(1.0) - a2) * (z * z)));
    return y;
}

/* Wang et al. 2009: an SG of a quarter of the sharpness over n.v. The length of the two lobes' sum is from the distance
 * of their axes, so that the exponent is no difference of large numbers. */
LOBE_FN lobe_real lobe_peer_sg_warp(lobe_real roughness, lobe_sg light)
{
    lobe_sg s = lobe_sg_clamped(light);
    LOBE_LET v = s.n_dot_v;
    LOBE_LET off = v - s.n_dot_l;
    LOBE_LET far = LOBE_R(4.0) * s.tangent2 + off * off; /* |mirror direction - axis|^2 */
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET a2 = a * a;
    LOBE_LET sharp = LOBE_R(0.5) / (a2 * lobe_max(v, LOBE_R(1e-4)));
    LOBE_LET nu = LOBE_R(1.0) / s.versine;
    LOBE_LET both = sharp + nu;
    LOBE_LET apart = sharp * nu * far;
    LOBE_LET length = lobe_sqrt(lobe_max(both * both - apart, LOBE_R(1e-24)));
    LOBE_LET product =
        lobe_peer_exp(-apart / (length + both)) * (LOBE_R(1.0) - lobe_peer_exp(LOBE_R(-2.0) * length)) / length;
    LOBE_LET mask = lobe_peer_separable(a2, v);
    LOBE_LET y = LOBE_R(2.0) * product / a2 * (mask * mask * v);
    return y;
}

/* The light's axis by the view's plane: its part along the surface, away from the mirror, and the view's sine. */
LOBE_STRUCT(lobe_peer_plane) { lobe_real along, sine; };

LOBE_FN lobe_peer_plane lobe_peer_plane_of(lobe_sg s)
{
    LOBE_LET v2 = s.n_dot_v * s.n_dot_v;
    LOBE_LET sine = lobe_sqrt(lobe_max(LOBE_R(1.0) - v2, LOBE_R(1e-14)));
    LOBE_LET turned = LOBE_R(2.0) * s.tangent2 - LOBE_R(1.0) + LOBE_R(0.5) * (v2 + s.n_dot_l * s.n_dot_l);
    LOBE_LET along = turned / sine;
    lobe_peer_plane y;
    y.along = along;
    y.sine = sine;
    return y;
}

/* An anisotropic lobe about the direction at that sine and height in the mirror's half of the plane of incidence,
 * folded with the light. v is the height that stretches it. */
LOBE_FN lobe_real lobe_peer_anisotropic(lobe_sg s, lobe_peer_plane plane, lobe_real sharp, lobe_real v, lobe_real sine,
                                        lobe_real height)
{
    LOBE_LET nu = LOBE_R(0.5) / s.versine;
    LOBE_LET y = LOBE_R(0.125) * sharp;
    LOBE_LET x = y / (v * v);
    LOBE_LET l = s.n_dot_l;
    LOBE_LET across2 = lobe_max(LOBE_R(1.0) - plane.along * plane.along - l * l, LOBE_R(0.0));
    LOBE_LET along = plane.along * height + l * sine;
    LOBE_LET front = lobe_max(l * height - plane.along * sine, LOBE_R(0.0));
    LOBE_LET bx = nu + x;
    LOBE_LET by = nu + y;
    LOBE_LET both = bx * by;
    LOBE_LET fall = nu * (x * by * across2 + y * bx * (along * along)) / both;
    LOBE_LET product = LOBE_R(3.14159265358979323846) * front * lobe_peer_exp(-fall) / lobe_sqrt(both);
    return product;
}

/* Xu et al. 2013: anisotropic, sharpnesses s / (8 (n.v)^2) across and s / 8 along the plane of incidence. */
LOBE_FN lobe_real lobe_peer_asg_warp(lobe_real roughness, lobe_sg light)
{
    lobe_sg s = lobe_sg_clamped(light);
    lobe_peer_plane plane = lobe_peer_plane_of(s);
    LOBE_LET v = s.n_dot_v;
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET a2 = a * a;
    LOBE_LET sharp = LOBE_R(2.0) / a2;
    LOBE_LET product = lobe_peer_anisotropic(s, plane, sharp, lobe_max(v, LOBE_R(1e-4)), plane.sine, v);
    LOBE_LET mask = lobe_peer_separable(a2, v);
    LOBE_LET y = LOBE_R(0.15915494309189535) * sharp * product * (mask * mask * v);
    return y;
}

/* The same with correlated visibility and four constants refitted: sharpness, axis, least n.v, amplitude. The axis is
 * turned from the mirror direction to the normal by .671 alpha of the way; arc and sine are polynomials, within 1e-4.
 */
LOBE_FN lobe_real lobe_peer_asg_refitted(lobe_real roughness, lobe_sg light)
{
    lobe_sg s = lobe_sg_clamped(light);
    lobe_peer_plane plane = lobe_peer_plane_of(s);
    LOBE_LET v = s.n_dot_v;
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET a2 = a * a;
    LOBE_LET b = LOBE_R(1.0) - a2;
    LOBE_LET polynomial =
        LOBE_R(1.5707288) + v * (LOBE_R(-0.2121144) + v * (LOBE_R(0.0742610) + LOBE_R(-0.0187293) * v));
    LOBE_LET turn = LOBE_R(0.671) * a * (lobe_sqrt(LOBE_R(1.0) - v) * polynomial);
    LOBE_LET turn2 = turn * turn;
    LOBE_LET sine = turn * (LOBE_R(1.0) + turn2 * (LOBE_R(-0.16654) + LOBE_R(0.008) * turn2));
    LOBE_LET cosine = lobe_sqrt(LOBE_R(1.0) - sine * sine);
    LOBE_LET z = v * cosine + plane.sine * sine;
    LOBE_LET out = plane.sine * cosine - v * sine;
    LOBE_LET product = lobe_peer_anisotropic(s, plane, LOBE_R(2.116) / a2, lobe_max(v, LOBE_R(0.064)), out, z);
    LOBE_LET mask = lobe_sphere_mask(a2, b, v, lobe_sqrt(a2 + b * (v * v)), z);
    LOBE_LET y = LOBE_R(0.148491911) * product * z / (a2 * mask);
    return y;
}

#endif
