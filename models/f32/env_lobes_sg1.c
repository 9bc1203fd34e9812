#include "env_lobes_entry.h"

void lobe_env_lobes_sg1_f32(float roughness, float n_dot_v, lobe_env_sg_tap_f32 taps[1])
{
    taps[0] = lobe_env_sg_tap_out(lobe_env_lobes_sg1(roughness, n_dot_v));
}
