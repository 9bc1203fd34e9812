/* lobe_env_lobes_sg2 of ../env_taps.h in integers: see env_lobes_sg.h. */
#include "env_lobes_sg.h"
#include "../coeffs/env_lobes_sg_lobes2.h"

static const int32_t lobe_env_lobes_sg2_rows[LOBE_ENV_LOBES_SG2_ROW_COUNT][LOBE_ENV_COLUMNS] = LOBE_ENV_LOBES_SG2_ROWS;

void lobe_env_lobes_sg2_q30(int32_t roughness, int32_t n_dot_v, lobe_env_sg_tap_q16 taps[2])
{
    lobe_env_sg_fan_q30(roughness, n_dot_v, lobe_env_lobes_sg2_rows, LOBE_ENV_LOBES_SG2_ROW_COUNT, 2, taps);
}
