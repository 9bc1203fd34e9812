#include "../sphere_light_seen.h"
#include "sphere_light_entry.h"

lobe_sphere_f32 lobe_sphere_of_f32(float n_dot_v, float n_dot_l, float tangent2, float sine)
{
    return lobe_sphere_out(lobe_sphere_of(n_dot_v, n_dot_l, tangent2, sine));
}

lobe_sphere_f32 lobe_sphere_seen_f32(lobe_vec3_f32 normal, lobe_vec3_f32 view, lobe_vec3_f32 to_centre, float radius)
{
    return lobe_sphere_out(lobe_sphere_seen(lobe_vec3_of(normal.x, normal.y, normal.z),
                                            lobe_vec3_of(view.x, view.y, view.z),
                                            lobe_vec3_of(to_centre.x, to_centre.y, to_centre.z), radius));
}
