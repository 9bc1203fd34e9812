/* The public f32 functions of a fan: its taps as an array. */
#ifndef LOBE_ENV_LOBES_ENTRY_H
#define LOBE_ENV_LOBES_ENTRY_H
#include "../lobe.h"
#include "../env_taps.h"

static inline lobe_env_tap_f32 lobe_env_tap_out(lobe_env_tap a)
{
    const lobe_env_tap_f32 tap = {a.angle, a.width, a.weight};
    return tap;
}

static inline lobe_env_sg_tap_f32 lobe_env_sg_tap_out(lobe_env_tap a)
{
    const lobe_env_sg_tap_f32 tap = {a.angle, a.width, a.weight};
    return tap;
}

#endif
