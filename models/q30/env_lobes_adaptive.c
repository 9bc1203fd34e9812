/* lobe_env_lobes_adaptive of ../env_taps.h in integers: see env_lobes_adaptive.h. */
#include "env_lobes_adaptive.h"
#include "../coeffs/env_lobes_adaptive.h"

static const int32_t lobe_env_need_row[LOBE_ENV_ADAPTIVE_NEEDS] = LOBE_ENV_NEED_ROW;
static const int32_t lobe_env_adaptive_rows[LOBE_ENV_ADAPTIVE_ROW_COUNT][LOBE_ENV_ADAPTIVE_COLUMNS] =
    LOBE_ENV_ADAPTIVE_ROWS;

int lobe_env_lobes_adaptive_q30(int32_t roughness, int32_t n_dot_v, lobe_env_tap_q30 taps[6])
{
    const lobe_env_fixed p = lobe_env_fixed_of(roughness, n_dot_v);
    uint32_t rest = (uint32_t)lobe_q16_from_q30(p.e);
    int32_t gate[LOBE_ENV_ADAPTIVE_GATES];
    int i, count = 1;
    lobe_env_gates_fixed(&p, roughness, lobe_env_need_row, gate);
    for (i = 0; i < LOBE_ENV_ADAPTIVE_TAPS; i++) {
        const int first = i ? 3 * i - 1 : 0;
        if (i && gate[i - 1] == 0) {
            taps[i] = taps[0];
            taps[i].weight_q16 = 0;
            continue;
        }
        count = i + 1;
        taps[i].angle =
            lobe_qs_fixed(lobe_env_angle_fixed(&p, lobe_env_gated_fixed(&p, gate, lobe_env_adaptive_rows[first])), 30);
        taps[i].width = lobe_env_width_fixed(&p, lobe_env_gated_fixed(&p, gate, lobe_env_adaptive_rows[first + 1]));
        if (i) {
            const lobe_q_scaled part =
                lobe_env_scaled(lobe_env_gated_fixed(&p, gate, lobe_env_adaptive_rows[first + 2]));
            const lobe_q_scaled open = lobe_qs_mul(lobe_qs_of(p.e, 0), lobe_qs_of(gate[i - 1], 0));
            taps[i].weight_q16 = lobe_qs_fixed(lobe_qs_mul(open, part), 16);
            rest -= (uint32_t)taps[i].weight_q16;
        }
    }
    taps[0].weight_q16 = (int32_t)rest;
    return count;
}
