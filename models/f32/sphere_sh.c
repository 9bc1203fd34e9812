#include "../sphere_sh.h"
#include "sh9_entry.h"

lobe_sh9_f32 lobe_sphere_sh_f32(float sine, lobe_vec3_f32 direction)
{
    return lobe_sh9_out(lobe_sphere_sh(sine, lobe_vec3_of(direction.x, direction.y, direction.z)));
}
