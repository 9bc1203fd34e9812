/* The public f32 function of a capsule light's kernel. */
#ifndef LOBE_CAPSULE_LIGHT_ENTRY_H
#define LOBE_CAPSULE_LIGHT_ENTRY_H
#include "../lobe.h"

LOBE_FN lobe_capsule lobe_capsule_in(lobe_capsule_f32 a)
{
    return lobe_capsule_of(a.n_dot_v, a.middle.x, a.middle.y, a.middle.z, a.arm.x, a.arm.y, a.arm.z, a.radius);
}

#define LOBE_CAPSULE_LIGHT_F32(name)                                                                                   \
    float name##_f32(float roughness, lobe_capsule_f32 light) { return name(roughness, lobe_capsule_in(light)); }

#endif
