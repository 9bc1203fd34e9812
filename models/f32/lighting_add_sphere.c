#include "../sphere_sh.h"
#include "sh9_entry.h"

static float held_f32(float x) { return lobe_clamp(x, -3.40282347e+38f, 3.40282347e+38f); }

static void add_f32(lobe_sh9_f32 *channel, float radiance, const lobe_sh9 *light)
{
    int k;
    *channel =
        lobe_sh9_out(lobe_sh9_add_scaled(lobe_sh9_in(channel), lobe_clamp(radiance, 0.0f, 3.40282347e+38f), *light));
    for (k = 0; k < 9; k++)
        channel->c[k] = held_f32(channel->c[k]);
}

void lobe_lighting_add_sphere_f32(lobe_lighting_f32 *lighting, lobe_vec3_f32 radiance, float sine,
                                  lobe_vec3_f32 direction)
{
    const lobe_sh9 light = lobe_sphere_sh(sine, lobe_vec3_of(direction.x, direction.y, direction.z));
    add_f32(&lighting->red, radiance.x, &light);
    add_f32(&lighting->green, radiance.y, &light);
    add_f32(&lighting->blue, radiance.z, &light);
}
