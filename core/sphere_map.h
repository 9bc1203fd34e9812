/* Directions to the unit square and back, for environment maps: u and v in [0, 1], z is the pole.
 *
 *   octahedral      cheapest, one division each way; for storage and lookups. Solid angle varies by 3 sqrt(3).
 *   equirectangular what panoramas are stored in. v = 0 is +z, u = 1/2 is +x, and u grows from +x to +y.
 *   equal_area      octahedral with equal solid angle everywhere; for integrals and importance sampling.
 *
 * All three send +z and -z to and from exact points, no direction divides by zero, u and v outside [0, 1] count as
 * the nearer end and NaN as 0. Directions need not be unit for encoding; the zero vector encodes as +z or a pole.
 * Sources: Cigolle et al., "A Survey of Efficient Representations for Independent Unit Vectors" (JCGT 3(2), 2014);
 * Clarberg, "Fast Equal-Area Mapping of the (Hemi)Sphere using SIMD" (JGT 13(3), 2008). */
#ifndef LOBE_SPHERE_MAP_H
#define LOBE_SPHERE_MAP_H
#include "sign.h"
#include "turns.h"
#include "vec3.h"

/* Largest distance between a unit direction and its round trip, in float. */
#define LOBE_OCTAHEDRAL_ROUND_TRIP 5.0e-7
#define LOBE_EQUIRECT_ROUND_TRIP 5.0e-7
#define LOBE_EQUAL_AREA_ROUND_TRIP 5.0e-7

LOBE_STRUCT(lobe_uv)
{
    lobe_real u;
    lobe_real v;
};

/* From [-1, 1]^2 to [0, 1]^2. */
LOBE_FN lobe_uv lobe_uv_of(lobe_real x, lobe_real y)
{
    LOBE_LET u = x * LOBE_R(0.5) + LOBE_R(0.5);
    LOBE_LET v = y * LOBE_R(0.5) + LOBE_R(0.5);
    lobe_uv uv;
    uv.u = lobe_saturate(u);
    uv.v = lobe_saturate(v);
    return uv;
}

/* The lower half of the octahedron is the diamond's outside, folded over its edges. */
LOBE_FN lobe_uv lobe_octahedral_encode(lobe_vec3 d)
{
    LOBE_LET sum = lobe_abs(d.x) + lobe_abs(d.y) + lobe_abs(d.z);
    LOBE_LET s = LOBE_R(1.0) / lobe_max(sum, LOBE_R(1e-30));
    LOBE_LET x = d.x * s;
    LOBE_LET y = d.y * s;
    LOBE_LET fold_x = (LOBE_R(1.0) - lobe_abs(y)) * lobe_sign(x);
    LOBE_LET fold_y = (LOBE_R(1.0) - lobe_abs(x)) * lobe_sign(y);
    LOBE_LET below = -d.z;
    return lobe_uv_of(lobe_select(below, fold_x, x), lobe_select(below, fold_y, y));
}

/* The point of the octahedron |x| + |y| + |z| = 1 over (u, v). */
LOBE_FN lobe_vec3 lobe_octahedral_point(lobe_real u, lobe_real v)
{
    LOBE_LET x = LOBE_R(2.0) * lobe_saturate(u) - LOBE_R(1.0);
    LOBE_LET y = LOBE_R(2.0) * lobe_saturate(v) - LOBE_R(1.0);
    LOBE_LET z = LOBE_R(1.0) - lobe_abs(x) - lobe_abs(y);
    LOBE_LET minus = -z;
    LOBE_LET over = lobe_max(minus, LOBE_R(0.0));
    LOBE_LET px = x - lobe_sign(x) * over;
    LOBE_LET py = y - lobe_sign(y) * over;
    return lobe_vec3_of(px, py, z);
}

LOBE_FN lobe_vec3 lobe_octahedral_decode(lobe_real u, lobe_real v)
{
    return lobe_vec3_normalize(lobe_octahedral_point(u, v));
}

/* Solid angle per area of the square at (u, v), 4 / |p|^3 in [4, 20.8], mean 4 pi. For p on a face with unit normal
 * (1, 1, 1) / sqrt(3): dA = sqrt(3) dx dy, cos = 1 / (sqrt(3) |p|), d omega = cos dA / |p|^2, dx dy = 4 du dv. */
LOBE_FN lobe_real lobe_octahedral_solid_angle(lobe_real u, lobe_real v)
{
    lobe_vec3 p = lobe_octahedral_point(u, v);
    LOBE_LET l2 = lobe_vec3_dot(p, p);
    LOBE_LET w = LOBE_R(4.0) / (l2 * lobe_sqrt(l2));
    return w;
}

/* u from the azimuth, v from the angle to +z; the arc tangent of the sine keeps accuracy at the poles. */
LOBE_FN lobe_uv lobe_equirect_encode(lobe_vec3 d)
{
    LOBE_LET sine2 = d.x * d.x + d.y * d.y;
    LOBE_LET azimuth = lobe_atan2_turns(d.y, d.x);
    LOBE_LET polar = lobe_atan2_turns(lobe_sqrt(sine2), d.z);
    LOBE_LET u = azimuth + LOBE_R(0.5);
    LOBE_LET v = LOBE_R(2.0) * polar;
    lobe_uv uv;
    uv.u = lobe_saturate(u);
    uv.v = lobe_saturate(v);
    return uv;
}

/* Solid angle per area of the square is 2 pi^2 sin(pi v). */
LOBE_FN lobe_vec3 lobe_equirect_decode(lobe_real u, lobe_real v)
{
    LOBE_LET azimuth = lobe_saturate(u) - LOBE_R(0.5);
    LOBE_LET polar = lobe_saturate(v) * LOBE_R(0.5);
    LOBE_LET s = lobe_sin_turns(polar);
    LOBE_LET x = s * lobe_cos_turns(azimuth);
    LOBE_LET y = s * lobe_sin_turns(azimuth);
    LOBE_LET z = lobe_cos_turns(polar);
    return lobe_vec3_of(x, y, z);
}

/* Radius r = sqrt(1 - |z|) from the pole along the diamond's diagonals; the azimuth inside a quadrant goes linearly
 * along the edge. Every part of the square has 4 pi times its area as solid angle. Takes unit directions.
 * r = sqrt((x^2 + y^2) / (1 + |z|)) does not cancel at the poles. */
LOBE_FN lobe_uv lobe_equal_area_encode(lobe_vec3 d)
{
    LOBE_LET ax = lobe_abs(d.x);
    LOBE_LET ay = lobe_abs(d.y);
    LOBE_LET r2 = (d.x * d.x + d.y * d.y) / (LOBE_R(1.0) + lobe_abs(d.z));
    LOBE_LET r = lobe_sqrt(r2);
    LOBE_LET t = LOBE_R(4.0) * lobe_atan2_turns(ay, ax); /* [0, 1] over the quadrant */
    LOBE_LET py = r * t;
    LOBE_LET px = r - py;
    LOBE_LET below = -d.z;
    LOBE_LET fold_x = LOBE_R(1.0) - py;
    LOBE_LET fold_y = LOBE_R(1.0) - px;
    LOBE_LET x = lobe_sign(d.x) * lobe_select(below, fold_x, px);
    LOBE_LET y = lobe_sign(d.y) * lobe_select(below, fold_y, py);
    return lobe_uv_of(x, y);
}

LOBE_FN lobe_vec3 lobe_equal_area_decode(lobe_real u, lobe_real v)
{
    LOBE_LET px = LOBE_R(2.0) * lobe_saturate(u) - LOBE_R(1.0);
    LOBE_LET py = LOBE_R(2.0) * lobe_saturate(v) - LOBE_R(1.0);
    LOBE_LET ax = lobe_abs(px);
    LOBE_LET ay = lobe_abs(py);
    LOBE_LET inside = LOBE_R(1.0) - ax - ay; /* positive in the upper half */
    LOBE_LET r = LOBE_R(1.0) - lobe_abs(inside);
    LOBE_LET r2 = r * r;
    /* Below, the quadrant's coordinates are mirrored at the edge: x' = 1 - |y|, y' = 1 - |x|. */
    LOBE_LET mirrored = LOBE_R(1.0) - ax;
    LOBE_LET along = lobe_select(inside, ay, mirrored);
    LOBE_LET t = lobe_saturate(along / lobe_max(r, LOBE_R(1e-30)));
    LOBE_LET azimuth = LOBE_R(0.25) * t;
    LOBE_LET room = LOBE_R(2.0) - r2;
    LOBE_LET s = r * lobe_sqrt(room); /* sqrt(1 - z^2) with |z| = 1 - r^2 */
    LOBE_LET x = lobe_sign(px) * s * lobe_cos_turns(azimuth);
    LOBE_LET y = lobe_sign(py) * s * lobe_sin_turns(azimuth);
    LOBE_LET z = lobe_sign(inside) * (LOBE_R(1.0) - r2);
    return lobe_vec3_of(x, y, z);
}

#endif
