/* lobe_env_lobes_sg4 of ../env_taps.h in integers: see env_lobes_sg.h. */
#include "env_lobes_sg.h"
#include "../coeffs/env_lobes_sg_lobes4.h"

static const int32_t lobe_env_lobes_sg4_rows[LOBE_ENV_LOBES_SG4_ROW_COUNT][LOBE_ENV_COLUMNS] = LOBE_ENV_LOBES_SG4_ROWS;

void lobe_env_lobes_sg4_q30(int32_t roughness, int32_t n_dot_v, lobe_env_sg_tap_q16 taps[4])
{
    lobe_env_sg_fan_q30(roughness, n_dot_v, lobe_env_lobes_sg4_rows, LOBE_ENV_LOBES_SG4_ROW_COUNT, 4, taps);
}
