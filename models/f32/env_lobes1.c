#include "env_lobes_entry.h"

void lobe_env_lobes1_f32(float roughness, float n_dot_v, lobe_env_tap_f32 taps[1])
{
    taps[0] = lobe_env_tap_out(lobe_env_lobes1(roughness, n_dot_v));
}
