#include "env_lobes_entry.h"

void lobe_env_lobes_sg8_f32(float roughness, float n_dot_v, lobe_env_sg_tap_f32 taps[8])
{
    const lobe_env_sg8 fan = lobe_env_lobes_sg8(roughness, n_dot_v);
    taps[0] = lobe_env_sg_tap_out(fan.t0);
    taps[1] = lobe_env_sg_tap_out(fan.t1);
    taps[2] = lobe_env_sg_tap_out(fan.t2);
    taps[3] = lobe_env_sg_tap_out(fan.t3);
    taps[4] = lobe_env_sg_tap_out(fan.t4);
    taps[5] = lobe_env_sg_tap_out(fan.t5);
    taps[6] = lobe_env_sg_tap_out(fan.t6);
    taps[7] = lobe_env_sg_tap_out(fan.t7);
}
