/* The GGX distribution of microfacet normals (Trowbridge-Reitz), isotropic.
 * Source: Walter et al., "Microfacet Models for Refraction through Rough Surfaces" (EGSR 2007), eq. 33; visible
 * normals: Heitz, "Sampling the GGX Distribution of Visible Normals" (JCGT 7(4), 2018), eq. 3.
 *
 * alpha is the width, the square of perceptual roughness. It is clamped to [1e-8, 1], so that a mirror stays finite;
 * cosines are clamped to [0, 1] and a NaN counts as 0 (as 1e-8 for alpha). */
#ifndef LOBE_GGX_H
#define LOBE_GGX_H
#include "sqrt.h"

LOBE_FN lobe_real lobe_ggx_alpha(lobe_real alpha) { return lobe_clamp(alpha, LOBE_R(1e-8), LOBE_R(1.0)); }

/* D(h), in 1/steradian: the integral of D(h) (n.h) over the hemisphere is 1. In (0, 3.2e15].
 *   D = alpha^2 / (pi ((n.h)^2 (alpha^2 - 1) + 1)^2)
 * The bracket is computed as (1 - c)(1 + c) + (c alpha)^2, which cancels nothing at small alpha. Error in float:
 * 4.5 ulp in terms of the given cosine. Near c = 1 and alpha < 0.01 a float cosine is the limit, not this formula; who
 * has the half vector calls lobe_ggx_d_sine. Operations: 3 add, 6 mul, 1 div, 4 min/max. */
LOBE_FN lobe_real lobe_ggx_d_sine(lobe_real alpha, lobe_real cosine2, lobe_real sine2)
{
    LOBE_LET a = lobe_ggx_alpha(alpha);
    LOBE_LET a2 = a * a;
    LOBE_LET t = sine2 + cosine2 * a2;
    LOBE_LET d = LOBE_R(0.318309886183790672) * (a2 / (t * t));
    return d;
}

LOBE_FN lobe_real lobe_ggx_d(lobe_real alpha, lobe_real n_dot_h)
{
    LOBE_LET c = lobe_saturate(n_dot_h);
    LOBE_LET c2 = c * c;
    LOBE_LET s2 = (LOBE_R(1.0) - c) * (LOBE_R(1.0) + c);
    return lobe_ggx_d_sine(alpha, c2, s2);
}

/* sqrt(c^2 + alpha^2 (1 - c^2)): the root in every Smith term, in [alpha, 1].
 * Operations: 3 add, 4 mul, 1 sqrt, 4 min/max. */
LOBE_FN lobe_real lobe_ggx_root(lobe_real alpha, lobe_real c)
{
    LOBE_LET a = lobe_ggx_alpha(alpha);
    LOBE_LET s = c * c + a * a * ((LOBE_R(1.0) - c) * (LOBE_R(1.0) + c));
    return lobe_sqrt(s);
}

/* Smith's Lambda = (sqrt(1 + alpha^2 tan^2) - 1) / 2, in [0, alpha / (2 * 1e-8)]: the masked over the visible
 * projected area. Cosines below 1e-8 count as 1e-8.
 *   root - c = alpha^2 (1 - c^2) / (root + c), which does not cancel at normal incidence. */
LOBE_FN lobe_real lobe_ggx_lambda(lobe_real alpha, lobe_real cosine)
{
    LOBE_LET c = lobe_clamp(cosine, LOBE_R(1e-8), LOBE_R(1.0));
    LOBE_LET a = lobe_ggx_alpha(alpha);
    LOBE_LET area = a * a * ((LOBE_R(1.0) - c) * (LOBE_R(1.0) + c));
    LOBE_LET l = area / ((lobe_ggx_root(a, c) + c) * (LOBE_R(2.0) * c));
    return l;
}

/* The density of normals that are visible from v: G1(v) max(0, v.h) D(h) / (n.v), which integrates to 1 over h.
 * No division by n.v: G1(v) / (n.v) = 2 / (n.v + root). For the reflected direction divide by 4 (v.h). */
LOBE_FN lobe_real lobe_ggx_visible_density(lobe_real alpha, lobe_real n_dot_v, lobe_real n_dot_h, lobe_real v_dot_h)
{
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET p = lobe_ggx_d(alpha, n_dot_h) * (LOBE_R(2.0) * lobe_saturate(v_dot_h)) / (v + lobe_ggx_root(alpha, v));
    return p;
}

#endif
