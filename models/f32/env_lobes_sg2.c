#include "env_lobes_entry.h"

void lobe_env_lobes_sg2_f32(float roughness, float n_dot_v, lobe_env_sg_tap_f32 taps[2])
{
    const lobe_env_sg2 fan = lobe_env_lobes_sg2(roughness, n_dot_v);
    taps[0] = lobe_env_sg_tap_out(fan.t0);
    taps[1] = lobe_env_sg_tap_out(fan.t1);
}
