#include "sphere_sh.h"

static void add_q30(lobe_sh9_q16 *channel, int32_t radiance, const lobe_sh9_q30 *light)
{
    const int32_t held = lobe_q_max(radiance, 0);
    int k;
    for (k = 0; k < 9; k++) {
        /* |light| < 2, so the product may have 32 bits: half of it twice, within one unit. */
        const int32_t half = lobe_q_mul(held, light->c[k], 31);
        channel->c[k] = lobe_q_add_saturated(lobe_q_add_saturated(channel->c[k], half), half);
    }
}

void lobe_lighting_add_sphere_q16(lobe_lighting_q16 *lighting, lobe_vec3_q16 radiance, int32_t sine_q30,
                                  lobe_vec3_q30 direction)
{
    const lobe_sh9_q30 light = lobe_sphere_sh_of_q30(sine_q30, direction);
    add_q30(&lighting->red, radiance.x, &light);
    add_q30(&lighting->green, radiance.y, &light);
    add_q30(&lighting->blue, radiance.z, &light);
}
