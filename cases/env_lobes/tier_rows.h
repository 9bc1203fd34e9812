/* What ships of both models of environment lobes, read several times with other meanings of the macros. A new tier is
 * a line here and one in harness/registry_rows.h.
 *   columns: model, tier, prefix of the bounds in models/coeffs/MODEL_bounds.h, the function without its format, and
 *   its number of taps; ENV_SG: of spherical Gaussians */
ENV(env_lobes, lobes1, LOBE_ENV_LOBES_LOBES1, lobe_env_lobes1, 1)
ENV(env_lobes, lobes2, LOBE_ENV_LOBES_LOBES2, lobe_env_lobes2, 2)
ENV(env_lobes, lobes4, LOBE_ENV_LOBES_LOBES4, lobe_env_lobes4, 4)
ENV(env_lobes, lobes8, LOBE_ENV_LOBES_LOBES8, lobe_env_lobes8, 8)
ENV(env_lobes, lobes1_table16, LOBE_ENV_LOBES_LOBES1_TABLE16, lobe_env_lobes1_table16, 1)
ENV(env_lobes, lobes2_table16, LOBE_ENV_LOBES_LOBES2_TABLE16, lobe_env_lobes2_table16, 2)
ENV(env_lobes, lobes4_table16, LOBE_ENV_LOBES_LOBES4_TABLE16, lobe_env_lobes4_table16, 4)
ENV(env_lobes, lobes8_table16, LOBE_ENV_LOBES_LOBES8_TABLE16, lobe_env_lobes8_table16, 8)
ENV(env_lobes, adaptive, LOBE_ENV_LOBES_ADAPTIVE, lobe_env_lobes_adaptive, 6)
ENV_SG(env_lobes_sg, lobes1, LOBE_ENV_LOBES_SG_LOBES1, lobe_env_lobes_sg1, 1)
ENV_SG(env_lobes_sg, lobes2, LOBE_ENV_LOBES_SG_LOBES2, lobe_env_lobes_sg2, 2)
ENV_SG(env_lobes_sg, lobes4, LOBE_ENV_LOBES_SG_LOBES4, lobe_env_lobes_sg4, 4)
ENV_SG(env_lobes_sg, lobes8, LOBE_ENV_LOBES_SG_LOBES8, lobe_env_lobes_sg8, 8)
