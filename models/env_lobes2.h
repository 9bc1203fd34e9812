/* 2 taps into a prefiltered environment; 60 coefficients. */
#ifndef LOBE_ENV_LOBES2_H
#define LOBE_ENV_LOBES2_H
#include "env_lobes.h"
#include "coeffs/env_lobes_lobes2.h"

LOBE_STRUCT(lobe_env_fan2)
{
    lobe_env_tap t0;
    lobe_env_tap t1;
};

/* The weights sum to albedo. */
LOBE_FN lobe_env_fan2 lobe_env_lobes_lobes2(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v, lobe_real albedo)
{
    lobe_env_point at = lobe_env_point_of(roughness, n_dot_v);
    LOBE_LET e = lobe_saturate(albedo);
    LOBE_LET shift0 = lobe_env_sum(at, LOBE_ENV_LOBES_LOBES2_C0, LOBE_ENV_LOBES_LOBES2_C1, LOBE_ENV_LOBES_LOBES2_C2,
                                   LOBE_ENV_LOBES_LOBES2_C3, LOBE_ENV_LOBES_LOBES2_C4, LOBE_ENV_LOBES_LOBES2_C5,
                                   LOBE_ENV_LOBES_LOBES2_C6, LOBE_ENV_LOBES_LOBES2_C7, LOBE_ENV_LOBES_LOBES2_C8,
                                   LOBE_ENV_LOBES_LOBES2_C9, LOBE_ENV_LOBES_LOBES2_C10, LOBE_ENV_LOBES_LOBES2_C11);
    LOBE_LET wide0 = lobe_env_sum(at, LOBE_ENV_LOBES_LOBES2_C12, LOBE_ENV_LOBES_LOBES2_C13, LOBE_ENV_LOBES_LOBES2_C14,
                                  LOBE_ENV_LOBES_LOBES2_C15, LOBE_ENV_LOBES_LOBES2_C16, LOBE_ENV_LOBES_LOBES2_C17,
                                  LOBE_ENV_LOBES_LOBES2_C18, LOBE_ENV_LOBES_LOBES2_C19, LOBE_ENV_LOBES_LOBES2_C20,
                                  LOBE_ENV_LOBES_LOBES2_C21, LOBE_ENV_LOBES_LOBES2_C22, LOBE_ENV_LOBES_LOBES2_C23);
    LOBE_LET part0 = lobe_env_sum(at, LOBE_ENV_LOBES_LOBES2_C24, LOBE_ENV_LOBES_LOBES2_C25, LOBE_ENV_LOBES_LOBES2_C26,
                                  LOBE_ENV_LOBES_LOBES2_C27, LOBE_ENV_LOBES_LOBES2_C28, LOBE_ENV_LOBES_LOBES2_C29,
                                  LOBE_ENV_LOBES_LOBES2_C30, LOBE_ENV_LOBES_LOBES2_C31, LOBE_ENV_LOBES_LOBES2_C32,
                                  LOBE_ENV_LOBES_LOBES2_C33, LOBE_ENV_LOBES_LOBES2_C34, LOBE_ENV_LOBES_LOBES2_C35);
    LOBE_LET shift1 = lobe_env_sum(at, LOBE_ENV_LOBES_LOBES2_C36, LOBE_ENV_LOBES_LOBES2_C37, LOBE_ENV_LOBES_LOBES2_C38,
                                   LOBE_ENV_LOBES_LOBES2_C39, LOBE_ENV_LOBES_LOBES2_C40, LOBE_ENV_LOBES_LOBES2_C41,
                                   LOBE_ENV_LOBES_LOBES2_C42, LOBE_ENV_LOBES_LOBES2_C43, LOBE_ENV_LOBES_LOBES2_C44,
                                   LOBE_ENV_LOBES_LOBES2_C45, LOBE_ENV_LOBES_LOBES2_C46, LOBE_ENV_LOBES_LOBES2_C47);
    LOBE_LET wide1 = lobe_env_sum(at, LOBE_ENV_LOBES_LOBES2_C48, LOBE_ENV_LOBES_LOBES2_C49, LOBE_ENV_LOBES_LOBES2_C50,
                                  LOBE_ENV_LOBES_LOBES2_C51, LOBE_ENV_LOBES_LOBES2_C52, LOBE_ENV_LOBES_LOBES2_C53,
                                  LOBE_ENV_LOBES_LOBES2_C54, LOBE_ENV_LOBES_LOBES2_C55, LOBE_ENV_LOBES_LOBES2_C56,
                                  LOBE_ENV_LOBES_LOBES2_C57, LOBE_ENV_LOBES_LOBES2_C58, LOBE_ENV_LOBES_LOBES2_C59);
    LOBE_LET w0 = e * part0;
    LOBE_LET w1 = e - w0;
    lobe_env_fan2 fan;
    fan.t0 = lobe_env_tap_of(at, shift0, wide0, w0);
    fan.t1 = lobe_env_tap_of(at, shift1, wide1, w1);
    return fan;
}

#endif
