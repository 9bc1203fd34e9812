#include "../lobe.h"
#include "../../core/q30.h"

int32_t lobe_reflectance_q30(lobe_dfg_q30 d, int32_t f0, int32_t f90)
{
    const int32_t at_normal = lobe_q_mul(lobe_q_saturate(f0), lobe_q_saturate(d.scale), 30);
    const int32_t at_grazing = lobe_q_mul(lobe_q_saturate(f90), lobe_q_saturate(d.bias), 30);
    return lobe_q_saturate(lobe_q_add_saturated(at_normal, at_grazing));
}

int32_t lobe_f90_of_f0_q30(int32_t f0)
{
    const int32_t two_percent = LOBE_Q30_ONE / 50 + 1;
    const int32_t held = lobe_q_clamp(f0, 0, two_percent);
    return lobe_q_saturate(50 * held);
}
