/* Burley's diffuse (Disney 2012) times the cosine, as nine spherical harmonics: what reflects an SH environment.
 *
 * The lobe is   l / pi (1 + (f - 1)(1 - l)^5) (1 + (f - 1)(1 - v)^5),   f = .5 + 2 roughness (L.H)^2,
 * l = n.L > 0, v = n.V, base colour 1. Since (L.H)^2 = (1 + L.V) / 2 it is a polynomial in n.L and L.V, and its
 * projection a polynomial in roughness and v: `exact` is exact (cases/diffuse_sh/README.md).
 *
 * A tier gives six shape weights. With n the normal, t the unit tangent towards the view, s = sqrt(1 - v^2):
 *     c00                                  band 0; the furnace reflectance is sqrt(4 pi) c00
 *     c1n n + (c1t s) t                    band 1, a vector
 *     c2n, c2t s, c2tt s^2                 band 2: zonal around n, n with t, and t with t
 * The weights have s divided out, so in world space s t = V - v n needs neither a root nor a normalisation, and
 * V = n or v = 0 are ordinary points. Only the nine coefficients of the local frame contain the root.
 *
 * World space and radiance: diffuse_sh_radiance.h; one zonal lobe: diffuse_zonal.h. Operations count from roughness and
 * n_dot_v. Errors: coeffs/diffuse_sh_bounds.h. */
#ifndef LOBE_DIFFUSE_SH_H
#define LOBE_DIFFUSE_SH_H
#include "sh9.h"
#include "coeffs/diffuse_sh_exact.h"
#include "coeffs/diffuse_sh_low.h"
#include "coeffs/diffuse_sh_medium.h"

LOBE_STRUCT(lobe_diffuse_shape)
{
    lobe_real c00;
    lobe_real c1n;
    lobe_real c1t;
    lobe_real c2n;
    lobe_real c2t;
    lobe_real c2tt;
};

LOBE_FN lobe_diffuse_shape lobe_diffuse_shape_of(lobe_real c00, lobe_real c1n, lobe_real c1t, lobe_real c2n,
                                                 lobe_real c2t, lobe_real c2tt)
{
    lobe_diffuse_shape s;
    s.c00 = c00;
    s.c1n = c1n;
    s.c1t = c1t;
    s.c2n = c2n;
    s.c2t = c2t;
    s.c2tt = c2tt;
    return s;
}

/* 39 operations. */
LOBE_FN lobe_diffuse_shape lobe_diffuse_shape_exact(lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET x = LOBE_R(1.0) - v;
    LOBE_LET x2 = x * x;
    LOBE_LET w = x2 * x2 * x;
    LOBE_LET a0 = LOBE_DIFFUSE_SH_A0 + r * (LOBE_DIFFUSE_SH_A1 + LOBE_DIFFUSE_SH_A2 * v);
    LOBE_LET b0v = LOBE_DIFFUSE_SH_B3 + r * (LOBE_DIFFUSE_SH_B4 + LOBE_DIFFUSE_SH_B5 * v);
    LOBE_LET b0r = LOBE_DIFFUSE_SH_B1 + LOBE_DIFFUSE_SH_B2 * r + v * b0v;
    LOBE_LET c00 = a0 + w * (LOBE_DIFFUSE_SH_B0 + r * b0r);
    LOBE_LET a1 = LOBE_DIFFUSE_SH_D0 + r * (LOBE_DIFFUSE_SH_D1 + LOBE_DIFFUSE_SH_D2 * v);
    LOBE_LET b1v = LOBE_DIFFUSE_SH_E3 + r * (LOBE_DIFFUSE_SH_E4 + LOBE_DIFFUSE_SH_E5 * v);
    LOBE_LET b1r = LOBE_DIFFUSE_SH_E1 + LOBE_DIFFUSE_SH_E2 * r + v * b1v;
    LOBE_LET c1n = a1 + w * (LOBE_DIFFUSE_SH_E0 + r * b1r);
    LOBE_LET a2 = LOBE_DIFFUSE_SH_F0 + r * (LOBE_DIFFUSE_SH_F1 + LOBE_DIFFUSE_SH_F2 * v);
    LOBE_LET b2v = LOBE_DIFFUSE_SH_G3 + r * (LOBE_DIFFUSE_SH_G4 + LOBE_DIFFUSE_SH_G5 * v);
    LOBE_LET b2r = LOBE_DIFFUSE_SH_G1 + LOBE_DIFFUSE_SH_G2 * r + v * b2v;
    LOBE_LET c2n = a2 + w * (LOBE_DIFFUSE_SH_G0 + r * b2r);
    LOBE_LET t1 = LOBE_DIFFUSE_SH_T1 + r * (LOBE_DIFFUSE_SH_T2 + LOBE_DIFFUSE_SH_T3 * v);
    LOBE_LET c1t = r * (LOBE_DIFFUSE_SH_T0 + w * t1);
    LOBE_LET u1 = LOBE_DIFFUSE_SH_U1 + r * (LOBE_DIFFUSE_SH_U2 + LOBE_DIFFUSE_SH_U3 * v);
    LOBE_LET c2t = r * (LOBE_DIFFUSE_SH_U0 + w * u1);
    LOBE_LET c2tt = LOBE_DIFFUSE_SH_Q * r * r * w;
    return lobe_diffuse_shape_of(c00, c1n, c1t, c2n, c2t, c2tt);
}

/* The exact form without its small terms; c2tt = 0. 20 operations. */
LOBE_FN lobe_diffuse_shape lobe_diffuse_shape_medium(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET x = LOBE_R(1.0) - v;
    LOBE_LET x2 = x * x;
    LOBE_LET w = x2 * x2 * x;
    LOBE_LET b0r = LOBE_DIFFUSE_SH_MEDIUM_C3 + LOBE_DIFFUSE_SH_MEDIUM_C4 * v + LOBE_DIFFUSE_SH_MEDIUM_C5 * r;
    LOBE_LET b0 = LOBE_DIFFUSE_SH_MEDIUM_C2 + r * b0r;
    LOBE_LET c00 = LOBE_DIFFUSE_SH_MEDIUM_C0 + LOBE_DIFFUSE_SH_MEDIUM_C1 * r + w * b0;
    LOBE_LET c1n = c00 * (LOBE_DIFFUSE_SH_MEDIUM_C6 + LOBE_DIFFUSE_SH_MEDIUM_C7 * r);
    LOBE_LET b2r = LOBE_DIFFUSE_SH_MEDIUM_C11 + LOBE_DIFFUSE_SH_MEDIUM_C12 * v;
    LOBE_LET b2 = LOBE_DIFFUSE_SH_MEDIUM_C10 + r * b2r;
    LOBE_LET c2n = LOBE_DIFFUSE_SH_MEDIUM_C8 + LOBE_DIFFUSE_SH_MEDIUM_C9 * r + w * b2;
    LOBE_LET t1 = LOBE_DIFFUSE_SH_MEDIUM_C14 + LOBE_DIFFUSE_SH_MEDIUM_C15 * r;
    LOBE_LET c1t = r * (LOBE_DIFFUSE_SH_MEDIUM_C13 + w * t1);
    LOBE_LET c2t = r * (LOBE_DIFFUSE_SH_MEDIUM_C16 + LOBE_DIFFUSE_SH_MEDIUM_C17 * w);
    return lobe_diffuse_shape_of(c00, c1n, c1t, c2n, c2t, LOBE_R(0.0));
}

/* Bands 1 and 2 as multiples of simpler ones. 13 operations. */
LOBE_FN lobe_diffuse_shape lobe_diffuse_shape_low(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET x = LOBE_R(1.0) - v;
    LOBE_LET x2 = x * x;
    LOBE_LET w = x2 * x2 * x;
    LOBE_LET b0 = LOBE_DIFFUSE_SH_LOW_C2 + LOBE_DIFFUSE_SH_LOW_C3 * r;
    LOBE_LET c00 = LOBE_DIFFUSE_SH_LOW_C0 + LOBE_DIFFUSE_SH_LOW_C1 * r + w * b0;
    LOBE_LET c1n = LOBE_DIFFUSE_SH_LOW_C4 * c00;
    LOBE_LET c2n = c00 * (LOBE_DIFFUSE_SH_LOW_C5 + LOBE_DIFFUSE_SH_LOW_C6 * r);
    LOBE_LET c1t = r * (LOBE_DIFFUSE_SH_LOW_C7 + LOBE_DIFFUSE_SH_LOW_C8 * w);
    LOBE_LET c2t = LOBE_DIFFUSE_SH_LOW_C9 * c1t;
    return lobe_diffuse_shape_of(c00, c1n, c1t, c2n, c2t, LOBE_R(0.0));
}

/* Neither roughness nor view. 0 operations. */
LOBE_FN lobe_diffuse_shape lobe_diffuse_shape_lambert(void)
{
    return lobe_diffuse_shape_of(LOBE_R(0.28209479177387814), LOBE_R(0.32573500793527993), LOBE_R(0.0),
                                 LOBE_R(0.15769578262626002), LOBE_R(0.0), LOBE_R(0.0));
}

/* The nine coefficients in the frame z = normal, x towards the view, for a shape with c2tt = 0. 7 operations. */
LOBE_FN lobe_sh9 lobe_diffuse_sh_local(lobe_diffuse_shape a, lobe_real n_dot_v)
{
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET s = lobe_sqrt(LOBE_R(1.0) - v * v);
    LOBE_LET c3 = a.c1t * s;
    LOBE_LET c7 = a.c2t * s;
    return lobe_sh9_of(a.c00, LOBE_R(0.0), a.c1n, c3, LOBE_R(0.0), LOBE_R(0.0), a.c2n, c7, LOBE_R(0.0));
}

/* The same for every shape. 8 operations. */
LOBE_FN lobe_sh9 lobe_diffuse_sh_local_full(lobe_diffuse_shape a, lobe_real n_dot_v)
{
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET ss = LOBE_R(1.0) - v * v;
    LOBE_LET s = lobe_sqrt(ss);
    LOBE_LET c3 = a.c1t * s;
    LOBE_LET c7 = a.c2t * s;
    LOBE_LET c8 = a.c2tt * ss;
    return lobe_sh9_of(a.c00, LOBE_R(0.0), a.c1n, c3, LOBE_R(0.0), LOBE_R(0.0), a.c2n, c7, c8);
}

/* Nine coefficients from roughness and n.v: exact 47 operations, medium 27, low 20, lambert 0. */
LOBE_FN lobe_sh9 lobe_diffuse_sh_exact(lobe_real roughness, lobe_real n_dot_v)
{
    return lobe_diffuse_sh_local_full(lobe_diffuse_shape_exact(roughness, n_dot_v), n_dot_v);
}

LOBE_FN lobe_sh9 lobe_diffuse_sh_medium(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    return lobe_diffuse_sh_local(lobe_diffuse_shape_medium(LOBE_COEFFS_HERE roughness, n_dot_v), n_dot_v);
}

LOBE_FN lobe_sh9 lobe_diffuse_sh_low(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    return lobe_diffuse_sh_local(lobe_diffuse_shape_low(LOBE_COEFFS_HERE roughness, n_dot_v), n_dot_v);
}

LOBE_FN lobe_sh9 lobe_diffuse_sh_lambert(void)
{
    return lobe_diffuse_sh_local(lobe_diffuse_shape_lambert(), LOBE_R(1.0));
}

#endif
