/* A sphere light by linearly transformed cosines, as arithmetic between its texture fetches: what ltc.c judges in
 * double with eigenvectors, here for counting. Heitz et al. 2016; Heitz and Hill 2017.
 *
 * The published code turns the disc of the light into an ellipse and solves its cubic by atan2, cosine and sine. This
 * is shorter, and takes one Newton step as models/sphere_light_high.h does; both to the peer's advantage, since what is
 * judged has none of that step's error. With N the inverse map, p = N L and s the sine, the mapped cone is the dual of
 * G = p p' - s^2 N N', which needs no inverse. It has one positive eigenvalue x; f is the derivative of the
 * characteristic polynomial there, and K = x + s^2 N N':
 *   - the form factor's length is sqrt(det G / (x f));
 *   - the height of the cone's axis is (adj(K) p)_z / sqrt(f p' adj(K) p), for adj(x - G) p = adj(K) p. */
#ifndef LOBE_SPHERE_LIGHT_PEERS_LTC_H
#define LOBE_SPHERE_LIGHT_PEERS_LTC_H
#include "../../models/sphere_light.h"

/* What the first two fetches of the table return: [inv11 0 inv13; 0 1 0; inv31 0 inv33] and the albedo. */
LOBE_STRUCT(lobe_peer_ltc_cell)
{
    lobe_real inv11, inv13, inv31, inv33;
    lobe_real albedo;
};

/* Where those fetches go, in [0, 1]. */
LOBE_STRUCT(lobe_peer_ltc_place) { lobe_real x, y; };

/* Where the third goes, the table of clipped round cones; and what its answer is multiplied with. */
LOBE_STRUCT(lobe_peer_ltc_factor)
{
    lobe_real length, height;
    lobe_real radiance;
};

LOBE_FN lobe_peer_ltc_place lobe_peer_ltc_place_of(lobe_real roughness, lobe_sphere s)
{
    LOBE_LET x = LOBE_R(1.05263158) * roughness - LOBE_R(0.0526315789);
    LOBE_LET y = lobe_sqrt(LOBE_R(1.0) - s.n_dot_v);
    lobe_peer_ltc_place p;
    p.x = x;
    p.y = y;
    return p;
}

LOBE_FN lobe_peer_ltc_factor lobe_peer_ltc_factor_of(lobe_peer_ltc_cell m, lobe_sphere s)
{
    LOBE_LET v = s.n_dot_v;
    LOBE_LET l = s.n_dot_l;
    LOBE_LET h = v + l;
    LOBE_LET vl = LOBE_R(0.5) * (h * h) - LOBE_R(1.0) + LOBE_R(2.0) * s.tangent2;
    /* towards the view and across; a view along the normal has no side */
    LOBE_LET lx = (vl - v * l) / lobe_sqrt(lobe_max(LOBE_R(1.0) - v * v, LOBE_R(1e-12)));
    LOBE_LET y2 = lobe_max(LOBE_R(1.0) - l * l - lx * lx, LOBE_R(0.0));
    LOBE_LET s2 = s.sine * s.sine;
    LOBE_LET px = m.inv11 * lx + m.inv13 * l;
    LOBE_LET pz = m.inv31 * lx + m.inv33 * l;
    LOBE_LET nxx = s2 * (m.inv11 * m.inv11 + m.inv13 * m.inv13);
    LOBE_LET nxz = s2 * (m.inv11 * m.inv31 + m.inv13 * m.inv33);
    LOBE_LET nzz = s2 * (m.inv31 * m.inv31 + m.inv33 * m.inv33);
    LOBE_LET det = s2 * (m.inv11 * m.inv33 - m.inv13 * m.inv31);
    LOBE_LET gxx = px * px - nxx;
    LOBE_LET gxz = px * pz - nxz;
    LOBE_LET gzz = pz * pz - nzz;
    LOBE_LET gyy = y2 - s2;
    LOBE_LET plane = gxx + gzz;
    LOBE_LET p2 = px * px + pz * pz;
    LOBE_LET t = plane + gyy;
    LOBE_LET c = gxx * gzz - gxz * gxz + (gyy * plane - y2 * p2);
    LOBE_LET d = det * det * (LOBE_R(1.0) - s2);
    /* x^3 - t x^2 + c x - d from above, as in models/sphere_light_high.h: the lesser of two bounds, then Newton */
    LOBE_LET t2 = t + t;
    LOBE_LET tn = lobe_min(t, LOBE_R(-1e-18));
    LOBE_LET root = lobe_sqrt(lobe_max(c * c - LOBE_R(4.0) * (d * tn), LOBE_R(0.0)));
    LOBE_LET far = lobe_max(c, -c) + root + LOBE_R(1e-30);
    LOBE_LET b0 = lobe_select(c, d + d, far) / lobe_select(c, far, LOBE_R(-2.0) * tn);
    LOBE_LET wide = lobe_sqrt(lobe_max(t * t - LOBE_R(3.0) * c, LOBE_R(0.0)));
    LOBE_LET x0 = lobe_min(b0, LOBE_R(0.333333333) * t + LOBE_R(0.666666667) * wide);
    LOBE_LET f0 = (LOBE_R(3.0) * x0 - t2) * x0 + c;
    LOBE_LET x = x0 - (((x0 - t) * x0 + c) * x0 - d) / f0;
    LOBE_LET f = (LOBE_R(3.0) * x - t2) * x + c;
    LOBE_LET kxx = x + nxx;
    LOBE_LET kyy = x + s2;
    LOBE_LET kzz = x + nzz;
    LOBE_LET up = kxx * pz - nxz * px;
    LOBE_LET along = px * (kzz * px - nxz * pz) + pz * up;
    LOBE_LET pkp = kyy * along + y2 * (kxx * kzz - nxz * nxz);
    LOBE_LET height = kyy * up / lobe_sqrt(f * pkp);
    LOBE_LET length = lobe_sqrt(d / (x * f));
    LOBE_LET radiance = m.albedo * length;
    lobe_peer_ltc_factor y;
    y.length = length;
    y.height = height;
    y.radiance = radiance;
    return y;
}

#endif
