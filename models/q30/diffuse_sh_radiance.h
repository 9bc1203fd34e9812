/* Radiance in fixed point: directions and lobe are Q30, lighting and result Q16.16.
 *
 * The sums of the turn are held at the ends of int32_t: with unit directions they stay below 1.5, with others nothing
 * traps. A coefficient is held at [-1, 1] before it meets the lighting, which then cannot overflow a product. */
#ifndef LOBE_Q30_DIFFUSE_SH_RADIANCE_H
#define LOBE_Q30_DIFFUSE_SH_RADIANCE_H
#include "diffuse_sh.h"

static inline int32_t lobe_q_product(int32_t a, int32_t b) { return lobe_q_mul(a, b, 30); }

static inline int32_t lobe_q_sum(int32_t a, int32_t b) { return lobe_q_add_saturated(a, b); }

static inline int32_t lobe_q_difference(int32_t a, int32_t b) { return lobe_q_subtract_saturated(a, b); }

/* a b + c d */
static inline int32_t lobe_q_sum_of_products(int32_t a, int32_t b, int32_t c, int32_t d)
{
    return lobe_q_sum(lobe_q_product(a, b), lobe_q_product(c, d));
}

static inline int32_t lobe_q_signed_unit(int32_t x) { return lobe_q_clamp(x, -LOBE_Q30_ONE, LOBE_Q30_ONE); }

static inline lobe_vec3_q30 lobe_diffuse_sh_direction_q30(lobe_vec3_q30 d)
{
    lobe_vec3_q30 out;
    out.x = lobe_q_signed_unit(d.x);
    out.y = lobe_q_signed_unit(d.y);
    out.z = lobe_q_signed_unit(d.z);
    return out;
}

static inline int32_t lobe_vec3_dot_q30(lobe_vec3_q30 a, lobe_vec3_q30 b)
{
    return lobe_q_sum(lobe_q_sum_of_products(a.x, b.x, a.y, b.y), lobe_q_product(a.z, b.z));
}

/* As lobe_diffuse_sh_turned_full of ../diffuse_sh_radiance.h. */
static inline lobe_sh9_q30 lobe_diffuse_sh_turned_q30(lobe_diffuse_shape_q30 a, lobe_vec3_q30 n, lobe_vec3_q30 view,
                                                      int32_t v)
{
    const int32_t sqrt3 = 1859775393, half_sqrt3 = 929887697;
    const int32_t tx = lobe_q_difference(view.x, lobe_q_product(v, n.x));
    const int32_t ty = lobe_q_difference(view.y, lobe_q_product(v, n.y));
    const int32_t tz = lobe_q_difference(view.z, lobe_q_product(v, n.z));
    const int32_t ss = LOBE_Q30_ONE - lobe_q_product(v, v);
    const int32_t half_tt = lobe_q_mul(a.c2tt, ss, 31);
    const int32_t bn = lobe_q_product(half_sqrt3, a.c2n) + half_tt;
    const int32_t px = lobe_q_sum_of_products(bn, n.x, a.c2t, tx);
    const int32_t py = lobe_q_sum_of_products(bn, n.y, a.c2t, ty);
    const int32_t pz = lobe_q_sum_of_products(bn, n.z, a.c2t, tz);
    const int32_t hx = lobe_q_product(a.c2tt, tx), hy = lobe_q_product(a.c2tt, ty), hz = lobe_q_product(a.c2tt, tz);
    const int32_t zz = lobe_q_difference(lobe_q_sum_of_products(n.z, pz, tz, hz), half_tt);
    lobe_sh9_q30 c;
    c.c[0] = a.c00;
    c.c[1] = lobe_q_sum_of_products(a.c1n, n.y, a.c1t, ty);
    c.c[2] = lobe_q_sum_of_products(a.c1n, n.z, a.c1t, tz);
    c.c[3] = lobe_q_sum_of_products(a.c1n, n.x, a.c1t, tx);
    c.c[4] = lobe_q_sum(lobe_q_sum_of_products(n.x, py, n.y, px), lobe_q_mul(tx, hy, 29));
    c.c[5] = lobe_q_sum(lobe_q_sum_of_products(n.y, pz, n.z, py), lobe_q_mul(ty, hz, 29));
    c.c[6] = lobe_q_difference(lobe_q_product(sqrt3, lobe_q_signed_unit(zz)), lobe_q_shift_right(a.c2n, 1));
    c.c[7] = lobe_q_sum(lobe_q_sum_of_products(n.x, pz, n.z, px), lobe_q_mul(tx, hz, 29));
    c.c[8] = lobe_q_difference(lobe_q_sum_of_products(n.x, px, tx, hx), lobe_q_sum_of_products(n.y, py, ty, hy));
    return c;
}

/* The product of coefficients and lighting, Q16.16, held at [0, 32768). */
static inline int32_t lobe_sh9_light_q16(const lobe_sh9_q30 *c, const lobe_sh9_q16 *light)
{
    int64_t sum = 0;
    int k;
    for (k = 0; k < 9; k++)
        sum += lobe_q_mul(lobe_q_clamp(c->c[k], 1 - LOBE_Q30_ONE, LOBE_Q30_ONE - 1), light->c[k], 30);
    return sum < 0 ? 0 : sum > 0x7fffffff ? 0x7fffffff : (int32_t)sum;
}

static inline lobe_vec3_q16 lobe_diffuse_sh_light_q16(const lobe_sh9_q30 *c, const lobe_lighting_q16 *lighting)
{
    lobe_vec3_q16 out;
    out.x = lobe_sh9_light_q16(c, &lighting->red);
    out.y = lobe_sh9_light_q16(c, &lighting->green);
    out.z = lobe_sh9_light_q16(c, &lighting->blue);
    return out;
}

#define LOBE_DIFFUSE_SH_RADIANCE_Q30(tier)                                                                             \
    lobe_vec3_q16 lobe_diffuse_sh_radiance_##tier##_q30(int32_t roughness, lobe_vec3_q30 normal, lobe_vec3_q30 view,   \
                                                        const lobe_lighting_q16 *lighting)                             \
    {                                                                                                                  \
        const lobe_vec3_q30 n = lobe_diffuse_sh_direction_q30(normal), w = lobe_diffuse_sh_direction_q30(view);        \
        const int32_t v = lobe_q_saturate(lobe_vec3_dot_q30(n, w));                                                    \
        const lobe_diffuse_shape_q30 a = lobe_diffuse_shape_##tier##_q30(roughness, v);                                \
        const lobe_sh9_q30 c = lobe_diffuse_sh_turned_q30(a, n, w, v);                                                 \
        return lobe_diffuse_sh_light_q16(&c, lighting);                                                                \
    }

#endif
