/* Environment specular by a fan of taps into an ordinary split-sum prefilter (no new asset): GGX, height-correlated
 * Smith, F = 1, so weights sum to the albedo E and a white furnace is right by construction. The taps stand in the
 * plane of view and normal.
 *
 *   angle   from the normal, in radians, positive away from the view; a mirror is acos(n_dot_v)
 *   width   roughness of the prefilter to read: its kernel is max(0, c) / (1 + k (1 - c))^2 with c the cosine to the
 *           tap, k = (1 / alpha'^2 - 1) / 2 and width = sqrt(alpha')
 *   weight  may be negative: a narrow lobe minus what spills below the horizon
 *
 * With a = alpha = roughness^2, v = n_dot_v, s = sqrt(1 - v^2) and theta = acos(v) every tap is
 *     angle = theta + a s Th,   t = a (0.3 + 2^B),   alpha' = t / sqrt(1 + t^2)  (which is k = 1 / (2 t^2)),
 * and Th, B and the weights but one are sums over twelve products of a, u = 1 - v and q = a / (v + a): q tells how near
 * the lobe is to the horizon in units of its own width. All are smooth by construction; at v = 1 every angle is 0,
 * where there is no plane of incidence. Both inputs are clamped to [0, 1], NaN counts as 0. How they were fitted:
 * cases/env_lobes. */
#ifndef LOBE_ENV_LOBES_H
#define LOBE_ENV_LOBES_H
#include "../core/arc.h"
#include "../core/exp2.h"
#include "../core/sqrt.h"

LOBE_STRUCT(lobe_env_tap)
{
    lobe_real angle;
    lobe_real width;
    lobe_real weight;
};

/* What all taps of a point share. */
LOBE_STRUCT(lobe_env_point)
{
    lobe_real theta;
    lobe_real reach; /* a s */
    lobe_real a;
    lobe_real f1;
    lobe_real f2;
    lobe_real f3;
    lobe_real f4;
    lobe_real f5;
    lobe_real f6;
    lobe_real f7;
    lobe_real f8;
    lobe_real f9;
    lobe_real f10;
    lobe_real f11;
};

/* 1e-6 keeps q at 0 where roughness and v are. */
LOBE_FN lobe_env_point lobe_env_point_of(lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET a = r * r;
    LOBE_LET u = LOBE_R(1.0) - v;
    LOBE_LET s = lobe_sqrt(u * (LOBE_R(1.0) + v));
    LOBE_LET theta = LOBE_R(3.14159265358979324) * lobe_arc(s, v);
    LOBE_LET reach = a * s;
    LOBE_LET q = a / (v + a + LOBE_R(1e-6));
    LOBE_LET u2 = u * u;
    LOBE_LET q2 = q * q;
    LOBE_LET uq = u * q;
    LOBE_LET au = a * u;
    LOBE_LET aq = a * q;
    LOBE_LET auq = a * uq;
    LOBE_LET a2 = a * a;
    LOBE_LET a2u = a2 * u;
    lobe_env_point p;
    p.theta = theta;
    p.reach = reach;
    p.a = a;
    p.f1 = u;
    p.f2 = u2;
    p.f3 = q;
    p.f4 = q2;
    p.f5 = uq;
    p.f6 = a;
    p.f7 = au;
    p.f8 = aq;
    p.f9 = auq;
    p.f10 = a2;
    p.f11 = a2u;
    return p;
}

/* One quantity: twelve coefficients. */
LOBE_FN lobe_real lobe_env_sum(lobe_env_point p, lobe_real c0, lobe_real c1, lobe_real c2, lobe_real c3, lobe_real c4,
                               lobe_real c5, lobe_real c6, lobe_real c7, lobe_real c8, lobe_real c9, lobe_real c10,
                               lobe_real c11)
{
    LOBE_LET x0 = c0 + c1 * p.f1 + c2 * p.f2 + c3 * p.f3;
    LOBE_LET x1 = x0 + c4 * p.f4 + c5 * p.f5 + c6 * p.f6;
    LOBE_LET x2 = x1 + c7 * p.f7 + c8 * p.f8 + c9 * p.f9;
    LOBE_LET x3 = x2 + c10 * p.f10 + c11 * p.f11;
    return x3;
}

/* B <= 8 keeps the square finite; no fit comes near. 0.3: narrower taps fit single environments, not others. */
LOBE_FN lobe_env_tap lobe_env_tap_of(lobe_env_point p, lobe_real shift, lobe_real log_width, lobe_real weight)
{
    LOBE_LET angle = p.theta + p.reach * shift;
    LOBE_LET t = p.a * (LOBE_R(0.3) + lobe_exp2(lobe_min(log_width, LOBE_R(8.0))));
    LOBE_LET alpha = t / lobe_sqrt(LOBE_R(1.0) + t * t);
    LOBE_LET width = lobe_sqrt(lobe_saturate(alpha));
    lobe_env_tap tap;
    tap.angle = angle;
    tap.width = width;
    tap.weight = weight;
    return tap;
}

#endif
