/* From split-sum terms to a reflectance: what a renderer does with f0 and f90. */
#ifndef LOBE_REFLECTANCE_H
#define LOBE_REFLECTANCE_H
#include "dfg.h"

/* Directional albedo of one colour channel, f0 * scale + f90 * bias.
 * f0, f90 in [0, 1] (clamped, NaN counts as 0); result in [0, 1]. Adds at most 2 ulp to the error of the terms.
 * 2 operations. Schlick 1994 with the exponent 5 that the terms were integrated with. */
LOBE_FN lobe_real lobe_reflectance(lobe_dfg d, lobe_real f0, lobe_real f90)
{
    LOBE_LET sum = lobe_saturate(f0) * d.scale + lobe_saturate(f90) * d.bias;
    return lobe_saturate(sum);
}

/* The 2 % rule: no real dielectric reflects less than 2 % at normal incidence, so a lower f0 is an artist's
 * occlusion and fades the grazing reflectance too. f90 = min(1, 50 f0); feed it the largest channel of f0.
 * 1 operation. Source: Hoffman 2012, Lagarde and de Rousiers 2014. */
LOBE_FN lobe_real lobe_f90_of_f0(lobe_real f0)
{
    LOBE_LET f90 = LOBE_R(50.0) * lobe_saturate(f0);
    return lobe_saturate(f90);
}

#endif
