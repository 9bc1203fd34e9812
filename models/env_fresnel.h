/* Schlick's Fresnel on a fan of taps (env_lobes.h): what the split sum's bias is made of, tap by tap. Taps that look
 * towards the horizon have most of it, and one factor on the whole colour would give them the same as the others.
 *
 * With x = (1 - v.h)^5 of every tap, w its weight, E the weights' sum and B the bias of a split sum, f90's part of a
 * tap is
 *     b = w (B / E + 5/4 (x - sum w x / E)),   and f0's is w - b,
 * so that the parts sum to B and to E - B, and at f0 = f90 there is no Fresnel. h is the half vector of view and tap,
 * its cosine taken at the mean of a wide tap: v.l (1 - width^4). Differences, no quotients: sums of x with weights of
 * both signs may pass 0. 5/4 and width^4 by the fit's own environments: cases/env_lobes, fresnel.csv. */
#ifndef LOBE_ENV_FRESNEL_H
#define LOBE_ENV_FRESNEL_H
#include "../core/fresnel.h"
#include "../core/sqrt.h"

/* x of a tap. v_dot_tap: cosine between view and tap, [-1, 1]; NaN counts as -1. width as env_lobes has it, [0, 1], NaN
 * counts as 0. 16 operations. */
LOBE_FN lobe_real lobe_env_grazing(lobe_real v_dot_tap, lobe_real width)
{
    LOBE_LET a = lobe_saturate(width) * lobe_saturate(width);
    LOBE_LET c = lobe_clamp(v_dot_tap, LOBE_R(-1.0), LOBE_R(1.0)) * (LOBE_R(1.0) - a * a);
    LOBE_LET h = lobe_sqrt(LOBE_R(0.5) + LOBE_R(0.5) * c);
    return lobe_schlick_weight(h);
}

/* b of a tap, with share = B / E and mean = sum w x / E. 4 operations. */
LOBE_FN lobe_real lobe_env_bias(lobe_real weight, lobe_real grazing, lobe_real mean, lobe_real share)
{
    LOBE_LET bias = weight * (share + LOBE_R(1.25) * (grazing - mean));
    return bias;
}

#endif
