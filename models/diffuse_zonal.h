/* Burley's diffuse times the cosine as one zonal lobe, after Iwanicki and Pesce.
 *
 * It costs more than diffuse_sh.h's medium, in the local frame as much as exact, and is less accurate: take it where
 * one direction is wanted. The best zonal lobe at every point is 1.17 % off (random order-3 lighting). */
#ifndef LOBE_DIFFUSE_ZONAL_H
#define LOBE_DIFFUSE_ZONAL_H
#include "sh9.h"
#include "coeffs/diffuse_sh_zonal.h"
#include "coeffs/diffuse_sh_zonal_low.h"

/* What a tier gives: the lobe's own coefficients around its axis, and how far the axis leans from n towards the view.
 */
LOBE_STRUCT(lobe_zonal_shape)
{
    lobe_real z0;
    lobe_real z1;
    lobe_real z2;
    lobe_real beta;
};

LOBE_FN lobe_zonal_shape lobe_zonal_shape_of(lobe_real z0, lobe_real z1, lobe_real z2, lobe_real beta)
{
    lobe_zonal_shape s;
    s.z0 = z0;
    s.z1 = z1;
    s.z2 = z2;
    s.beta = beta;
    return s;
}

/* A zonal lobe around the unit direction along_n n + along_view view: what a single fetch of an irradiance map, or a
 * look-up in bands above 2, can use. */
LOBE_STRUCT(lobe_zonal_lobe)
{
    lobe_real z0;
    lobe_real z1;
    lobe_real z2;
    lobe_real along_n;
    lobe_real along_view;
};

/* The axis is n + beta (view - n), normalised; |n + beta (view - n)|^2 = 1 - 2 beta (1 - beta)(1 - v). */
LOBE_FN lobe_zonal_lobe lobe_zonal_lobe_of(lobe_zonal_shape s, lobe_real n_dot_v)
{
    LOBE_LET x = LOBE_R(1.0) - lobe_saturate(n_dot_v);
    LOBE_LET rest = LOBE_R(1.0) - s.beta;
    LOBE_LET length2 = LOBE_R(1.0) - LOBE_R(2.0) * s.beta * (rest * x);
    LOBE_LET inverse = LOBE_R(1.0) / lobe_sqrt(length2);
    LOBE_LET along_n = rest * inverse;
    LOBE_LET along_view = s.beta * inverse;
    lobe_zonal_lobe z;
    z.z0 = s.z0;
    z.z1 = s.z1;
    z.z2 = s.z2;
    z.along_n = along_n;
    z.along_view = along_view;
    return z;
}

/* Ratios linear in roughness, bent towards grazing views. */
LOBE_FN lobe_zonal_shape lobe_diffuse_zonal_shape(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET x = LOBE_R(1.0) - v;
    LOBE_LET x2 = x * x;
    LOBE_LET x4 = x2 * x2;
    LOBE_LET w = x4 * x;
    LOBE_LET b0 = LOBE_DIFFUSE_SH_ZONAL_C2 + r * (LOBE_DIFFUSE_SH_ZONAL_C3 + LOBE_DIFFUSE_SH_ZONAL_C4 * v);
    LOBE_LET z0 = LOBE_DIFFUSE_SH_ZONAL_C0 + LOBE_DIFFUSE_SH_ZONAL_C1 * r + w * b0;
    LOBE_LET k1 = LOBE_DIFFUSE_SH_ZONAL_C6 + LOBE_DIFFUSE_SH_ZONAL_C7 * x4;
    LOBE_LET z1 = z0 * (LOBE_DIFFUSE_SH_ZONAL_C5 + r * k1);
    LOBE_LET k2 = LOBE_DIFFUSE_SH_ZONAL_C9 + LOBE_DIFFUSE_SH_ZONAL_C10 * x4;
    LOBE_LET z2 = z0 * (LOBE_DIFFUSE_SH_ZONAL_C8 + r * k2);
    LOBE_LET b = LOBE_DIFFUSE_SH_ZONAL_C12 + LOBE_DIFFUSE_SH_ZONAL_C13 * r;
    LOBE_LET beta = r * (LOBE_DIFFUSE_SH_ZONAL_C11 + x4 * b);
    return lobe_zonal_shape_of(z0, z1, z2, beta);
}

/* Constant ratios. */
LOBE_FN lobe_zonal_shape lobe_diffuse_zonal_shape_low(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET x = LOBE_R(1.0) - v;
    LOBE_LET x2 = x * x;
    LOBE_LET x4 = x2 * x2;
    LOBE_LET w = x4 * x;
    LOBE_LET b0 = LOBE_DIFFUSE_SH_ZONAL_LOW_C2 + LOBE_DIFFUSE_SH_ZONAL_LOW_C3 * r;
    LOBE_LET z0 = LOBE_DIFFUSE_SH_ZONAL_LOW_C0 + LOBE_DIFFUSE_SH_ZONAL_LOW_C1 * r + w * b0;
    LOBE_LET z1 = LOBE_DIFFUSE_SH_ZONAL_LOW_C4 * z0;
    LOBE_LET z2 = LOBE_DIFFUSE_SH_ZONAL_LOW_C5 * z0;
    LOBE_LET beta = r * (LOBE_DIFFUSE_SH_ZONAL_LOW_C6 + LOBE_DIFFUSE_SH_ZONAL_LOW_C7 * x4);
    return lobe_zonal_shape_of(z0, z1, z2, beta);
}

LOBE_FN lobe_zonal_lobe lobe_diffuse_zonal(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    return lobe_zonal_lobe_of(lobe_diffuse_zonal_shape(LOBE_COEFFS_HERE roughness, n_dot_v), n_dot_v);
}

LOBE_FN lobe_zonal_lobe lobe_diffuse_zonal_low(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    return lobe_zonal_lobe_of(lobe_diffuse_zonal_shape_low(LOBE_COEFFS_HERE roughness, n_dot_v), n_dot_v);
}

/* The nine coefficients of a zonal lobe in the frame z = normal, x towards the view. */
LOBE_FN lobe_sh9 lobe_diffuse_zonal_local(lobe_zonal_lobe z, lobe_real n_dot_v)
{
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET s = lobe_sqrt(LOBE_R(1.0) - v * v);
    LOBE_LET dx = z.along_view * s;
    LOBE_LET dz = z.along_n + z.along_view * v;
    LOBE_LET c2 = z.z1 * dz;
    LOBE_LET c3 = z.z1 * dx;
    LOBE_LET kx = LOBE_SQRT3 * z.z2 * dx;
    LOBE_LET c6 = z.z2 * (LOBE_R(1.5) * dz * dz - LOBE_R(0.5));
    LOBE_LET c7 = kx * dz;
    LOBE_LET c8 = LOBE_R(0.5) * kx * dx;
    return lobe_sh9_of(z.z0, LOBE_R(0.0), c2, c3, LOBE_R(0.0), LOBE_R(0.0), c6, c7, c8);
}

LOBE_FN lobe_sh9 lobe_diffuse_sh_zonal(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    return lobe_diffuse_zonal_local(lobe_diffuse_zonal(LOBE_COEFFS_HERE roughness, n_dot_v), n_dot_v);
}

LOBE_FN lobe_sh9 lobe_diffuse_sh_zonal_low(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    return lobe_diffuse_zonal_local(lobe_diffuse_zonal_low(LOBE_COEFFS_HERE roughness, n_dot_v), n_dot_v);
}

#endif
