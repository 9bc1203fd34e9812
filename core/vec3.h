/* Three numbers with a direction. The local frame of a surface has z along the normal. */
#ifndef LOBE_VEC3_H
#define LOBE_VEC3_H
#include "sqrt.h"

LOBE_STRUCT(lobe_vec3)
{
    lobe_real x;
    lobe_real y;
    lobe_real z;
};

LOBE_FN lobe_vec3 lobe_vec3_of(lobe_real x, lobe_real y, lobe_real z)
{
    lobe_vec3 v;
    v.x = x;
    v.y = y;
    v.z = z;
    return v;
}

LOBE_FN lobe_vec3 lobe_vec3_scale(lobe_vec3 a, lobe_real s)
{
    LOBE_LET x = a.x * s;
    LOBE_LET y = a.y * s;
    LOBE_LET z = a.z * s;
    return lobe_vec3_of(x, y, z);
}

LOBE_FN lobe_vec3 lobe_vec3_add(lobe_vec3 a, lobe_vec3 b)
{
    LOBE_LET x = a.x + b.x;
    LOBE_LET y = a.y + b.y;
    LOBE_LET z = a.z + b.z;
    return lobe_vec3_of(x, y, z);
}

LOBE_FN lobe_real lobe_vec3_dot(lobe_vec3 a, lobe_vec3 b)
{
    LOBE_LET d = a.x * b.x + a.y * b.y + a.z * b.z;
    return d;
}

LOBE_FN lobe_vec3 lobe_vec3_cross(lobe_vec3 a, lobe_vec3 b)
{
    LOBE_LET x = a.y * b.z - a.z * b.y;
    LOBE_LET y = a.z * b.x - a.x * b.z;
    LOBE_LET z = a.x * b.y - a.y * b.x;
    return lobe_vec3_of(x, y, z);
}

/* a / |a| for 1e-15 < |a| < 1e15; below it shrinks to zero, and the zero vector stays zero: no 0/0. */
LOBE_FN lobe_vec3 lobe_vec3_normalize(lobe_vec3 a)
{
    LOBE_LET s = LOBE_R(1.0) / lobe_max(lobe_sqrt(lobe_vec3_dot(a, a)), LOBE_R(1e-15));
    return lobe_vec3_scale(a, s);
}

/* i mirrored at the plane with unit normal n, both pointing away from the surface: 2 (n.i) n - i. */
LOBE_FN lobe_vec3 lobe_vec3_reflect(lobe_vec3 i, lobe_vec3 n)
{
    LOBE_LET d = LOBE_R(2.0) * lobe_vec3_dot(n, i);
    LOBE_LET x = d * n.x - i.x;
    LOBE_LET y = d * n.y - i.y;
    LOBE_LET z = d * n.z - i.z;
    return lobe_vec3_of(x, y, z);
}

#endif
