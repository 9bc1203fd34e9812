/* Angles of the first quadrant as parts of a half turn, and what a chord cuts off a disc. For the clipped sphere
 * (models/sphere_diffuse.h): relative accuracy also where the angle is small, which core/turns.h does not promise.
 *
 * Both take the point (x, y), x and y in [0, 2^60], not below 2^-60 unless 0; the origin counts as the angle 0, and a
 * NaN gives a finite result. Bounds are in ulp of the result (harness/test/test_core_arc.c).
 * Source: z = min/max of the sides; minimax polynomials in z^2 (polynomials.sollya). */
#ifndef LOBE_ARC_H
#define LOBE_ARC_H
#include "scalar.h"

#define LOBE_ARC_ULP 3.0
#define LOBE_ARC_SEGMENT_ULP 13.0

#define LOBE_INVERSE_PI LOBE_R(0.318309886183790672)

/* The angle over pi, in [0, 1/2]. z, at most 1, is the smaller side over the larger; steep > 0 beyond 45 degrees. */
LOBE_FN lobe_real lobe_arc_of_ratio(lobe_real z, lobe_real steep)
{
#if defined(LOBE_DOUBLE) && defined(LOBE_OPENCL)
    LOBE_LET octant = atan(z) * LOBE_INVERSE_PI;
#elif defined(LOBE_DOUBLE)
    LOBE_LET octant = __builtin_atan(z) * LOBE_INVERSE_PI;
#else
    LOBE_LET s = z * z;
    LOBE_LET p7 = LOBE_R(-0.00499545876) + s * LOBE_R(0.000879229687);
    LOBE_LET p6 = LOBE_R(0.01337888) + s * p7;
    LOBE_LET p5 = LOBE_R(-0.0236901529) + s * p6;
    LOBE_LET p4 = LOBE_R(0.0337661281) + s * p5;
    LOBE_LET p3 = LOBE_R(-0.045179747) + s * p4;
    LOBE_LET p2 = LOBE_R(0.0636333451) + s * p3;
    LOBE_LET p1 = LOBE_R(-0.106102094) + s * p2;
    LOBE_LET p0 = LOBE_R(0.318309873) + s * p1;
    LOBE_LET octant = z * p0;
#endif
    LOBE_LET rest = LOBE_R(0.5) - octant;
    return lobe_select(steep, rest, octant);
}

/* The angle of (x, y) over pi, in [0, 1/2].
 * Error       2.55 ulp at y = 0x1.168adp-1, x = 0x1.1cea98p-1 (10^7 points, half of them random, half near an axis).
 * Operations  10 add, 10 mul, 1 div, 4 min/max/select. */
LOBE_FN lobe_real lobe_arc(lobe_real y, lobe_real x)
{
    LOBE_LET far_side = lobe_max(lobe_max(x, y), LOBE_R(1e-30));
    LOBE_LET z = lobe_saturate(lobe_min(x, y) / far_side);
    LOBE_LET steep = y - x;
    return lobe_arc_of_ratio(z, steep);
}

/* atan z - z / (1 + z^2) over pi for z in [0, 1]: (2 z^3 / 3 - 4 z^5 / 5 + ...) / pi, no difference of near numbers. */
LOBE_FN lobe_real lobe_arc_segment_octant(lobe_real z)
{
    LOBE_LET s = z * z;
#if defined(LOBE_DOUBLE)
    LOBE_LET q9 = LOBE_R(20.0) / LOBE_R(21.0) - s * (LOBE_R(22.0) / LOBE_R(23.0) - s * (LOBE_R(24.0) / LOBE_R(25.0)));
    LOBE_LET q8 = LOBE_R(18.0) / LOBE_R(19.0) - s * q9;
    LOBE_LET q7 = LOBE_R(16.0) / LOBE_R(17.0) - s * q8;
    LOBE_LET q6 = LOBE_R(14.0) / LOBE_R(15.0) - s * q7;
    LOBE_LET q5 = LOBE_R(12.0) / LOBE_R(13.0) - s * q6;
    LOBE_LET q4 = LOBE_R(10.0) / LOBE_R(11.0) - s * q5;
    LOBE_LET q3 = LOBE_R(8.0) / LOBE_R(9.0) - s * q4;
    LOBE_LET q2 = LOBE_R(6.0) / LOBE_R(7.0) - s * q3;
    LOBE_LET q1 = LOBE_R(4.0) / LOBE_R(5.0) - s * q2;
    LOBE_LET series = z * s * LOBE_INVERSE_PI * (LOBE_R(2.0) / LOBE_R(3.0) - s * q1);
    LOBE_LET direct = lobe_arc_of_ratio(z, LOBE_R(0.0)) - LOBE_INVERSE_PI * z / (LOBE_R(1.0) + s);
    LOBE_LET large = z - LOBE_R(0.2); /* where the direct difference has lost a digit and a half */
    return lobe_select(large, direct, series);
#else
    LOBE_LET p9 = LOBE_R(-0.0304179713) + s * LOBE_R(0.00466406532);
    LOBE_LET p8 = LOBE_R(0.0917887092) + s * p9;
    LOBE_LET p7 = LOBE_R(-0.174239472) + s * p8;
    LOBE_LET p6 = LOBE_R(0.242429852) + s * p7;
    LOBE_LET p5 = LOBE_R(-0.277301818) + s * p6;
    LOBE_LET p4 = LOBE_R(0.28610006) + s * p5;
    LOBE_LET p3 = LOBE_R(-0.282549769) + s * p4;
    LOBE_LET p2 = LOBE_R(0.272812068) + s * p3;
    LOBE_LET p1 = LOBE_R(-0.254647255) + s * p2;
    LOBE_LET p0 = LOBE_R(0.212206587) + s * p1;
    LOBE_LET y = z * s * p0;
    return y;
#endif
}

/* The part of a disc that a chord cuts off whose half is seen from the centre under the angle of (x, y):
 * (angle - sin cos) / pi, in [0, 1/2]. The third power of a small angle, with its relative accuracy.
 * Error       12.0 ulp at y = 0x1.fb6dc4p-1, x = 0x1.f7407p-1, just beyond 45 degrees, where 1/2 - .41 costs three
 * bits; below 45 degrees 4.5 ulp. Operations  14 add, 16 mul, 2 div, 4 min/max/select. */
LOBE_FN lobe_real lobe_arc_segment(lobe_real y, lobe_real x)
{
    LOBE_LET far_side = lobe_max(lobe_max(x, y), LOBE_R(1e-30));
    LOBE_LET z = lobe_saturate(lobe_min(x, y) / far_side);
    LOBE_LET octant = lobe_arc_segment_octant(z);
    /* Beyond 45 degrees the complement: 1/2 - (atan z + z / (1 + z^2)) / pi with z the other ratio. */
    LOBE_LET rest = LOBE_R(0.5) - (octant + LOBE_R(2.0) * LOBE_INVERSE_PI * z / (LOBE_R(1.0) + z * z));
    LOBE_LET steep = y - x;
    return lobe_select(steep, rest, octant);
}

#endif
