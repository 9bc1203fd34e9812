/* One tap into a prefiltered environment; 24 coefficients. */
#ifndef LOBE_ENV_LOBES1_H
#define LOBE_ENV_LOBES1_H
#include "env_lobes.h"
#include "coeffs/env_lobes_lobes1.h"

/* The weights sum to albedo. */
LOBE_FN lobe_env_tap lobe_env_lobes_lobes1(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v, lobe_real albedo)
{
    lobe_env_point at = lobe_env_point_of(roughness, n_dot_v);
    LOBE_LET e = lobe_saturate(albedo);
    LOBE_LET shift0 = lobe_env_sum(at, LOBE_ENV_LOBES_LOBES1_C0, LOBE_ENV_LOBES_LOBES1_C1, LOBE_ENV_LOBES_LOBES1_C2,
                                   LOBE_ENV_LOBES_LOBES1_C3, LOBE_ENV_LOBES_LOBES1_C4, LOBE_ENV_LOBES_LOBES1_C5,
                                   LOBE_ENV_LOBES_LOBES1_C6, LOBE_ENV_LOBES_LOBES1_C7, LOBE_ENV_LOBES_LOBES1_C8,
                                   LOBE_ENV_LOBES_LOBES1_C9, LOBE_ENV_LOBES_LOBES1_C10, LOBE_ENV_LOBES_LOBES1_C11);
    LOBE_LET wide0 = lobe_env_sum(at, LOBE_ENV_LOBES_LOBES1_C12, LOBE_ENV_LOBES_LOBES1_C13, LOBE_ENV_LOBES_LOBES1_C14,
                                  LOBE_ENV_LOBES_LOBES1_C15, LOBE_ENV_LOBES_LOBES1_C16, LOBE_ENV_LOBES_LOBES1_C17,
                                  LOBE_ENV_LOBES_LOBES1_C18, LOBE_ENV_LOBES_LOBES1_C19, LOBE_ENV_LOBES_LOBES1_C20,
                                  LOBE_ENV_LOBES_LOBES1_C21, LOBE_ENV_LOBES_LOBES1_C22, LOBE_ENV_LOBES_LOBES1_C23);
    return lobe_env_tap_of(at, shift0, wide0, e);
}

#endif
