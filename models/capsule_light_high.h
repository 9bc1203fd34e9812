/* Capsule light on the closed form of the sphere. */
#ifndef LOBE_CAPSULE_LIGHT_HIGH_H
#define LOBE_CAPSULE_LIGHT_HIGH_H
#include "capsule_light.h"
#include "sphere_light_high.h"
#include "coeffs/capsule_light_high.h"

LOBE_FN lobe_real lobe_capsule_light_high(LOBE_COEFFS lobe_real roughness, lobe_capsule light)
{
    lobe_capsule_terms k = lobe_capsule_terms_of(
        LOBE_CAPSULE_LIGHT_HIGH_C0, LOBE_CAPSULE_LIGHT_HIGH_C1, LOBE_CAPSULE_LIGHT_HIGH_C2, LOBE_CAPSULE_LIGHT_HIGH_C3,
        LOBE_CAPSULE_LIGHT_HIGH_C4, LOBE_CAPSULE_LIGHT_HIGH_C5, LOBE_CAPSULE_LIGHT_HIGH_C6, LOBE_CAPSULE_LIGHT_HIGH_C7);
    lobe_capsule_spot spot = lobe_capsule_line(roughness, light, k);
    LOBE_LET y = lobe_sphere_light_high(roughness, spot.light);
    return lobe_capsule_bent(y, spot.more, k.bend);
}

#endif
