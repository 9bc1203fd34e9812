/* What the q30 tiers of diffuse_sh share: their shapes, which are emitted (diffuse_sh_low.c and its like), and the way
 * from a shape to the nine coefficients. Everything is Q30. The weights of a shape lie in [0, 1], so no product or
 * difference here needs more than 32 bits. */
#ifndef LOBE_Q30_DIFFUSE_SH_H
#define LOBE_Q30_DIFFUSE_SH_H
#include "../lobe.h"
#include "../../core/q30_sqrt.h"

/* As lobe_diffuse_shape of ../diffuse_sh.h. */
typedef struct lobe_diffuse_shape_q30 {
    int32_t c00, c1n, c1t, c2n, c2t, c2tt;
} lobe_diffuse_shape_q30;

/* As lobe_zonal_shape of ../diffuse_zonal.h. */
typedef struct lobe_zonal_shape_q30 {
    int32_t z0, z1, z2, beta;
} lobe_zonal_shape_q30;

lobe_diffuse_shape_q30 lobe_diffuse_shape_exact_q30(int32_t roughness, int32_t n_dot_v);
lobe_diffuse_shape_q30 lobe_diffuse_shape_medium_q30(int32_t roughness, int32_t n_dot_v);
lobe_diffuse_shape_q30 lobe_diffuse_shape_low_q30(int32_t roughness, int32_t n_dot_v);
lobe_zonal_shape_q30 lobe_diffuse_shape_zonal_q30(int32_t roughness, int32_t n_dot_v);
lobe_zonal_shape_q30 lobe_diffuse_shape_zonal_low_q30(int32_t roughness, int32_t n_dot_v);

static inline lobe_sh9_q30 lobe_diffuse_sh_local_q30(lobe_diffuse_shape_q30 a, int32_t n_dot_v)
{
    const int32_t v = lobe_q_saturate(n_dot_v);
    const int32_t ss = LOBE_Q30_ONE - lobe_q_mul(v, v, 30);
    const int32_t s = lobe_q_sqrt(ss);
    lobe_sh9_q30 out;
    out.c[0] = a.c00;
    out.c[1] = 0;
    out.c[2] = a.c1n;
    out.c[3] = lobe_q_mul(a.c1t, s, 30);
    out.c[4] = 0;
    out.c[5] = 0;
    out.c[6] = a.c2n;
    out.c[7] = lobe_q_mul(a.c2t, s, 30);
    out.c[8] = lobe_q_mul(a.c2tt, ss, 30);
    return out;
}

/* The axis n + beta (view - n), normalised: its length is at least 1/2 for beta in [0, 1], and at least 1 - beta. */
static inline lobe_zonal_q30 lobe_zonal_lobe_q30(lobe_zonal_shape_q30 a, int32_t n_dot_v)
{
    const int32_t x = LOBE_Q30_ONE - lobe_q_saturate(n_dot_v);
    const int32_t rest = LOBE_Q30_ONE - a.beta;
    const int32_t length2 = LOBE_Q30_ONE - lobe_q_mul(a.beta, lobe_q_mul(rest, x, 30), 29);
    const int32_t length = lobe_q_sqrt(length2);
    const lobe_q_inverse inverse = lobe_q_reciprocal(length);
    lobe_zonal_q30 out;
    out.z0 = a.z0;
    out.z1 = a.z1;
    out.z2 = a.z2;
    out.along_normal = lobe_q_ratio(lobe_q_min(rest, length), inverse);
    out.along_view = lobe_q_ratio(lobe_q_min(a.beta, length), inverse);
    return out;
}

static inline lobe_sh9_q30 lobe_diffuse_zonal_local_q30(lobe_zonal_q30 z, int32_t n_dot_v)
{
    const int32_t v = lobe_q_saturate(n_dot_v);
    const int32_t s = lobe_q_sqrt(LOBE_Q30_ONE - lobe_q_mul(v, v, 30));
    const int32_t dx = lobe_q_mul(z.along_view, s, 30);
    const int32_t dz = lobe_q_min(z.along_normal + lobe_q_mul(z.along_view, v, 30), LOBE_Q30_ONE);
    const int32_t z2x = lobe_q_mul(z.z2, dx, 30);
    const int32_t kx = lobe_q_mul(z2x, 1859775393, 30); /* sqrt 3 */
    lobe_sh9_q30 out;
    out.c[0] = z.z0;
    out.c[1] = 0;
    out.c[2] = lobe_q_mul(z.z1, dz, 30);
    out.c[3] = lobe_q_mul(z.z1, dx, 30);
    out.c[4] = 0;
    out.c[5] = 0;
    out.c[6] = lobe_q_mul(z.z2, lobe_q_mul(lobe_q_mul(dz, dz, 30), 1610612736, 30) - (LOBE_Q30_ONE >> 1), 30);
    out.c[7] = lobe_q_mul(kx, dz, 30);
    out.c[8] = lobe_q_mul(kx, dx, 31);
    return out;
}

#define LOBE_SH9_N_Q30(name)                                                                                           \
    void name##_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *const c[9], size_t n)                 \
    {                                                                                                                  \
        size_t i;                                                                                                      \
        int k;                                                                                                         \
        for (i = 0; i < n; i++) {                                                                                      \
            const lobe_sh9_q30 a = name##_q30(roughness[i], n_dot_v[i]);                                               \
            for (k = 0; k < 9; k++)                                                                                    \
                c[k][i] = a.c[k];                                                                                      \
        }                                                                                                              \
    }

/* The public functions of a tier, from its shape. */
#define LOBE_DIFFUSE_SH_Q30(tier)                                                                                      \
    lobe_sh9_q30 lobe_diffuse_sh_##tier##_q30(int32_t roughness, int32_t n_dot_v)                                      \
    {                                                                                                                  \
        return lobe_diffuse_sh_local_q30(lobe_diffuse_shape_##tier##_q30(roughness, n_dot_v), n_dot_v);                \
    }                                                                                                                  \
    LOBE_SH9_N_Q30(lobe_diffuse_sh_##tier)

#define LOBE_DIFFUSE_ZONAL_Q30(tier)                                                                                   \
    lobe_zonal_q30 lobe_diffuse_##tier##_q30(int32_t roughness, int32_t n_dot_v)                                       \
    {                                                                                                                  \
        return lobe_zonal_lobe_q30(lobe_diffuse_shape_##tier##_q30(roughness, n_dot_v), n_dot_v);                      \
    }                                                                                                                  \
    lobe_sh9_q30 lobe_diffuse_sh_##tier##_q30(int32_t roughness, int32_t n_dot_v)                                      \
    {                                                                                                                  \
        return lobe_diffuse_zonal_local_q30(lobe_diffuse_##tier##_q30(roughness, n_dot_v), n_dot_v);                   \
    }                                                                                                                  \
    LOBE_SH9_N_Q30(lobe_diffuse_sh_##tier)

#endif
