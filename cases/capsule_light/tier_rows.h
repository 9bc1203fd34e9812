/* What ships of this case, read several times with other meanings of the macros. A new tier is a line here and one in
 * harness/registry_rows.h.
 *   columns: tier, prefix of the bounds in models/coeffs/capsule_light_bounds.h */
CAPSULE_F32(low, LOBE_CAPSULE_LIGHT_LOW)
CAPSULE_Q30(low, LOBE_CAPSULE_LIGHT_LOW)
CAPSULE_F32(medium, LOBE_CAPSULE_LIGHT_MEDIUM)
CAPSULE_Q30(medium, LOBE_CAPSULE_LIGHT_MEDIUM)
CAPSULE_F32(high, LOBE_CAPSULE_LIGHT_HIGH)
CAPSULE_Q30(high, LOBE_CAPSULE_LIGHT_HIGH)
