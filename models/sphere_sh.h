/* A sphere light of radiance 1 as nine spherical harmonics: what diffuse_sh takes as lighting.
 *
 * The light is the cone of half angle sigma about the unit direction d, as seen from the point; nothing is clipped, the
 * surface's lobe does that. With s = sin sigma, C = cos sigma its zonal coefficients, about itself, are the integrals
 *     of P0: 2 pi (1 - C)     of P1: pi s^2     of P2: pi C s^2     times sqrt((2 l + 1) / 4 pi)
 * and 1 - C is s^2 / (1 + C), so that a small light keeps its digits. Order 3 blurs: what that costs, by half angle, is
 * in cases/sphere_diffuse/README.md; diffuse light from many lights at once is what this is for. */
#ifndef LOBE_SPHERE_SH_H
#define LOBE_SPHERE_SH_H
#include "diffuse_sh_radiance.h"

/* 38 operations, of which 6 are clamps. */
LOBE_FN lobe_sh9 lobe_sphere_sh(lobe_real sine, lobe_vec3 direction)
{
    lobe_vec3 d = lobe_diffuse_sh_direction(direction);
    LOBE_LET s = lobe_saturate(sine);
    LOBE_LET s2 = s * s;
    LOBE_LET cosine = lobe_sqrt((LOBE_R(1.0) - s) * (LOBE_R(1.0) + s));
    LOBE_LET z0 = LOBE_R(1.7724538509055159) * s2 / (LOBE_R(1.0) + cosine); /* sqrt(pi) */
    LOBE_LET z1 = LOBE_R(1.5349900619197328) * s2;                          /* sqrt(3 pi / 4) */
    LOBE_LET z2 = LOBE_R(1.9816636488030055) * s2 * cosine;                 /* sqrt(5 pi / 4) */
    return lobe_sh9_zonal(z0, z1, z2, d);
}

/* a + k b: adds a light of radiance k to one channel of the lighting. */
LOBE_FN lobe_sh9 lobe_sh9_add_scaled(lobe_sh9 a, lobe_real k, lobe_sh9 b)
{
    LOBE_LET c0 = a.c0 + k * b.c0;
    LOBE_LET c1 = a.c1 + k * b.c1;
    LOBE_LET c2 = a.c2 + k * b.c2;
    LOBE_LET c3 = a.c3 + k * b.c3;
    LOBE_LET c4 = a.c4 + k * b.c4;
    LOBE_LET c5 = a.c5 + k * b.c5;
    LOBE_LET c6 = a.c6 + k * b.c6;
    LOBE_LET c7 = a.c7 + k * b.c7;
    LOBE_LET c8 = a.c8 + k * b.c8;
    return lobe_sh9_of(c0, c1, c2, c3, c4, c5, c6, c7, c8);
}

#endif
