#include "env_lobes_entry.h"

int lobe_env_lobes_adaptive_f32(float roughness, float n_dot_v, lobe_env_tap_f32 taps[6])
{
    const lobe_env_fan6 fan = lobe_env_lobes_adaptive(roughness, n_dot_v);
    taps[0] = lobe_env_tap_out(fan.t0);
    taps[1] = lobe_env_tap_out(fan.t1);
    taps[2] = lobe_env_tap_out(fan.t2);
    taps[3] = lobe_env_tap_out(fan.t3);
    taps[4] = lobe_env_tap_out(fan.t4);
    taps[5] = lobe_env_tap_out(fan.t5);
    return (int)lobe_env_adaptive_count(roughness, n_dot_v);
}
