/* An orthonormal, right-handed frame around a unit normal.
 *
 * Source: Duff et al., "Building an Orthonormal Basis, Revisited" (JCGT 6(1), 2017): with s the sign of n.z the
 * divisor s + n.z has a magnitude of at least 1, so that no normal, pole or -z, divides by zero. The tangent turns
 * over where n.z changes its sign, as every such frame must do somewhere. */
#ifndef LOBE_FRAME_H
#define LOBE_FRAME_H
#include "sign.h"
#include "vec3.h"

#define LOBE_FRAME_ORTHONORMAL 2.5e-7 /* largest |dot - 0 or 1| for normals that are unit to rounding */

LOBE_STRUCT(lobe_frame)
{
    lobe_vec3 tangent;
    lobe_vec3 bitangent;
    lobe_vec3 normal;
};

/* The frame with this normal; tangent x bitangent = normal.
 * Domain: |n| = 1. Other finite normals give a finite frame that is not orthonormal.
 * Operations: 4 add, 8 mul, 1 div, 1 select. */
LOBE_FN lobe_frame lobe_frame_around(lobe_vec3 n)
{
    LOBE_LET s = lobe_sign(n.z);
    LOBE_LET a = LOBE_R(-1.0) / (s + n.z);
    LOBE_LET b = n.x * n.y * a;
    LOBE_LET tx = LOBE_R(1.0) + s * n.x * n.x * a;
    LOBE_LET ty = s * b;
    LOBE_LET tz = -(s * n.x);
    LOBE_LET by = s + n.y * n.y * a;
    LOBE_LET bz = -n.y;
    lobe_frame f;
    f.tangent = lobe_vec3_of(tx, ty, tz);
    f.bitangent = lobe_vec3_of(b, by, bz);
    f.normal = n;
    return f;
}

/* A direction of the world in the frame's coordinates (z along the normal), and back. */
LOBE_FN lobe_vec3 lobe_frame_to_local(lobe_frame f, lobe_vec3 w)
{
    LOBE_LET x = lobe_vec3_dot(f.tangent, w);
    LOBE_LET y = lobe_vec3_dot(f.bitangent, w);
    LOBE_LET z = lobe_vec3_dot(f.normal, w);
    return lobe_vec3_of(x, y, z);
}

LOBE_FN lobe_vec3 lobe_frame_to_world(lobe_frame f, lobe_vec3 l)
{
    LOBE_LET x = f.tangent.x * l.x + f.bitangent.x * l.y + f.normal.x * l.z;
    LOBE_LET y = f.tangent.y * l.x + f.bitangent.y * l.y + f.normal.y * l.z;
    LOBE_LET z = f.tangent.z * l.x + f.bitangent.z * l.y + f.normal.z * l.z;
    return lobe_vec3_of(x, y, z);
}

#endif
