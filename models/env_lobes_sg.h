/* Environment specular by a fan of spherical Gaussians: GGX, height-correlated Smith, F = 1, for an engine that holds
 * its environment prefiltered with SGs, or as SGs. The seed paper's model in two layers: at most eight numbers for a
 * point (cases/env_lobes_sg), from which 1, 2, 4 or 8 lobes follow. The weights sum to the albedo E, so a white furnace
 * is right by construction. The lobes stand in the plane of view and normal.
 *
 *   angle   from the normal, in radians, positive away from the view; a mirror is acos(n_dot_v)
 *   width   sharpness L of the kernel exp(L (c - 1)) L / (2 pi (1 - exp(-2 L))), c the cosine to the lobe
 *   weight  of the kernel, whose integral over the sphere is 1; may be negative: a lobe less what spills below
 *           the horizon
 *
 * With a = alpha = roughness^2, s = sqrt(1 - n_dot_v^2), theta = acos(n_dot_v) and d even in [-1, 1] along the fan
 *     angle = centre + spread d,  centre = theta + a s Th,  spread = clamp(a s Sp, 0, theta),
 *     L = 2^(B + G d - F d^2) / a^2,
 *     weight = E ((1 + n R) g / sum g - R),  g = 2^(T d - K d^2),  n lobes,
 * Th, B, Sp, T, G, R, K and F being sums over the twelve products of env_lobes.h; a single lobe has Th and B alone, two
 * have the first five. Smooth by construction; at n_dot_v = 1 every angle is 0, where there is no plane of incidence.
 * T = G = F = R = 0 is the seed paper's model, with one sharpness for all and positive weights; with F the lobes at
 * n_dot_v = 1 are concentric and make up the tail of GGX. Both inputs are clamped to [0, 1], NaN counts as 0; below
 * roughness .1 (alpha .01) the sharpness stays what it is there. */
#ifndef LOBE_ENV_LOBES_SG_H
#define LOBE_ENV_LOBES_SG_H
#include "env_lobes.h"
#include "coeffs/env_lobes_sg_lobes1.h"
#include "coeffs/env_lobes_sg_lobes2.h"
#include "coeffs/env_lobes_sg_lobes4.h"
#include "coeffs/env_lobes_sg_lobes8.h"

LOBE_STRUCT(lobe_env_sg_fan)
{
    lobe_real centre;
    lobe_real spread;
    lobe_real level; /* sharpness as a power of 2, times a^2 */
    lobe_real tilt;
    lobe_real lean;
    lobe_real rim;
    lobe_real taper;
    lobe_real flare;
};

LOBE_STRUCT(lobe_env_sg2)
{
    lobe_env_tap t0;
    lobe_env_tap t1;
};

LOBE_STRUCT(lobe_env_sg4)
{
    lobe_env_tap t0;
    lobe_env_tap t1;
    lobe_env_tap t2;
    lobe_env_tap t3;
};

LOBE_STRUCT(lobe_env_sg8)
{
    lobe_env_tap t0;
    lobe_env_tap t1;
    lobe_env_tap t2;
    lobe_env_tap t3;
    lobe_env_tap t4;
    lobe_env_tap t5;
    lobe_env_tap t6;
    lobe_env_tap t7;
};

/* What follows from the sums. The limits keep every power finite; no fit comes near. */
LOBE_FN lobe_env_sg_fan lobe_env_sg_fan_of(lobe_env_point p, lobe_real shift, lobe_real level, lobe_real spread,
                                           lobe_real tilt, lobe_real lean, lobe_real rim, lobe_real taper,
                                           lobe_real flare)
{
    LOBE_LET centre = p.theta + p.reach * shift;
    LOBE_LET wide = p.reach * spread;
    lobe_env_sg_fan f;
    f.centre = centre;
    f.spread = lobe_clamp(wide, LOBE_R(0.0), p.theta);
    f.level = lobe_clamp(level, LOBE_R(-4.0), LOBE_R(8.0));
    f.tilt = lobe_clamp(tilt, LOBE_R(-12.0), LOBE_R(12.0));
    f.lean = lobe_clamp(lean, LOBE_R(-8.0), LOBE_R(8.0));
    f.rim = lobe_clamp(rim, LOBE_R(-0.1), LOBE_R(2.0));
    f.taper = lobe_clamp(taper, LOBE_R(-12.0), LOBE_R(24.0));
    f.flare = lobe_clamp(flare, LOBE_R(-4.0), LOBE_R(12.0));
    return f;
}

/* The lobe at d in [-1, 1]; its weight is g. */
LOBE_FN lobe_env_tap lobe_env_sg_tap_of(lobe_env_sg_fan f, lobe_real a, lobe_real d)
{
    LOBE_LET d2 = d * d;
    LOBE_LET angle = f.centre + f.spread * d;
    LOBE_LET narrow = lobe_max(a, LOBE_R(0.01));
    LOBE_LET level = f.level + f.lean * d - f.flare * d2;
    LOBE_LET width = lobe_exp2(level) / (narrow * narrow);
    LOBE_LET height = f.tilt * d - f.taper * d2;
    lobe_env_tap tap;
    tap.angle = angle;
    tap.width = width;
    tap.weight = lobe_exp2(height);
    return tap;
}

LOBE_FN lobe_env_tap lobe_env_sg_weighed(lobe_env_tap t, lobe_real factor, lobe_real less)
{
    LOBE_LET weight = t.weight * factor - less;
    lobe_env_tap tap;
    tap.angle = t.angle;
    tap.width = t.width;
    tap.weight = weight;
    return tap;
}

/* One lobe: 24 coefficients. */
LOBE_FN lobe_env_tap lobe_env_lobes_sg_lobes1(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v, lobe_real albedo)
{
    lobe_env_point at = lobe_env_point_of(roughness, n_dot_v);
    LOBE_LET e = lobe_saturate(albedo);
    LOBE_LET zero = LOBE_R(0.0);
    LOBE_LET shift =
        lobe_env_sum(at, LOBE_ENV_LOBES_SG_LOBES1_C0, LOBE_ENV_LOBES_SG_LOBES1_C1, LOBE_ENV_LOBES_SG_LOBES1_C2,
                     LOBE_ENV_LOBES_SG_LOBES1_C3, LOBE_ENV_LOBES_SG_LOBES1_C4, LOBE_ENV_LOBES_SG_LOBES1_C5,
                     LOBE_ENV_LOBES_SG_LOBES1_C6, LOBE_ENV_LOBES_SG_LOBES1_C7, LOBE_ENV_LOBES_SG_LOBES1_C8,
                     LOBE_ENV_LOBES_SG_LOBES1_C9, LOBE_ENV_LOBES_SG_LOBES1_C10, LOBE_ENV_LOBES_SG_LOBES1_C11);
    LOBE_LET level =
        lobe_env_sum(at, LOBE_ENV_LOBES_SG_LOBES1_C12, LOBE_ENV_LOBES_SG_LOBES1_C13, LOBE_ENV_LOBES_SG_LOBES1_C14,
                     LOBE_ENV_LOBES_SG_LOBES1_C15, LOBE_ENV_LOBES_SG_LOBES1_C16, LOBE_ENV_LOBES_SG_LOBES1_C17,
                     LOBE_ENV_LOBES_SG_LOBES1_C18, LOBE_ENV_LOBES_SG_LOBES1_C19, LOBE_ENV_LOBES_SG_LOBES1_C20,
                     LOBE_ENV_LOBES_SG_LOBES1_C21, LOBE_ENV_LOBES_SG_LOBES1_C22, LOBE_ENV_LOBES_SG_LOBES1_C23);
    lobe_env_sg_fan fan = lobe_env_sg_fan_of(at, shift, level, zero, zero, zero, zero, zero, zero);
    return lobe_env_sg_weighed(lobe_env_sg_tap_of(fan, at.a, zero), e, zero);
}

/* 2 lobes: 60 coefficients. */
LOBE_FN lobe_env_sg2 lobe_env_lobes_sg_lobes2(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v, lobe_real albedo)
{
    lobe_env_point at = lobe_env_point_of(roughness, n_dot_v);
    LOBE_LET e = lobe_saturate(albedo);
    LOBE_LET zero = LOBE_R(0.0);
    LOBE_LET shift =
        lobe_env_sum(at, LOBE_ENV_LOBES_SG_LOBES2_C0, LOBE_ENV_LOBES_SG_LOBES2_C1, LOBE_ENV_LOBES_SG_LOBES2_C2,
                     LOBE_ENV_LOBES_SG_LOBES2_C3, LOBE_ENV_LOBES_SG_LOBES2_C4, LOBE_ENV_LOBES_SG_LOBES2_C5,
                     LOBE_ENV_LOBES_SG_LOBES2_C6, LOBE_ENV_LOBES_SG_LOBES2_C7, LOBE_ENV_LOBES_SG_LOBES2_C8,
                     LOBE_ENV_LOBES_SG_LOBES2_C9, LOBE_ENV_LOBES_SG_LOBES2_C10, LOBE_ENV_LOBES_SG_LOBES2_C11);
    LOBE_LET level =
        lobe_env_sum(at, LOBE_ENV_LOBES_SG_LOBES2_C12, LOBE_ENV_LOBES_SG_LOBES2_C13, LOBE_ENV_LOBES_SG_LOBES2_C14,
                     LOBE_ENV_LOBES_SG_LOBES2_C15, LOBE_ENV_LOBES_SG_LOBES2_C16, LOBE_ENV_LOBES_SG_LOBES2_C17,
                     LOBE_ENV_LOBES_SG_LOBES2_C18, LOBE_ENV_LOBES_SG_LOBES2_C19, LOBE_ENV_LOBES_SG_LOBES2_C20,
                     LOBE_ENV_LOBES_SG_LOBES2_C21, LOBE_ENV_LOBES_SG_LOBES2_C22, LOBE_ENV_LOBES_SG_LOBES2_C23);
    LOBE_LET spread =
        lobe_env_sum(at, LOBE_ENV_LOBES_SG_LOBES2_C24, LOBE_ENV_LOBES_SG_LOBES2_C25, LOBE_ENV_LOBES_SG_LOBES2_C26,
                     LOBE_ENV_LOBES_SG_LOBES2_C27, LOBE_ENV_LOBES_SG_LOBES2_C28, LOBE_ENV_LOBES_SG_LOBES2_C29,
                     LOBE_ENV_LOBES_SG_LOBES2_C30, LOBE_ENV_LOBES_SG_LOBES2_C31, LOBE_ENV_LOBES_SG_LOBES2_C32,
                     LOBE_ENV_LOBES_SG_LOBES2_C33, LOBE_ENV_LOBES_SG_LOBES2_C34, LOBE_ENV_LOBES_SG_LOBES2_C35);
    LOBE_LET tilt =
        lobe_env_sum(at, LOBE_ENV_LOBES_SG_LOBES2_C36, LOBE_ENV_LOBES_SG_LOBES2_C37, LOBE_ENV_LOBES_SG_LOBES2_C38,
                     LOBE_ENV_LOBES_SG_LOBES2_C39, LOBE_ENV_LOBES_SG_LOBES2_C40, LOBE_ENV_LOBES_SG_LOBES2_C41,
                     LOBE_ENV_LOBES_SG_LOBES2_C42, LOBE_ENV_LOBES_SG_LOBES2_C43, LOBE_ENV_LOBES_SG_LOBES2_C44,
                     LOBE_ENV_LOBES_SG_LOBES2_C45, LOBE_ENV_LOBES_SG_LOBES2_C46, LOBE_ENV_LOBES_SG_LOBES2_C47);
    LOBE_LET lean =
        lobe_env_sum(at, LOBE_ENV_LOBES_SG_LOBES2_C48, LOBE_ENV_LOBES_SG_LOBES2_C49, LOBE_ENV_LOBES_SG_LOBES2_C50,
                     LOBE_ENV_LOBES_SG_LOBES2_C51, LOBE_ENV_LOBES_SG_LOBES2_C52, LOBE_ENV_LOBES_SG_LOBES2_C53,
                     LOBE_ENV_LOBES_SG_LOBES2_C54, LOBE_ENV_LOBES_SG_LOBES2_C55, LOBE_ENV_LOBES_SG_LOBES2_C56,
                     LOBE_ENV_LOBES_SG_LOBES2_C57, LOBE_ENV_LOBES_SG_LOBES2_C58, LOBE_ENV_LOBES_SG_LOBES2_C59);
    lobe_env_sg_fan fan = lobe_env_sg_fan_of(at, shift, level, spread, tilt, lean, zero, zero, zero);
    lobe_env_tap t0 = lobe_env_sg_tap_of(fan, at.a, LOBE_R(-1.0));
    lobe_env_tap t1 = lobe_env_sg_tap_of(fan, at.a, LOBE_R(1.0));
    LOBE_LET sum = t0.weight + t1.weight;
    LOBE_LET less = e * fan.rim;
    LOBE_LET factor = (e + LOBE_R(2.0) * less) / sum;
    lobe_env_sg2 lobes;
    lobes.t0 = lobe_env_sg_weighed(t0, factor, less);
    lobes.t1 = lobe_env_sg_weighed(t1, factor, less);
    return lobes;
}

/* 4 lobes: 96 coefficients. */
LOBE_FN lobe_env_sg4 lobe_env_lobes_sg_lobes4(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v, lobe_real albedo)
{
    lobe_env_point at = lobe_env_point_of(roughness, n_dot_v);
    LOBE_LET e = lobe_saturate(albedo);
    LOBE_LET shift =
        lobe_env_sum(at, LOBE_ENV_LOBES_SG_LOBES4_C0, LOBE_ENV_LOBES_SG_LOBES4_C1, LOBE_ENV_LOBES_SG_LOBES4_C2,
                     LOBE_ENV_LOBES_SG_LOBES4_C3, LOBE_ENV_LOBES_SG_LOBES4_C4, LOBE_ENV_LOBES_SG_LOBES4_C5,
                     LOBE_ENV_LOBES_SG_LOBES4_C6, LOBE_ENV_LOBES_SG_LOBES4_C7, LOBE_ENV_LOBES_SG_LOBES4_C8,
                     LOBE_ENV_LOBES_SG_LOBES4_C9, LOBE_ENV_LOBES_SG_LOBES4_C10, LOBE_ENV_LOBES_SG_LOBES4_C11);
    LOBE_LET level =
        lobe_env_sum(at, LOBE_ENV_LOBES_SG_LOBES4_C12, LOBE_ENV_LOBES_SG_LOBES4_C13, LOBE_ENV_LOBES_SG_LOBES4_C14,
                     LOBE_ENV_LOBES_SG_LOBES4_C15, LOBE_ENV_LOBES_SG_LOBES4_C16, LOBE_ENV_LOBES_SG_LOBES4_C17,
                     LOBE_ENV_LOBES_SG_LOBES4_C18, LOBE_ENV_LOBES_SG_LOBES4_C19, LOBE_ENV_LOBES_SG_LOBES4_C20,
                     LOBE_ENV_LOBES_SG_LOBES4_C21, LOBE_ENV_LOBES_SG_LOBES4_C22, LOBE_ENV_LOBES_SG_LOBES4_C23);
    LOBE_LET spread =
        lobe_env_sum(at, LOBE_ENV_LOBES_SG_LOBES4_C24, LOBE_ENV_LOBES_SG_LOBES4_C25, LOBE_ENV_LOBES_SG_LOBES4_C26,
                     LOBE_ENV_LOBES_SG_LOBES4_C27, LOBE_ENV_LOBES_SG_LOBES4_C28, LOBE_ENV_LOBES_SG_LOBES4_C29,
                     LOBE_ENV_LOBES_SG_LOBES4_C30, LOBE_ENV_LOBES_SG_LOBES4_C31, LOBE_ENV_LOBES_SG_LOBES4_C32,
                     LOBE_ENV_LOBES_SG_LOBES4_C33, LOBE_ENV_LOBES_SG_LOBES4_C34, LOBE_ENV_LOBES_SG_LOBES4_C35);
    LOBE_LET tilt =
        lobe_env_sum(at, LOBE_ENV_LOBES_SG_LOBES4_C36, LOBE_ENV_LOBES_SG_LOBES4_C37, LOBE_ENV_LOBES_SG_LOBES4_C38,
                     LOBE_ENV_LOBES_SG_LOBES4_C39, LOBE_ENV_LOBES_SG_LOBES4_C40, LOBE_ENV_LOBES_SG_LOBES4_C41,
                     LOBE_ENV_LOBES_SG_LOBES4_C42, LOBE_ENV_LOBES_SG_LOBES4_C43, LOBE_ENV_LOBES_SG_LOBES4_C44,
                     LOBE_ENV_LOBES_SG_LOBES4_C45, LOBE_ENV_LOBES_SG_LOBES4_C46, LOBE_ENV_LOBES_SG_LOBES4_C47);
    LOBE_LET lean =
        lobe_env_sum(at, LOBE_ENV_LOBES_SG_LOBES4_C48, LOBE_ENV_LOBES_SG_LOBES4_C49, LOBE_ENV_LOBES_SG_LOBES4_C50,
                     LOBE_ENV_LOBES_SG_LOBES4_C51, LOBE_ENV_LOBES_SG_LOBES4_C52, LOBE_ENV_LOBES_SG_LOBES4_C53,
                     LOBE_ENV_LOBES_SG_LOBES4_C54, LOBE_ENV_LOBES_SG_LOBES4_C55, LOBE_ENV_LOBES_SG_LOBES4_C56,
                     LOBE_ENV_LOBES_SG_LOBES4_C57, LOBE_ENV_LOBES_SG_LOBES4_C58, LOBE_ENV_LOBES_SG_LOBES4_C59);
    LOBE_LET rim =
        lobe_env_sum(at, LOBE_ENV_LOBES_SG_LOBES4_C60, LOBE_ENV_LOBES_SG_LOBES4_C61, LOBE_ENV_LOBES_SG_LOBES4_C62,
                     LOBE_ENV_LOBES_SG_LOBES4_C63, LOBE_ENV_LOBES_SG_LOBES4_C64, LOBE_ENV_LOBES_SG_LOBES4_C65,
                     LOBE_ENV_LOBES_SG_LOBES4_C66, LOBE_ENV_LOBES_SG_LOBES4_C67, LOBE_ENV_LOBES_SG_LOBES4_C68,
                     LOBE_ENV_LOBES_SG_LOBES4_C69, LOBE_ENV_LOBES_SG_LOBES4_C70, LOBE_ENV_LOBES_SG_LOBES4_C71);
    LOBE_LET taper =
        lobe_env_sum(at, LOBE_ENV_LOBES_SG_LOBES4_C72, LOBE_ENV_LOBES_SG_LOBES4_C73, LOBE_ENV_LOBES_SG_LOBES4_C74,
                     LOBE_ENV_LOBES_SG_LOBES4_C75, LOBE_ENV_LOBES_SG_LOBES4_C76, LOBE_ENV_LOBES_SG_LOBES4_C77,
                     LOBE_ENV_LOBES_SG_LOBES4_C78, LOBE_ENV_LOBES_SG_LOBES4_C79, LOBE_ENV_LOBES_SG_LOBES4_C80,
                     LOBE_ENV_LOBES_SG_LOBES4_C81, LOBE_ENV_LOBES_SG_LOBES4_C82, LOBE_ENV_LOBES_SG_LOBES4_C83);
    LOBE_LET flare =
        lobe_env_sum(at, LOBE_ENV_LOBES_SG_LOBES4_C84, LOBE_ENV_LOBES_SG_LOBES4_C85, LOBE_ENV_LOBES_SG_LOBES4_C86,
                     LOBE_ENV_LOBES_SG_LOBES4_C87, LOBE_ENV_LOBES_SG_LOBES4_C88, LOBE_ENV_LOBES_SG_LOBES4_C89,
                     LOBE_ENV_LOBES_SG_LOBES4_C90, LOBE_ENV_LOBES_SG_LOBES4_C91, LOBE_ENV_LOBES_SG_LOBES4_C92,
                     LOBE_ENV_LOBES_SG_LOBES4_C93, LOBE_ENV_LOBES_SG_LOBES4_C94, LOBE_ENV_LOBES_SG_LOBES4_C95);
    lobe_env_sg_fan fan = lobe_env_sg_fan_of(at, shift, level, spread, tilt, lean, rim, taper, flare);
    lobe_env_tap t0 = lobe_env_sg_tap_of(fan, at.a, LOBE_R(-1.0));
    lobe_env_tap t1 = lobe_env_sg_tap_of(fan, at.a, LOBE_R(-0.3333333333333333));
    lobe_env_tap t2 = lobe_env_sg_tap_of(fan, at.a, LOBE_R(0.3333333333333333));
    lobe_env_tap t3 = lobe_env_sg_tap_of(fan, at.a, LOBE_R(1.0));
    LOBE_LET sum = t0.weight + t1.weight + t2.weight + t3.weight;
    LOBE_LET less = e * fan.rim;
    LOBE_LET factor = (e + LOBE_R(4.0) * less) / sum;
    lobe_env_sg4 lobes;
    lobes.t0 = lobe_env_sg_weighed(t0, factor, less);
    lobes.t1 = lobe_env_sg_weighed(t1, factor, less);
    lobes.t2 = lobe_env_sg_weighed(t2, factor, less);
    lobes.t3 = lobe_env_sg_weighed(t3, factor, less);
    return lobes;
}

/* 8 lobes: 96 coefficients. */
LOBE_FN lobe_env_sg8 lobe_env_lobes_sg_lobes8(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v, lobe_real albedo)
{
    lobe_env_point at = lobe_env_point_of(roughness, n_dot_v);
    LOBE_LET e = lobe_saturate(albedo);
    LOBE_LET shift =
        lobe_env_sum(at, LOBE_ENV_LOBES_SG_LOBES8_C0, LOBE_ENV_LOBES_SG_LOBES8_C1, LOBE_ENV_LOBES_SG_LOBES8_C2,
                     LOBE_ENV_LOBES_SG_LOBES8_C3, LOBE_ENV_LOBES_SG_LOBES8_C4, LOBE_ENV_LOBES_SG_LOBES8_C5,
                     LOBE_ENV_LOBES_SG_LOBES8_C6, LOBE_ENV_LOBES_SG_LOBES8_C7, LOBE_ENV_LOBES_SG_LOBES8_C8,
                     LOBE_ENV_LOBES_SG_LOBES8_C9, LOBE_ENV_LOBES_SG_LOBES8_C10, LOBE_ENV_LOBES_SG_LOBES8_C11);
    LOBE_LET level =
        lobe_env_sum(at, LOBE_ENV_LOBES_SG_LOBES8_C12, LOBE_ENV_LOBES_SG_LOBES8_C13, LOBE_ENV_LOBES_SG_LOBES8_C14,
                     LOBE_ENV_LOBES_SG_LOBES8_C15, LOBE_ENV_LOBES_SG_LOBES8_C16, LOBE_ENV_LOBES_SG_LOBES8_C17,
                     LOBE_ENV_LOBES_SG_LOBES8_C18, LOBE_ENV_LOBES_SG_LOBES8_C19, LOBE_ENV_LOBES_SG_LOBES8_C20,
                     LOBE_ENV_LOBES_SG_LOBES8_C21, LOBE_ENV_LOBES_SG_LOBES8_C22, LOBE_ENV_LOBES_SG_LOBES8_C23);
    LOBE_LET spread =
        lobe_env_sum(at, LOBE_ENV_LOBES_SG_LOBES8_C24, LOBE_ENV_LOBES_SG_LOBES8_C25, LOBE_ENV_LOBES_SG_LOBES8_C26,
                     LOBE_ENV_LOBES_SG_LOBES8_C27, LOBE_ENV_LOBES_SG_LOBES8_C28, LOBE_ENV_LOBES_SG_LOBES8_C29,
                     LOBE_ENV_LOBES_SG_LOBES8_C30, LOBE_ENV_LOBES_SG_LOBES8_C31, LOBE_ENV_LOBES_SG_LOBES8_C32,
                     LOBE_ENV_LOBES_SG_LOBES8_C33, LOBE_ENV_LOBES_SG_LOBES8_C34, LOBE_ENV_LOBES_SG_LOBES8_C35);
    LOBE_LET tilt =
        lobe_env_sum(at, LOBE_ENV_LOBES_SG_LOBES8_C36, LOBE_ENV_LOBES_SG_LOBES8_C37, LOBE_ENV_LOBES_SG_LOBES8_C38,
                     LOBE_ENV_LOBES_SG_LOBES8_C39, LOBE_ENV_LOBES_SG_LOBES8_C40, LOBE_ENV_LOBES_SG_LOBES8_C41,
                     LOBE_ENV_LOBES_SG_LOBES8_C42, LOBE_ENV_LOBES_SG_LOBES8_C43, LOBE_ENV_LOBES_SG_LOBES8_C44,
                     LOBE_ENV_LOBES_SG_LOBES8_C45, LOBE_ENV_LOBES_SG_LOBES8_C46, LOBE_ENV_LOBES_SG_LOBES8_C47);
    LOBE_LET lean =
        lobe_env_sum(at, LOBE_ENV_LOBES_SG_LOBES8_C48, LOBE_ENV_LOBES_SG_LOBES8_C49, LOBE_ENV_LOBES_SG_LOBES8_C50,
                     LOBE_ENV_LOBES_SG_LOBES8_C51, LOBE_ENV_LOBES_SG_LOBES8_C52, LOBE_ENV_LOBES_SG_LOBES8_C53,
                     LOBE_ENV_LOBES_SG_LOBES8_C54, LOBE_ENV_LOBES_SG_LOBES8_C55, LOBE_ENV_LOBES_SG_LOBES8_C56,
                     LOBE_ENV_LOBES_SG_LOBES8_C57, LOBE_ENV_LOBES_SG_LOBES8_C58, LOBE_ENV_LOBES_SG_LOBES8_C59);
    LOBE_LET rim =
        lobe_env_sum(at, LOBE_ENV_LOBES_SG_LOBES8_C60, LOBE_ENV_LOBES_SG_LOBES8_C61, LOBE_ENV_LOBES_SG_LOBES8_C62,
                     LOBE_ENV_LOBES_SG_LOBES8_C63, LOBE_ENV_LOBES_SG_LOBES8_C64, LOBE_ENV_LOBES_SG_LOBES8_C65,
                     LOBE_ENV_LOBES_SG_LOBES8_C66, LOBE_ENV_LOBES_SG_LOBES8_C67, LOBE_ENV_LOBES_SG_LOBES8_C68,
                     LOBE_ENV_LOBES_SG_LOBES8_C69, LOBE_ENV_LOBES_SG_LOBES8_C70, LOBE_ENV_LOBES_SG_LOBES8_C71);
    LOBE_LET taper =
        lobe_env_sum(at, LOBE_ENV_LOBES_SG_LOBES8_C72, LOBE_ENV_LOBES_SG_LOBES8_C73, LOBE_ENV_LOBES_SG_LOBES8_C74,
                     LOBE_ENV_LOBES_SG_LOBES8_C75, LOBE_ENV_LOBES_SG_LOBES8_C76, LOBE_ENV_LOBES_SG_LOBES8_C77,
                     LOBE_ENV_LOBES_SG_LOBES8_C78, LOBE_ENV_LOBES_SG_LOBES8_C79, LOBE_ENV_LOBES_SG_LOBES8_C80,
                     LOBE_ENV_LOBES_SG_LOBES8_C81, LOBE_ENV_LOBES_SG_LOBES8_C82, LOBE_ENV_LOBES_SG_LOBES8_C83);
    LOBE_LET flare =
        lobe_env_sum(at, LOBE_ENV_LOBES_SG_LOBES8_C84, LOBE_ENV_LOBES_SG_LOBES8_C85, LOBE_ENV_LOBES_SG_LOBES8_C86,
                     LOBE_ENV_LOBES_SG_LOBES8_C87, LOBE_ENV_LOBES_SG_LOBES8_C88, LOBE_ENV_LOBES_SG_LOBES8_C89,
                     LOBE_ENV_LOBES_SG_LOBES8_C90, LOBE_ENV_LOBES_SG_LOBES8_C91, LOBE_ENV_LOBES_SG_LOBES8_C92,
                     LOBE_ENV_LOBES_SG_LOBES8_C93, LOBE_ENV_LOBES_SG_LOBES8_C94, LOBE_ENV_LOBES_SG_LOBES8_C95);
    lobe_env_sg_fan fan = lobe_env_sg_fan_of(at, shift, level, spread, tilt, lean, rim, taper, flare);
    lobe_env_tap t0 = lobe_env_sg_tap_of(fan, at.a, LOBE_R(-1.0));
    lobe_env_tap t1 = lobe_env_sg_tap_of(fan, at.a, LOBE_R(-0.7142857142857143));
    lobe_env_tap t2 = lobe_env_sg_tap_of(fan, at.a, LOBE_R(-0.42857142857142855));
    lobe_env_tap t3 = lobe_env_sg_tap_of(fan, at.a, LOBE_R(-0.14285714285714285));
    lobe_env_tap t4 = lobe_env_sg_tap_of(fan, at.a, LOBE_R(0.14285714285714285));
    lobe_env_tap t5 = lobe_env_sg_tap_of(fan, at.a, LOBE_R(0.42857142857142855));
    lobe_env_tap t6 = lobe_env_sg_tap_of(fan, at.a, LOBE_R(0.7142857142857143));
    lobe_env_tap t7 = lobe_env_sg_tap_of(fan, at.a, LOBE_R(1.0));
    LOBE_LET sum = t0.weight + t1.weight + t2.weight + t3.weight + t4.weight + t5.weight + t6.weight + t7.weight;
    LOBE_LET less = e * fan.rim;
    LOBE_LET factor = (e + LOBE_R(8.0) * less) / sum;
    lobe_env_sg8 lobes;
    lobes.t0 = lobe_env_sg_weighed(t0, factor, less);
    lobes.t1 = lobe_env_sg_weighed(t1, factor, less);
    lobes.t2 = lobe_env_sg_weighed(t2, factor, less);
    lobes.t3 = lobe_env_sg_weighed(t3, factor, less);
    lobes.t4 = lobe_env_sg_weighed(t4, factor, less);
    lobes.t5 = lobe_env_sg_weighed(t5, factor, less);
    lobes.t6 = lobe_env_sg_weighed(t6, factor, less);
    lobes.t7 = lobe_env_sg_weighed(t7, factor, less);
    return lobes;
}

#endif
