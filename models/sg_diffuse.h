/* The diffuse part of a spherical Gaussian light of amplitude 1: irradiance over pi, int exp((l.axis - 1) / versine)
 * max(n.l, 0) / pi dl, in (0, 2 versine). n_dot_l is the height of the axis in [-1, 1], versine is 1 / sharpness in (0,
 * 4]; both are held there, NaN counts as the lower end. Derived in cases/sg_light/README.md. */
#ifndef LOBE_SG_DIFFUSE_H
#define LOBE_SG_DIFFUSE_H
#include "../core/exp2.h"
#include "../core/sqrt.h"
#include "coeffs/sg_diffuse_high.h"

/* The mean of n.l over the whole light is elementary, A c. The mean of |n.l| is even in c; of a narrow light it is
 * that of a normal distribution, whose square is x^2 + 2 / pi exp(-.57 x^2) within 1e-3: so it is here. What is lit is
 * half the sum. */
LOBE_FN lobe_real lobe_sg_diffuse_high(LOBE_COEFFS lobe_real n_dot_l, lobe_real versine)
{
    LOBE_LET c = lobe_clamp(n_dot_l, LOBE_R(-1.0), LOBE_R(1.0));
    LOBE_LET w = lobe_clamp(versine, LOBE_R(1e-6), LOBE_R(2.0));
    LOBE_LET sharp = LOBE_R(1.0) / w;
    LOBE_LET behind = lobe_exp2(LOBE_R(-2.88539008) * sharp); /* exp(-2 / versine): what the light has there */
    LOBE_LET whole = LOBE_R(1.0) - behind;
    LOBE_LET ac = c * (LOBE_R(1.0) + behind - whole * w);
    LOBE_LET even = w * (w + LOBE_SG_DIFFUSE_HIGH_C0) /
                    (w * (LOBE_R(4.0) * w + LOBE_SG_DIFFUSE_HIGH_C1) + LOBE_R(1.57079633) * LOBE_SG_DIFFUSE_HIGH_C0);
    LOBE_LET fall = LOBE_SG_DIFFUSE_HIGH_C2 * (c * c) * sharp / (LOBE_R(1.0) + LOBE_SG_DIFFUSE_HIGH_C3 * w);
    LOBE_LET square = ac * ac + whole * whole * (even * lobe_exp2(-fall));
    LOBE_LET y = w * lobe_max(ac + lobe_sqrt(square), LOBE_R(0.0));
    return y;
}

/* The inner product with an SG that stands for the cosine, sharpness 2.133 and amplitude 1.17: what engines do that
 * have SGs for everything. 17 % off where the light is narrow. */
LOBE_FN lobe_real lobe_sg_diffuse_inner(lobe_real n_dot_l, lobe_real versine)
{
    LOBE_LET c = lobe_clamp(n_dot_l, LOBE_R(-1.0), LOBE_R(1.0));
    LOBE_LET w = lobe_clamp(versine, LOBE_R(1e-6), LOBE_R(2.0));
    LOBE_LET t = LOBE_R(2.133) * w;
    LOBE_LET length = lobe_sqrt(LOBE_R(1.0) + t * (t + LOBE_R(2.0) * c)); /* of the sum of the axes, times versine */
    LOBE_LET most = LOBE_R(1.0) + t;
    /* length - most without the difference of two numbers near 1 */
    LOBE_LET less = LOBE_R(2.0) * t * (c - LOBE_R(1.0)) / (length + most);
    LOBE_LET whole = LOBE_R(1.0) - lobe_exp2(LOBE_R(-2.88539008) * length / w);
    LOBE_LET y = LOBE_R(2.34) * w * (whole * lobe_exp2(LOBE_R(1.44269504) * less / w)) / (length + LOBE_R(1e-6));
    return y;
}

#endif
