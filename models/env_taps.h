/* Fans of taps for environment specular with the albedo that their weights sum to: lobe_energy_high (energy.h), which
 * is within 6e-5 of the truth where roughness and n_dot_v are in [.02, 1] and within .0018 below. Whoever has an albedo
 * already, as scale + bias of a split sum, calls the kernels of env_lobes.h and env_lobes_sg.h with that instead and
 * saves 77 operations; both inputs are clamped to [0, 1], NaN counts as 0. Not for the fitter, which tries the
 * coefficients of one model at a time. */
#ifndef LOBE_ENV_TAPS_H
#define LOBE_ENV_TAPS_H
#include "energy.h"
#include "env_lobes1.h"
#include "env_lobes2.h"
#include "env_lobes4.h"
#include "env_lobes8.h"
#include "env_lobes_adaptive.h"
#include "env_lobes_sg.h"

#if !defined(LOBE_FIT)

LOBE_FN lobe_env_tap lobe_env_lobes1(lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET albedo = lobe_energy_high(roughness, n_dot_v);
    return lobe_env_lobes_lobes1(roughness, n_dot_v, albedo);
}

LOBE_FN lobe_env_fan2 lobe_env_lobes2(lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET albedo = lobe_energy_high(roughness, n_dot_v);
    return lobe_env_lobes_lobes2(roughness, n_dot_v, albedo);
}

LOBE_FN lobe_env_fan4 lobe_env_lobes4(lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET albedo = lobe_energy_high(roughness, n_dot_v);
    return lobe_env_lobes_lobes4(roughness, n_dot_v, albedo);
}

LOBE_FN lobe_env_fan8 lobe_env_lobes8(lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET albedo = lobe_energy_high(roughness, n_dot_v);
    return lobe_env_lobes_lobes8(roughness, n_dot_v, albedo);
}

LOBE_FN lobe_env_fan6 lobe_env_lobes_adaptive(lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET albedo = lobe_energy_high(roughness, n_dot_v);
    return lobe_env_adaptive_fan(roughness, n_dot_v, albedo);
}

LOBE_FN lobe_env_tap lobe_env_lobes_sg1(lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET albedo = lobe_energy_high(roughness, n_dot_v);
    return lobe_env_lobes_sg_lobes1(roughness, n_dot_v, albedo);
}

LOBE_FN lobe_env_sg2 lobe_env_lobes_sg2(lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET albedo = lobe_energy_high(roughness, n_dot_v);
    return lobe_env_lobes_sg_lobes2(roughness, n_dot_v, albedo);
}

LOBE_FN lobe_env_sg4 lobe_env_lobes_sg4(lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET albedo = lobe_energy_high(roughness, n_dot_v);
    return lobe_env_lobes_sg_lobes4(roughness, n_dot_v, albedo);
}

LOBE_FN lobe_env_sg8 lobe_env_lobes_sg8(lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET albedo = lobe_energy_high(roughness, n_dot_v);
    return lobe_env_lobes_sg_lobes8(roughness, n_dot_v, albedo);
}
#endif

#endif
