/* A sphere light as nine spherical harmonics, in Q30. Its zonal coefficients are at most sqrt(pi), 1.54 and .77, and
 * with components of the direction in [-1, 1] no coefficient of the nine leaves [-2, 2). */
#ifndef LOBE_Q30_SPHERE_SH_H
#define LOBE_Q30_SPHERE_SH_H
#include "diffuse_sh_radiance.h"
#include "sphere_diffuse.h"

static inline lobe_sh9_q30 lobe_sphere_sh_of_q30(int32_t sine, lobe_vec3_q30 direction)
{
    const lobe_vec3_q30 d = lobe_diffuse_sh_direction_q30(direction);
    const int32_t s = lobe_q_saturate(sine), s2 = lobe_q_mul(s, s, 30), cosine = lobe_sphere_diffuse_across(s);
    /* 1 - cos = s^2 / (1 + cos), both halved */
    const int32_t half = (LOBE_Q30_ONE >> 1) + (cosine >> 1);
    const int32_t versine = lobe_q_ratio(s2 >> 1, lobe_q_reciprocal(half));
    const int32_t z1 = lobe_q_product(s2, 1648183029), z2 = lobe_q_product(lobe_q_product(s2, cosine), 2127795141);
    const int32_t k = lobe_q_product(z2, 1859775393); /* sqrt 3 */
    const int32_t kx = lobe_q_product(k, d.x), ky = lobe_q_product(k, d.y);
    lobe_sh9_q30 c;
    c.c[0] = lobe_q_product(versine, 1903157831);
    c.c[1] = lobe_q_product(z1, d.y);
    c.c[2] = lobe_q_product(z1, d.z);
    c.c[3] = lobe_q_product(z1, d.x);
    c.c[4] = lobe_q_product(kx, d.y);
    c.c[5] = lobe_q_product(ky, d.z);
    c.c[6] = lobe_q_product(z2, lobe_q_mul(lobe_q_product(d.z, d.z), 1610612736, 30) - (LOBE_Q30_ONE >> 1));
    c.c[7] = lobe_q_product(kx, d.z);
    c.c[8] = lobe_q_shift_right(lobe_q_difference(lobe_q_product(kx, d.x), lobe_q_product(ky, d.y)), 1);
    return c;
}

#endif
