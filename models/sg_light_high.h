/* Spherical Gaussian light at two t: see sg_light.h for the terms and their names. */
#ifndef LOBE_SG_LIGHT_HIGH_H
#define LOBE_SG_LIGHT_HIGH_H
#include "sg_light.h"
#include "coeffs/sg_light_high.h"

/* What one t gives, but for what both have in common. lobe, lobe_g and far as in medium, y the offset, seen 2 (v.h)^2
 * of the lobe's middle; e the light's width times t, slope and tail of the exponent. */
LOBE_FN lobe_real lobe_sg_part(lobe_real e, lobe_real lobe, lobe_real lobe_g, lobe_real y, lobe_real seen,
                               lobe_real slope, lobe_real tail)
{
    LOBE_LET along = e + lobe;
    LOBE_LET aside = e + e + lobe_g;
    LOBE_LET q = along * aside;
    LOBE_LET fall = e * e * slope / (q + tail * y);
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
    LOBE_LET g = across + h * h;       /* |v + axis|^2 */
    LOBE_LET far = across + off * off; /* |mirror direction - axis|^2 */
    LOBE_LET lobe = a2 + a2;
    LOBE_LET lobe_g = a2 * g;
    LOBE_LET y = lobe * (b * across);
    LOBE_LET root_v = lobe_sqrt(a2 + b * (v * v));
    LOBE_LET vh = LOBE_SG_LIGHT_HIGH_C3 * v + LOBE_SG_LIGHT_HIGH_C4 * root_v;
    LOBE_LET seen = vh * vh;
    LOBE_LET slope = LOBE_SG_LIGHT_HIGH_C7 * far / w;
    LOBE_LET narrow = lobe_sg_part(LOBE_SG_LIGHT_HIGH_C8 * w, lobe, lobe_g, y, seen, slope, LOBE_SG_LIGHT_HIGH_C5);
    LOBE_LET wide = lobe_sg_part(LOBE_SG_LIGHT_HIGH_C9 * w, lobe, lobe_g, y, seen, slope, LOBE_SG_LIGHT_HIGH_C6);
    LOBE_LET sum = narrow + LOBE_SG_LIGHT_HIGH_C10 * (wide - narrow);
    /* the height of the middle of the product, with a round corner at the horizon */
    LOBE_LET e = LOBE_SG_LIGHT_HIGH_C1 * w;
    LOBE_LET inverse = LOBE_R(1.0) / (e + lobe);
    LOBE_LET z0 = (lobe * l + e * (LOBE_SG_LIGHT_HIGH_C11 * v + LOBE_SG_LIGHT_HIGH_C12 * root_v)) * inverse;
    LOBE_LET corner = LOBE_SG_LIGHT_HIGH_C0 * (w * lobe * inverse);
    LOBE_LET z = LOBE_R(0.5) * (z0 + lobe_sqrt(z0 * z0 + corner));
    LOBE_LET m = lobe_sphere_mask(a2, b, v, root_v, z);
    LOBE_LET top = (w + w) * (sum * z);
    LOBE_LET radiance = lobe_saturate(top / (m * (LOBE_R(1.0) + LOBE_SG_LIGHT_HIGH_C2 * w) + LOBE_R(1e-36)));
    return radiance;
}

#endif
