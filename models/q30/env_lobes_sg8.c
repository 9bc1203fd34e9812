/* lobe_env_lobes_sg8 of ../env_taps.h in integers: see env_lobes_sg.h. */
#include "env_lobes_sg.h"
#include "../coeffs/env_lobes_sg_lobes8.h"

static const int32_t lobe_env_lobes_sg8_rows[LOBE_ENV_LOBES_SG8_ROW_COUNT][LOBE_ENV_COLUMNS] = LOBE_ENV_LOBES_SG8_ROWS;

void lobe_env_lobes_sg8_q30(int32_t roughness, int32_t n_dot_v, lobe_env_sg_tap_q16 taps[8])
{
    lobe_env_sg_fan_q30(roughness, n_dot_v, lobe_env_lobes_sg8_rows, LOBE_ENV_LOBES_SG8_ROW_COUNT, 8, taps);
}
