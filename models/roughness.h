/* Roughness conventions: every engine has its own, and most wrong pictures come from a silent mix-up.
 * Here `roughness` is perceptual, in [0, 1], and alpha, the GGX width, is its square. Each function takes or gives
 * that roughness; inputs are clamped to the stated range and a NaN counts as its lower end. */
#ifndef LOBE_ROUGHNESS_H
#define LOBE_ROUGHNESS_H
#include "../core/scalar.h"
#include "../core/sqrt.h"

/* alpha = roughness^2 (Burley 2012; Unreal, Unity, Filament, glTF). 1 operation. */
LOBE_FN lobe_real lobe_alpha_of_roughness(lobe_real roughness)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET alpha = r * r;
    return alpha;
}

/* Where a source feeds alpha directly (pbrt, Mitsuba, MaterialX). alpha in [0, 1]. 4 operations. */
LOBE_FN lobe_real lobe_roughness_of_alpha(lobe_real alpha) { return lobe_sqrt(lobe_saturate(alpha)); }

/* Smoothness of Unity, glossiness of the specular workflow: 1 - roughness. 1 operation, its own inverse. */
LOBE_FN lobe_real lobe_roughness_of_smoothness(lobe_real smoothness)
{
    LOBE_LET roughness = LOBE_R(1.0) - lobe_saturate(smoothness);
    return roughness;
}

/* Gloss with alpha = (1 - gloss)^4 (the listing of Narkowicz 2014, after Lazarov 2013). 2 operations. */
LOBE_FN lobe_real lobe_roughness_of_gloss(lobe_real gloss)
{
    LOBE_LET m = LOBE_R(1.0) - lobe_saturate(gloss);
    LOBE_LET roughness = m * m;
    return roughness;
}

/* Its inverse, 1 - sqrt(roughness). 5 operations. */
LOBE_FN lobe_real lobe_gloss_of_roughness(lobe_real roughness)
{
    LOBE_LET gloss = LOBE_R(1.0) - lobe_sqrt(lobe_saturate(roughness));
    return gloss;
}

/* Blinn-Phong exponent n, alpha = sqrt(2 / (n + 2)) (Walter et al. 2007). n in [0, 1e9]; infinity gives the
 * roughness of 1e9, which is .0067. 13 operations. */
LOBE_FN lobe_real lobe_roughness_of_phong(lobe_real exponent)
{
    LOBE_LET n = lobe_clamp(exponent, LOBE_R(0.0), LOBE_R(1e9));
    LOBE_LET alpha2 = LOBE_R(2.0) / (n + LOBE_R(2.0));
    LOBE_LET alpha = lobe_sqrt(alpha2);
    return lobe_sqrt(alpha);
}

/* Its inverse, n = 2 / alpha^2 - 2, for a roughness in [.0067, 1]. 8 operations. */
LOBE_FN lobe_real lobe_phong_of_roughness(lobe_real roughness)
{
    LOBE_LET r = lobe_clamp(roughness, LOBE_R(0.0067), LOBE_R(1.0));
    LOBE_LET a = r * r;
    LOBE_LET exponent = LOBE_R(2.0) / (a * a) - LOBE_R(2.0);
    return exponent;
}

#endif
