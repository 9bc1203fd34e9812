#include "../sg_light_seen.h"
#include "sg_light_entry.h"

lobe_sg_f32 lobe_sg_seen_f32(lobe_vec3_f32 normal, lobe_vec3_f32 view, lobe_vec3_f32 axis, float sharpness)
{
    const lobe_sg s = lobe_sg_seen(lobe_vec3_of(normal.x, normal.y, normal.z), lobe_vec3_of(view.x, view.y, view.z),
                                   lobe_vec3_of(axis.x, axis.y, axis.z), sharpness);
    lobe_sg_f32 light;
    light.n_dot_v = s.n_dot_v;
    light.n_dot_l = s.n_dot_l;
    light.tangent2 = s.tangent2;
    light.versine = s.versine;
    return light;
}
