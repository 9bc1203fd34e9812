/* Angles of the first quadrant as parts of a half turn, in 32-bit integers. */
#ifndef LOBE_Q30_ARC_H
#define LOBE_Q30_ARC_H
#include "q30.h"

/* sum of p[k] x^k, x and p in Q30; every partial sum must fit. */
static inline int32_t lobe_q_polynomial(const int32_t *p, int degree, int32_t x)
{
    int32_t y = p[degree];
    int k;
    for (k = degree - 1; k >= 0; k--)
        y = p[k] + lobe_q_mul(x, y, 30);
    return y;
}

/* atan z / pi for z in [0, 1]: the polynomial of arc.h anew, minimax over z^2 with coefficients in Q30
 * (polynomials.sollya), within 9.4e-10. */
static inline int32_t lobe_q_arc_octant(int32_t z)
{
    static const int32_t p[10] = {341782637, -113927388, 68350970,  -48748871, 37419808,
                                  -28697534, 19784368,   -10644120, 3729356,   -613771};
    return lobe_q_mul(z, lobe_q_polynomial(p, 9, lobe_q_mul(z, z, 30)), 30);
}

/* The angle of (x, y) over pi, in [0, 1/2], Q30; x and y in [0, 2^31) have any common scale, the origin counts as the
 * angle 0. */
static inline int32_t lobe_q_arc(int32_t y, int32_t x)
{
    const int32_t far_side = lobe_q_max(x, y),
                  octant = lobe_q_arc_octant(lobe_q_ratio(lobe_q_min(x, y), lobe_q_reciprocal(far_side)));
    return y > x ? (LOBE_Q30_ONE >> 1) - octant : octant;
}

#endif
