/* Energy that a single-scattering lobe loses, given back as a factor on the lobe. */
#ifndef LOBE_COMPENSATION_H
#define LOBE_COMPENSATION_H
#include "../core/scalar.h"

/* Factor for a reflectance f0: 1 + f0 (1/E - 1). Exact for f0 = 1 (white furnace) and for f0 = 0.
 * inverse_e is 1/E, at least 1 (clamped to [1, 4]; E of correlated GGX is never below 1/3.3). 2 operations.
 * Source: Turquin 2019, equation 16. */
LOBE_FN lobe_real lobe_compensation(lobe_real f0, lobe_real inverse_e)
{
    LOBE_LET lost = lobe_clamp(inverse_e, LOBE_R(1.0), LOBE_R(4.0)) - LOBE_R(1.0);
    LOBE_LET factor = LOBE_R(1.0) + lobe_saturate(f0) * lost;
    return factor;
}

/* Published stand-ins for 1/E, kept for comparison: 1 + 2 alpha^2 n_dot_v. Furnace error of f E - 1 on correlated
 * GGX, alpha = roughness^2: see the chart. 4 operations. */
LOBE_FN lobe_real lobe_inverse_energy_alpha2_view(lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET a = r * r;
    LOBE_LET twice = a * a + a * a;
    LOBE_LET factor = LOBE_R(1.0) + twice * lobe_saturate(n_dot_v);
    return factor;
}

/* 1 + alpha^2, likewise. 2 operations. */
LOBE_FN lobe_real lobe_inverse_energy_alpha2(lobe_real roughness)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET a = r * r;
    LOBE_LET factor = LOBE_R(1.0) + a * a;
    return factor;
}

#endif
