#include "../capsule_light_seen.h"
#include "capsule_light_entry.h"

lobe_capsule_f32 lobe_capsule_seen_f32(lobe_vec3_f32 normal, lobe_vec3_f32 view, lobe_vec3_f32 to_end0,
                                       lobe_vec3_f32 to_end1, float radius)
{
    const lobe_capsule c = lobe_capsule_seen(
        lobe_vec3_of(normal.x, normal.y, normal.z), lobe_vec3_of(view.x, view.y, view.z),
        lobe_vec3_of(to_end0.x, to_end0.y, to_end0.z), lobe_vec3_of(to_end1.x, to_end1.y, to_end1.z), radius);
    lobe_capsule_f32 y;
    y.n_dot_v = c.n_dot_v;
    y.middle.x = c.mx;
    y.middle.y = c.my;
    y.middle.z = c.mz;
    y.arm.x = c.ex;
    y.arm.y = c.ey;
    y.arm.z = c.ez;
    y.radius = c.radius;
    return y;
}
