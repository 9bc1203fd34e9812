/* Smith's masking and shadowing for GGX. V is the visibility that a BRDF uses, G2 / (4 (n.v) (n.l)), so that
 * f = D V F: written without a division by the cosines it stays accurate down to grazing angles.
 * Source: Heitz, "Understanding the Masking-Shadowing Function" (JCGT 3(2), 2014), eq. 99 (height-correlated) and 98
 * (separable); Karis, "Real Shading in Unreal Engine 4" (2013) for Schlick's form.
 *
 * Inputs are clamped as ggx.h says: alpha to [1e-8, 1], cosines to [0, 1], a NaN to the lower end. */
#ifndef LOBE_SMITH_H
#define LOBE_SMITH_H
#include "ggx.h"

/* G1 = 1 / (1 + Lambda), in [0, 1]: the visible part of the microsurface. Error in float: 2 ulp. */
LOBE_FN lobe_real lobe_smith_g1(lobe_real alpha, lobe_real cosine)
{
    LOBE_LET c = lobe_saturate(cosine);
    LOBE_LET g = LOBE_R(2.0) * c / (c + lobe_ggx_root(alpha, c));
    return g;
}

/* Height-correlated: V = 1/2 / (l root(v) + v root(l)), G2 = 1 / (1 + Lambda(v) + Lambda(l)).
 * Both cosines zero, where the limit is infinite, gives a finite 5e29. Error in float: 3 ulp.
 * Operations: 7 add, 10 mul, 1 div, 2 sqrt, 13 min/max. */
LOBE_FN lobe_real lobe_smith_v_correlated(lobe_real alpha, lobe_real n_dot_v, lobe_real n_dot_l)
{
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET l = lobe_saturate(n_dot_l);
    LOBE_LET w = l * lobe_ggx_root(alpha, v) + v * lobe_ggx_root(alpha, l);
    LOBE_LET y = LOBE_R(0.5) / lobe_max(w, LOBE_R(1e-30));
    return y;
}

/* Separable: V = 1 / ((v + root(v)) (l + root(l))), G2 = G1(v) G1(l). At most 1e16. Error in float: 4.5 ulp. */
LOBE_FN lobe_real lobe_smith_v_separable(lobe_real alpha, lobe_real n_dot_v, lobe_real n_dot_l)
{
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET l = lobe_saturate(n_dot_l);
    LOBE_LET y = LOBE_R(1.0) / ((v + lobe_ggx_root(alpha, v)) * (l + lobe_ggx_root(alpha, l)));
    return y;
}

/* Schlick's approximation of the separable form, V = 1/4 / ((v (1 - k) + k) (l (1 - k) + k)), with k of the caller's
 * choice: alpha / 2 is closest to Smith, (roughness + 1)^2 / 8 is the "hotness remapping" for point lights. k is
 * clamped to [1e-8, 1]. Error in float: 3 ulp. */
LOBE_FN lobe_real lobe_smith_v_schlick(lobe_real k, lobe_real n_dot_v, lobe_real n_dot_l)
{
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET l = lobe_saturate(n_dot_l);
    LOBE_LET q = lobe_ggx_alpha(k);
    LOBE_LET gv = v * (LOBE_R(1.0) - q) + q;
    LOBE_LET gl = l * (LOBE_R(1.0) - q) + q;
    LOBE_LET y = LOBE_R(0.25) / (gv * gl);
    return y;
}

#endif
