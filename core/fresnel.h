/* Schlick's Fresnel: f0 + (f90 - f0) (1 - cos)^5. C. Schlick, "An Inexpensive BRDF Model for Physically-based
 * Rendering" (1994), eq. 15. */
#ifndef LOBE_FRESNEL_H
#define LOBE_FRESNEL_H
#include "power.h"

/* (1 - cos)^5 in [0, 1], the weight of f90; the cosine is clamped to [0, 1], NaN counts as 0.
 * Error: relative, 9 * 2^-24 where the result is normal. Operations: 1 add, 3 mul, 2 min/max. */
LOBE_FN lobe_real lobe_schlick_weight(lobe_real cosine)
{
    LOBE_LET x = LOBE_R(1.0) - lobe_saturate(cosine);
    return lobe_pow5(x);
}

/* The mix, exact at both ends: f0 at cosine 1 and f90 at cosine 0. Operations: 3 add, 5 mul, 2 min/max. */
LOBE_FN lobe_real lobe_schlick(lobe_real f0, lobe_real f90, lobe_real cosine)
{
    LOBE_LET w = lobe_schlick_weight(cosine);
    LOBE_LET f = f0 * (LOBE_R(1.0) - w) + f90 * w;
    return f;
}

#endif
