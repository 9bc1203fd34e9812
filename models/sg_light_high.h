/* Spherical Gaussian light at two t: see sg_light.h for the terms and their names. */
#ifndef LOBE_SG_LIGHT_HIGH_H
#define LOBE_SG_LIGHT_HIGH_H
#include "sg_light.h"
#include "coeffs/sg_light_high.h"

/* What one t gives, but for what both have in common. widest is the light's width at t = 1, y the offset, seen (v.h)^2
 * of the lobe's middle, slope times the width the Gaussian of the light's distance, tail its own. */
LOBE_FN lobe_real lobe_sg_part(lobe_real widest, lobe_real count, lobe_real slope, lobe_real tail, lobe_real aside_e,
                               lobe_real a2, lobe_real lobe_g, lobe_real y, lobe_real seen)
{
    LOBE_LET q0 = (a2 + widest) * (lobe_g + aside_e * widest);
    LOBE_LET counts = q0 / (q0 + count * y); /* the t that counts */
    LOBE_LET e = widest * counts;
    LOBE_LET aside = lobe_g + aside_e * e;
    LOBE_LET q = (a2 + e) * aside;
    LOBE_LET fall = e * counts * slope / (q + tail * y);
    LOBE_LET spread = lobe_sqrt((lobe_g + seen * e) * aside);
    LOBE_LET t = q + y;
    LOBE_LET part = spread * q * lobe_exp2(-fall) / (t * t + LOBE_R(1e-36));
    return part;
}

LOBE_FN lobe_real lobe_sg_light_high(LOBE_COEFFS lobe_real roughness, lobe_sg light)
{
    lobe_sg s = lobe_sg_clamped(light);
    LOBE_LET across = LOBE_R(4.0) * s.tangent2; /* of v + axis */
    LOBE_LET v = s.n_dot_v;
    LOBE_LET l = s.n_dot_l;
    LOBE_LET w = s.versine;
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET a2 = a * a;
    LOBE_LET b = LOBE_R(1.0) - a2;
    LOBE_LET h = v + l;
    LOBE_LET off = v - l;
    LOBE_LET far = across + off * off;       /* |mirror direction - axis|^2 */
    LOBE_LET lobe_g = a2 * (across + h * h); /* of |v + axis|^2 */
    LOBE_LET y = a2 * (b * across);
    LOBE_LET root_v = lobe_sqrt(a2 + b * (v * v));
    LOBE_LET vh = LOBE_SG_LIGHT_HIGH_C3 * v + LOBE_SG_LIGHT_HIGH_C4 * root_v;
    LOBE_LET seen = vh * vh;
    LOBE_LET narrow = lobe_sg_part(LOBE_SG_LIGHT_HIGH_C5 * w, LOBE_SG_LIGHT_HIGH_C6, LOBE_SG_LIGHT_HIGH_C7 * far,
                                   LOBE_SG_LIGHT_HIGH_C8, LOBE_SG_LIGHT_HIGH_C12, a2, lobe_g, y, seen);
    LOBE_LET wide = lobe_sg_part(LOBE_SG_LIGHT_HIGH_C9 * w, LOBE_SG_LIGHT_HIGH_C10, LOBE_SG_LIGHT_HIGH_C11 * far,
                                 LOBE_R(0.0), LOBE_SG_LIGHT_HIGH_C12, a2, lobe_g, y, seen);
    LOBE_LET sum = narrow + LOBE_SG_LIGHT_HIGH_C13 * (wide - narrow);
    /* the height of the middle of the product, with a round corner at the horizon */
    LOBE_LET e = LOBE_SG_LIGHT_HIGH_C1 * w;
    LOBE_LET inverse = LOBE_R(1.0) / (e + a2);
    LOBE_LET z0 = (a2 * l + e * (LOBE_SG_LIGHT_HIGH_C14 * v + LOBE_SG_LIGHT_HIGH_C15 * root_v)) * inverse;
    LOBE_LET corner = LOBE_SG_LIGHT_HIGH_C0 * (w * a2 * inverse);
    LOBE_LET z = LOBE_R(0.5) * (z0 + lobe_sqrt(z0 * z0 + corner));
    LOBE_LET m = lobe_sphere_mask(a2, b, v, root_v, z);
    LOBE_LET top = w * (sum * z);
    LOBE_LET radiance = lobe_saturate(top / (m * (LOBE_R(1.0) + LOBE_SG_LIGHT_HIGH_C2 * w) + LOBE_R(1e-36)));
    return radiance;
}

#endif
