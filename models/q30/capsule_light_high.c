/* lobe_capsule_light_high of ../capsule_light_high.h in integers. */
#include "capsule_light.h"
#include "../../core/dialect.h"
#include "../coeffs/capsule_light_high.h"

static const lobe_capsule_terms_scaled lobe_capsule_high_terms = {
    LOBE_QS_CONSTANT(LOBE_CAPSULE_LIGHT_HIGH_C0), LOBE_QS_CONSTANT(LOBE_CAPSULE_LIGHT_HIGH_C1),
    LOBE_QS_CONSTANT(LOBE_CAPSULE_LIGHT_HIGH_C2), LOBE_QS_CONSTANT(LOBE_CAPSULE_LIGHT_HIGH_C3),
    LOBE_QS_CONSTANT(LOBE_CAPSULE_LIGHT_HIGH_C4), LOBE_QS_CONSTANT(LOBE_CAPSULE_LIGHT_HIGH_C5),
    LOBE_QS_CONSTANT(LOBE_CAPSULE_LIGHT_HIGH_C6), LOBE_QS_CONSTANT(LOBE_CAPSULE_LIGHT_HIGH_C7)};

lobe_scaled_q30 lobe_capsule_light_high_q30(int32_t roughness, lobe_capsule_q30 light)
{
    const lobe_capsule_terms_scaled *k = &lobe_capsule_high_terms;
    const lobe_capsule_spot_scaled spot = lobe_capsule_line_q30(roughness, light, k);
    return lobe_capsule_bent_q30(lobe_sphere_light_high_q30(roughness, spot.light), spot.more, k->bend);
}
