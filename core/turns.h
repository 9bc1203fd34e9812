/* Sine, cosine and arc tangent of angles in turns (1 is the full circle): the range reduction is exact. The sphere
 * maps use them; no split-sum kernel does.
 *
 * Errors are absolute, in units of the result, since a sine crosses zero; the bounds are the macros below. */
#ifndef LOBE_TURNS_H
#define LOBE_TURNS_H
#include "bits.h"
#include "sign.h"

#define LOBE_SIN_ABSOLUTE 2.0e-7
#define LOBE_COS_ABSOLUTE 2.0e-7
#define LOBE_ATAN2_ABSOLUTE 4.0e-8

#if defined(LOBE_TRACE) /* the tracer brings its own */
#elif defined(LOBE_DOUBLE)
LOBE_FN lobe_real lobe_sin_turns(lobe_real t)
{
    LOBE_LET a = LOBE_R(6.283185307179586) * lobe_clamp(t, LOBE_R(-4194304.0), LOBE_R(4194304.0));
#if defined(LOBE_OPENCL)
    return sin(a);
#else
    return __builtin_sin(a);
#endif
}

LOBE_FN lobe_real lobe_cos_turns(lobe_real t)
{
    LOBE_LET a = LOBE_R(6.283185307179586) * lobe_clamp(t, LOBE_R(-4194304.0), LOBE_R(4194304.0));
#if defined(LOBE_OPENCL)
    return cos(a);
#else
    return __builtin_cos(a);
#endif
}

LOBE_FN lobe_real lobe_atan2_turns(lobe_real y, lobe_real x)
{
#if defined(LOBE_OPENCL)
    LOBE_LET a = atan2(y, x) * LOBE_R(0.15915494309189535);
#else
    LOBE_LET a = __builtin_atan2(y, x) * LOBE_R(0.15915494309189535);
#endif
    return lobe_clamp(a, LOBE_R(-0.5), LOBE_R(0.5));
}
#else

/* The nearest whole number for t in [-2^22, 2^22]: what remains, t - whole, is exact and in [-1/2, 1/2]. */
LOBE_FN lobe_real lobe_turns_fraction(lobe_real t)
{
    LOBE_LET c = lobe_clamp(t, LOBE_R(-4194304.0), LOBE_R(4194304.0));
    LOBE_LET half_away = c < LOBE_R(0.0) ? LOBE_R(-0.5) : LOBE_R(0.5);
    LOBE_LET up = c + half_away;
    LOBE_LET whole = lobe_real_from_int(lobe_int_from_real(up));
    LOBE_LET f = c - whole;
    return f;
}

/* sin(2 pi r) for |r| <= 1/4: r times a quartic in r^2, minimax in relative error (fpminimax, 2.8e-8). */
LOBE_FN lobe_real lobe_turns_quarter(lobe_real r)
{
    LOBE_LET s = r * r;
    LOBE_LET p3 = LOBE_R(-76.6250153) + s * LOBE_R(40.0593719);
    LOBE_LET p2 = LOBE_R(81.6046371) + s * p3;
    LOBE_LET p1 = LOBE_R(-41.3417206) + s * p2;
    LOBE_LET p0 = LOBE_R(6.28318548) + s * p1;
    LOBE_LET y = r * p0;
    return y;
}

/* sin(2 pi t) in [-1, 1].
 * Domain      |t| <= 2^22; larger counts as the end, NaN as -2^22: the result is then 0.
 * Error       absolute, over all multiples of 2^-24 in [-2, 2]: 1.71e-7 at -0x1.c01f5ep+0.
 * Operations  8 add, 7 mul, 8 min/max. */
LOBE_FN lobe_real lobe_sin_turns(lobe_real t)
{
    LOBE_LET f = lobe_turns_fraction(t);
    LOBE_LET m = lobe_abs(f);
    LOBE_LET d = m - LOBE_R(0.25);
    LOBE_LET folded = lobe_sign(f) * (LOBE_R(0.25) - lobe_abs(d));
    LOBE_LET y = lobe_turns_quarter(folded);
    return lobe_clamp(y, LOBE_R(-1.0), LOBE_R(1.0));
}

/* cos(2 pi t) in [-1, 1].
 * Domain      as lobe_sin_turns; out of it the result is 1.
 * Error       absolute, over all multiples of 2^-24 in [-2, 2]: 1.71e-7 at -0x1.ffe0a2p+0.
 * Operations  7 add, 6 mul, 6 min/max. */
LOBE_FN lobe_real lobe_cos_turns(lobe_real t)
{
    LOBE_LET m = lobe_abs(lobe_turns_fraction(t));
    LOBE_LET folded = LOBE_R(0.25) - m;
    LOBE_LET y = lobe_turns_quarter(folded);
    return lobe_clamp(y, LOBE_R(-1.0), LOBE_R(1.0));
}

/* The angle of the point (x, y) in turns, in [-1/2, 1/2]; y = 0 gives 0 or 1/2, the origin 0.
 * Domain      finite numbers of ordinary size (2^-60 to 2^60); NaN gives a finite result.
 * Error       absolute in turns, over random points: 3.42e-8 turns at
 *             y = 0x1.f6eb02p-1, x = -0x1.ed156p-1 (2e7 points of the square).
 * Operations  10 add, 10 mul, 1 div, 10 min/max.
 * Source      atan(z) / (2 pi) for z = min/max of the sides: z times a polynomial of degree 8 in z^2, minimax in
 *             relative error (fpminimax, 4.0e-8). */
LOBE_FN lobe_real lobe_atan2_turns(lobe_real y, lobe_real x)
{
    LOBE_LET ax = lobe_abs(x);
    LOBE_LET ay = lobe_abs(y);
    LOBE_LET near_side = lobe_min(ax, ay);
    LOBE_LET far_side = lobe_max(ax, ay);
    LOBE_LET z = lobe_saturate(near_side / lobe_max(far_side, LOBE_R(1.17549435e-38)));
    LOBE_LET s = z * z;
    LOBE_LET p7 = LOBE_R(-0.00249772938) + s * LOBE_R(0.000439614843);
    LOBE_LET p6 = LOBE_R(0.00668943999) + s * p7;
    LOBE_LET p5 = LOBE_R(-0.0118450765) + s * p6;
    LOBE_LET p4 = LOBE_R(0.0168830641) + s * p5;
    LOBE_LET p3 = LOBE_R(-0.0225898735) + s * p4;
    LOBE_LET p2 = LOBE_R(0.0318166725) + s * p3;
    LOBE_LET p1 = LOBE_R(-0.053051047) + s * p2;
    LOBE_LET p0 = LOBE_R(0.159154937) + s * p1;
    LOBE_LET octant = z * p0;
    LOBE_LET quadrant = ay > ax ? LOBE_R(0.25) - octant : octant;
    LOBE_LET upper = x < LOBE_R(0.0) ? LOBE_R(0.5) - quadrant : quadrant;
    return y < LOBE_R(0.0) ? -upper : upper;
}
#endif

#endif
