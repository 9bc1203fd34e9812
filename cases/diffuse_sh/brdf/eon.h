/* EON, the energy-preserving Oren-Nayar of Portsmouth, Kutz and Hill (2024), base colour 1; roughness is their r.
 * Fujii's single scattering plus (1 - E(v))(1 - E(l)) / (1 - mean E); G(mu) / pi by their polynomial (to 6e-4). */
#ifndef LOBE_BRDF_EON_H
#define LOBE_BRDF_EON_H
#include "../../../core/scalar.h"

/* E(mu) / A of the single scattering: 1 + roughness G(mu) / pi. */
LOBE_FN lobe_real lobe_brdf_eon_albedo(lobe_real mu, lobe_real roughness)
{
    LOBE_LET x = LOBE_R(1.0) - mu;
    LOBE_LET g1 = LOBE_R(0.491881867) + x * (LOBE_R(-0.332181442) + x * LOBE_R(0.0714429953));
    LOBE_LET e = LOBE_R(1.0) + roughness * (x * (LOBE_R(0.0571085289) + x * g1));
    return e;
}

LOBE_FN lobe_real lobe_brdf_eon(lobe_real n_dot_l, lobe_real n_dot_v, lobe_real l_dot_v, lobe_real roughness)
{
    LOBE_LET a = LOBE_R(1.0) / (LOBE_R(1.0) + LOBE_R(0.28779340921080617) * roughness); /* 1/2 - 2/(3 pi) */
    LOBE_LET s = l_dot_v - n_dot_l * n_dot_v;
    LOBE_LET high = lobe_max(lobe_max(n_dot_l, n_dot_v), LOBE_R(1e-12));
    LOBE_LET t = lobe_select(s, high, LOBE_R(1.0));
    LOBE_LET single = a * (LOBE_R(1.0) + roughness * s / t);
    LOBE_LET el = a * lobe_brdf_eon_albedo(n_dot_l, roughness);
    LOBE_LET ev = a * lobe_brdf_eon_albedo(n_dot_v, roughness);
    LOBE_LET mean = a * (LOBE_R(1.0) + LOBE_R(0.072488212456921) * roughness); /* 2/3 - 28/(15 pi) */
    LOBE_LET lost = lobe_max(LOBE_R(1.0) - mean, LOBE_R(1e-7));
    LOBE_LET many = (LOBE_R(1.0) - el) * (LOBE_R(1.0) - ev) / lost;
    LOBE_LET f = LOBE_R(0.31830988618379067) * (single + many);
    return f;
}

#endif
