#include "env_lobes_entry.h"

void lobe_env_lobes4_f32(float roughness, float n_dot_v, lobe_env_tap_f32 taps[4])
{
    const lobe_env_fan4 fan = lobe_env_lobes4(roughness, n_dot_v);
    taps[0] = lobe_env_tap_out(fan.t0);
    taps[1] = lobe_env_tap_out(fan.t1);
    taps[2] = lobe_env_tap_out(fan.t2);
    taps[3] = lobe_env_tap_out(fan.t3);
}
