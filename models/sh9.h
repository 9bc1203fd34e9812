/* Nine real spherical harmonics, order 3 (bands 0, 1, 2): a function on the sphere as numbers.
 *
 * Index l^2 + l + m; every basis polynomial has a positive sign:
 *     0: .282095          1: .488603 y        2: .488603 z              3: .488603 x
 *     4: 1.092548 x y     5: 1.092548 y z     6: .315392 (3 z^2 - 1)    7: 1.092548 x z    8: .546274 (x^2 - y^2)
 * The other convention in use carries the Condon-Shortley phase (-1)^m: there 1, 3, 5 and 7 have the other sign, and
 * lobe_sh9_other_sign converts both ways. The integral of a product over the sphere is lobe_sh9_dot. */
#ifndef LOBE_SH9_H
#define LOBE_SH9_H
#include "../core/vec3.h"

#define LOBE_SQRT3 LOBE_R(1.7320508075688772)
#define LOBE_HALF_SQRT3 LOBE_R(0.86602540378443865)

LOBE_STRUCT(lobe_sh9)
{
    lobe_real c0;
    lobe_real c1;
    lobe_real c2;
    lobe_real c3;
    lobe_real c4;
    lobe_real c5;
    lobe_real c6;
    lobe_real c7;
    lobe_real c8;
};

LOBE_FN lobe_sh9 lobe_sh9_of(lobe_real c0, lobe_real c1, lobe_real c2, lobe_real c3, lobe_real c4, lobe_real c5,
                             lobe_real c6, lobe_real c7, lobe_real c8)
{
    lobe_sh9 c;
    c.c0 = c0;
    c.c1 = c1;
    c.c2 = c2;
    c.c3 = c3;
    c.c4 = c4;
    c.c5 = c5;
    c.c6 = c6;
    c.c7 = c7;
    c.c8 = c8;
    return c;
}

/* The integral of the product of two functions over the sphere. 9 operations. */
LOBE_FN lobe_real lobe_sh9_dot(lobe_sh9 a, lobe_sh9 b)
{
    LOBE_LET s0 = a.c0 * b.c0;
    LOBE_LET s1 = s0 + a.c1 * b.c1 + a.c2 * b.c2 + a.c3 * b.c3;
    LOBE_LET s2 = s1 + a.c4 * b.c4 + a.c5 * b.c5 + a.c6 * b.c6 + a.c7 * b.c7 + a.c8 * b.c8;
    return s2;
}

/* The same function in the convention with the Condon-Shortley phase, and back. */
LOBE_FN lobe_sh9 lobe_sh9_other_sign(lobe_sh9 a)
{
    LOBE_LET c1 = -a.c1;
    LOBE_LET c3 = -a.c3;
    LOBE_LET c5 = -a.c5;
    LOBE_LET c7 = -a.c7;
    return lobe_sh9_of(a.c0, c1, a.c2, c3, a.c4, c5, a.c6, c7, a.c8);
}

/* The zonal lobe z0, z1, z2 (its coefficients 0, 2 and 6 with z as axis) turned to the unit direction d. */
LOBE_FN lobe_sh9 lobe_sh9_zonal(lobe_real z0, lobe_real z1, lobe_real z2, lobe_vec3 d)
{
    LOBE_LET k = LOBE_SQRT3 * z2;
    LOBE_LET kx = k * d.x;
    LOBE_LET ky = k * d.y;
    LOBE_LET c1 = z1 * d.y;
    LOBE_LET c2 = z1 * d.z;
    LOBE_LET c3 = z1 * d.x;
    LOBE_LET c4 = kx * d.y;
    LOBE_LET c5 = ky * d.z;
    LOBE_LET c6 = z2 * (LOBE_R(1.5) * d.z * d.z - LOBE_R(0.5));
    LOBE_LET c7 = kx * d.z;
    LOBE_LET c8 = LOBE_R(0.5) * (kx * d.x - ky * d.y);
    return lobe_sh9_of(z0, c1, c2, c3, c4, c5, c6, c7, c8);
}

#endif
