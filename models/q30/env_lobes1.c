/* lobe_env_lobes1 of ../env_taps.h in integers: see env_lobes.h. */
#include "env_lobes.h"
#include "../coeffs/env_lobes_lobes1.h"

static const int32_t lobe_env_lobes1_rows[LOBE_ENV_LOBES1_ROW_COUNT][LOBE_ENV_COLUMNS] = LOBE_ENV_LOBES1_ROWS;

void lobe_env_lobes1_q30(int32_t roughness, int32_t n_dot_v, lobe_env_tap_q30 taps[1])
{
    lobe_env_fan_q30(roughness, n_dot_v, lobe_env_lobes1_rows, 1, taps);
}
