/* lobe_capsule_light_low of ../capsule_light.h in integers. */
#include "capsule_light.h"
#include "../../core/dialect.h"
#include "../coeffs/capsule_light_low.h"

static const lobe_q_scaled lobe_capsule_low_c0 = LOBE_QS_CONSTANT(LOBE_CAPSULE_LIGHT_LOW_C0);
static const lobe_q_scaled lobe_capsule_low_c1 = LOBE_QS_CONSTANT(LOBE_CAPSULE_LIGHT_LOW_C1);
static const lobe_q_scaled lobe_capsule_low_c2 = LOBE_QS_CONSTANT(LOBE_CAPSULE_LIGHT_LOW_C2);
static const lobe_q_scaled lobe_capsule_low_c3 = LOBE_QS_CONSTANT(LOBE_CAPSULE_LIGHT_LOW_C3);

lobe_scaled_q30 lobe_capsule_light_low_q30(int32_t roughness, lobe_capsule_q30 light)
{
    const lobe_q_scaled a = lobe_capsule_alpha_q30(roughness);
    lobe_capsule_scaled c = lobe_capsule_clamped_q30(light);
    lobe_capsule_risen_q30(&c, lobe_qs_zero, lobe_qs_one);
    {
        const lobe_q_scaled ee = lobe_qs_dot(c.e, c.e), extent = lobe_qs_sqrt(ee);
        const lobe_q_scaled least = lobe_qs_add(lobe_qs_shifted(ee, -20), lobe_qs_two_to(-60));
        const lobe_q_scaled nearest = lobe_capsule_nearest_q30(&c, least);
        const lobe_q_scaled t = lobe_qs_div(lobe_qs_mul(nearest, extent), lobe_qs_mad(extent, lobe_capsule_low_c0, a));
        const lobe_q_scaled seen = lobe_qs_mul(a, lobe_qs_mad(lobe_capsule_low_c1, lobe_capsule_low_c2, c.v));
        const lobe_capsule_strip_scaled strip = lobe_capsule_strip_q30(&c, t);
        const lobe_q_scaled part = lobe_qs_div(seen, lobe_qs_add(seen, strip.across));
        const lobe_q_scaled more = lobe_qs_mul(strip.spheres, part);
        return lobe_capsule_bent_q30(lobe_sphere_light_low_q30(roughness, strip.light), more, lobe_capsule_low_c3);
    }
}
