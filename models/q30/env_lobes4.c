/* lobe_env_lobes4 of ../env_taps.h in integers: see env_lobes.h. */
#include "env_lobes.h"
#include "../coeffs/env_lobes_lobes4.h"

static const int32_t lobe_env_lobes4_rows[LOBE_ENV_LOBES4_ROW_COUNT][LOBE_ENV_COLUMNS] = LOBE_ENV_LOBES4_ROWS;

void lobe_env_lobes4_q30(int32_t roughness, int32_t n_dot_v, lobe_env_tap_q30 taps[4])
{
    lobe_env_fan_q30(roughness, n_dot_v, lobe_env_lobes4_rows, 4, taps);
}
