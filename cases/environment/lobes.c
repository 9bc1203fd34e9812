#include "lobes.h"
#include "../../models/diffuse_sh_radiance.h"
#include "../../models/diffuse_zonal.h"

const char *const lobe_diffuse_tier_name[LOBE_DIFFUSE_TIERS] = {"exact",     "medium", "low",    "zonal",
                                                                "zonal_low", "seed",   "lambert"};

/* Z0, Z1 and Z2 hold the 1/pi of the BRDF already; the printed listing divides by pi once more. */
static lobe_zonal_lobe seed(float r, float v)
{
    const float x = 1.0f - v;
    const float beta = lobe_max(0.3775f * x + 0.1372f * r - 0.2988f, 0.0f), m = lobe_max(x, 0.5637f);
    const float q0 = 0.0913f + 0.3067f * r, q1 = 0.6502f - 1.0803f * r, q2 = 1.0632f * r - 0.5993f;
    const float z0 = q0 + m * (q1 + m * q2);
    const float z1 = z0 * (1.1635f - 0.0304f * r + 0.0162f * x);
    const float z2 = z0 * (0.5725f - 0.0569f * r + 0.0386f * x);
    return lobe_zonal_lobe_of(lobe_zonal_shape_of(z0, z1, z2, beta), v);
}

static lobe_sh9 zonal(lobe_zonal_lobe z, lobe_vec3 n, lobe_vec3 view)
{
    return lobe_sh9_zonal(z.z0, z.z1, z.z2,
                          lobe_vec3_add(lobe_vec3_scale(n, z.along_n), lobe_vec3_scale(view, z.along_view)));
}

static lobe_vec3 of(const double d[3]) { return lobe_vec3_of((float)d[0], (float)d[1], (float)d[2]); }

static lobe_sh9 lobe_of(lobe_diffuse_tier tier, float r, lobe_vec3 n, lobe_vec3 view)
{
    const float v = lobe_saturate(lobe_vec3_dot(n, view));
    switch (tier) {
    case LOBE_DIFFUSE_EXACT:
        return lobe_diffuse_sh_turned_full(lobe_diffuse_shape_exact(r, v), n, view, v);
    case LOBE_DIFFUSE_MEDIUM:
        return lobe_diffuse_sh_turned(lobe_diffuse_shape_medium(r, v), n, view, v);
    case LOBE_DIFFUSE_LOW:
        return lobe_diffuse_sh_turned(lobe_diffuse_shape_low(r, v), n, view, v);
    case LOBE_DIFFUSE_ZONAL:
        return zonal(lobe_diffuse_zonal(r, v), n, view);
    case LOBE_DIFFUSE_ZONAL_LOW:
        return zonal(lobe_diffuse_zonal_low(r, v), n, view);
    case LOBE_DIFFUSE_SEED:
        return zonal(seed(r, v), n, view);
    default:
        return lobe_diffuse_sh_turned(lobe_diffuse_shape_lambert(), n, view, v);
    }
}

void lobe_diffuse_lobe(lobe_diffuse_tier tier, double roughness, const double n[3], const double view[3], double c[9])
{
    const lobe_sh9 s = lobe_of(tier, (float)roughness, of(n), of(view));
    const float all[9] = {s.c0, s.c1, s.c2, s.c3, s.c4, s.c5, s.c6, s.c7, s.c8};
    for (int k = 0; k < 9; k++)
        c[k] = (double)all[k];
}

void lobe_diffuse_light(const double c[9], double sh[3][9], double rgb[3])
{
    for (int k = 0; k < 3; k++) {
        rgb[k] = 0;
        for (int i = 0; i < 9; i++)
            rgb[k] += c[i] * sh[k][i];
    }
}
