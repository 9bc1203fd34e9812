/* The lobes of diffuse_sh.h in the world of the lighting, without a frame: s t = V - v n has no root in it.
 *
 * Band 1 is the vector c1n n + c1t (V - v n). Band 2 is a symmetric matrix; every part of it is an outer product, so
 * p = (sqrt 3 / 2) c2n n + c2t (V - v n) and n p' + p n' hold all but the last weight (cases/diffuse_sh/README.md). */
#ifndef LOBE_DIFFUSE_SH_RADIANCE_H
#define LOBE_DIFFUSE_SH_RADIANCE_H
#include "diffuse_sh.h"

/* The nine coefficients in world space for a shape with c2tt = 0. |n| = |view| = 1, n_dot_v their clamped product.
 * 26 operations. */
LOBE_FN lobe_sh9 lobe_diffuse_sh_turned(lobe_diffuse_shape a, lobe_vec3 n, lobe_vec3 view, lobe_real n_dot_v)
{
    LOBE_LET an = a.c1n - a.c1t * n_dot_v;
    LOBE_LET dx = an * n.x + a.c1t * view.x;
    LOBE_LET dy = an * n.y + a.c1t * view.y;
    LOBE_LET dz = an * n.z + a.c1t * view.z;
    LOBE_LET bn = LOBE_HALF_SQRT3 * a.c2n - a.c2t * n_dot_v;
    LOBE_LET px = bn * n.x + a.c2t * view.x;
    LOBE_LET py = bn * n.y + a.c2t * view.y;
    LOBE_LET pz = bn * n.z + a.c2t * view.z;
    LOBE_LET c4 = n.x * py + n.y * px;
    LOBE_LET c5 = n.y * pz + n.z * py;
    LOBE_LET c6 = LOBE_SQRT3 * n.z * pz - LOBE_R(0.5) * a.c2n;
    LOBE_LET c7 = n.x * pz + n.z * px;
    LOBE_LET c8 = n.x * px - n.y * py;
    return lobe_sh9_of(a.c00, dy, dz, dx, c4, c5, c6, c7, c8);
}

/* The same for every shape. 42 operations. */
LOBE_FN lobe_sh9 lobe_diffuse_sh_turned_full(lobe_diffuse_shape a, lobe_vec3 n, lobe_vec3 view, lobe_real n_dot_v)
{
    LOBE_LET tx = view.x - n_dot_v * n.x;
    LOBE_LET ty = view.y - n_dot_v * n.y;
    LOBE_LET tz = view.z - n_dot_v * n.z;
    LOBE_LET dx = a.c1n * n.x + a.c1t * tx;
    LOBE_LET dy = a.c1n * n.y + a.c1t * ty;
    LOBE_LET dz = a.c1n * n.z + a.c1t * tz;
    LOBE_LET ss = LOBE_R(1.0) - n_dot_v * n_dot_v;
    LOBE_LET half_tt = LOBE_R(0.5) * a.c2tt * ss;
    LOBE_LET bn = LOBE_HALF_SQRT3 * a.c2n + half_tt;
    LOBE_LET px = bn * n.x + a.c2t * tx;
    LOBE_LET py = bn * n.y + a.c2t * ty;
    LOBE_LET pz = bn * n.z + a.c2t * tz;
    LOBE_LET hx = a.c2tt * tx;
    LOBE_LET hy = a.c2tt * ty;
    LOBE_LET hz = a.c2tt * tz;
    LOBE_LET c4 = n.x * py + n.y * px + LOBE_R(2.0) * (tx * hy);
    LOBE_LET c5 = n.y * pz + n.z * py + LOBE_R(2.0) * (ty * hz);
    LOBE_LET zz = n.z * pz + tz * hz - half_tt;
    LOBE_LET c6 = LOBE_SQRT3 * zz - LOBE_R(0.5) * a.c2n;
    LOBE_LET c7 = n.x * pz + n.z * px + LOBE_R(2.0) * (tx * hz);
    LOBE_LET c8 = n.x * px - n.y * py + tx * hx - ty * hy;
    return lobe_sh9_of(a.c00, dy, dz, dx, c4, c5, c6, c7, c8);
}

/* Radiance from the nine coefficients in world space and the lighting's, one set a channel, for base colour 1.
 * Negative results, which ringing lighting can cause, and NaN count as 0. 33 operations. */
LOBE_FN lobe_vec3 lobe_diffuse_sh_light(lobe_sh9 c, lobe_sh9 red, lobe_sh9 green, lobe_sh9 blue)
{
    LOBE_LET x = lobe_clamp(lobe_sh9_dot(c, red), LOBE_R(0.0), LOBE_R(3.40282347e+38));
    LOBE_LET y = lobe_clamp(lobe_sh9_dot(c, green), LOBE_R(0.0), LOBE_R(3.40282347e+38));
    LOBE_LET z = lobe_clamp(lobe_sh9_dot(c, blue), LOBE_R(0.0), LOBE_R(3.40282347e+38));
    return lobe_vec3_of(x, y, z);
}

/* Each component inside [-1, 1]; NaN counts as -1. */
LOBE_FN lobe_vec3 lobe_diffuse_sh_direction(lobe_vec3 d)
{
    LOBE_LET x = lobe_clamp(d.x, LOBE_R(-1.0), LOBE_R(1.0));
    LOBE_LET y = lobe_clamp(d.y, LOBE_R(-1.0), LOBE_R(1.0));
    LOBE_LET z = lobe_clamp(d.z, LOBE_R(-1.0), LOBE_R(1.0));
    return lobe_vec3_of(x, y, z);
}

/* Reflected radiance for unit normal and unit view (towards the eye) in the world of the lighting. n.view < 0 counts as
 * 0. Base colour multiplies the result. */
LOBE_FN lobe_vec3 lobe_diffuse_sh_radiance_exact(lobe_real roughness, lobe_vec3 normal, lobe_vec3 view, lobe_sh9 red,
                                                 lobe_sh9 green, lobe_sh9 blue)
{
    lobe_vec3 n = lobe_diffuse_sh_direction(normal);
    lobe_vec3 w = lobe_diffuse_sh_direction(view);
    LOBE_LET v = lobe_saturate(lobe_vec3_dot(n, w));
    lobe_diffuse_shape a = lobe_diffuse_shape_exact(roughness, v);
    lobe_sh9 c = lobe_diffuse_sh_turned_full(a, n, w, v);
    return lobe_diffuse_sh_light(c, red, green, blue);
}

LOBE_FN lobe_vec3 lobe_diffuse_sh_radiance_medium(LOBE_COEFFS lobe_real roughness, lobe_vec3 normal, lobe_vec3 view,
                                                  lobe_sh9 red, lobe_sh9 green, lobe_sh9 blue)
{
    lobe_vec3 n = lobe_diffuse_sh_direction(normal);
    lobe_vec3 w = lobe_diffuse_sh_direction(view);
    LOBE_LET v = lobe_saturate(lobe_vec3_dot(n, w));
    lobe_diffuse_shape a = lobe_diffuse_shape_medium(LOBE_COEFFS_HERE roughness, v);
    lobe_sh9 c = lobe_diffuse_sh_turned(a, n, w, v);
    return lobe_diffuse_sh_light(c, red, green, blue);
}

LOBE_FN lobe_vec3 lobe_diffuse_sh_radiance_low(LOBE_COEFFS lobe_real roughness, lobe_vec3 normal, lobe_vec3 view,
                                               lobe_sh9 red, lobe_sh9 green, lobe_sh9 blue)
{
    lobe_vec3 n = lobe_diffuse_sh_direction(normal);
    lobe_vec3 w = lobe_diffuse_sh_direction(view);
    LOBE_LET v = lobe_saturate(lobe_vec3_dot(n, w));
    lobe_diffuse_shape a = lobe_diffuse_shape_low(LOBE_COEFFS_HERE roughness, v);
    lobe_sh9 c = lobe_diffuse_sh_turned(a, n, w, v);
    return lobe_diffuse_sh_light(c, red, green, blue);
}

#endif
