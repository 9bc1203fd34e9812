/* What ships of this case, read several times with other meanings of the macros. A new tier is a line here and one in
 * harness/registry_rows.h.
 *   columns: tier, prefix of the bounds in models/coeffs/sphere_light_bounds.h */
SPHERE_F32(low, LOBE_SPHERE_LIGHT_LOW)
SPHERE_Q30(low, LOBE_SPHERE_LIGHT_LOW)
SPHERE_F32(medium, LOBE_SPHERE_LIGHT_MEDIUM)
SPHERE_Q30(medium, LOBE_SPHERE_LIGHT_MEDIUM)
SPHERE_F32(high, LOBE_SPHERE_LIGHT_HIGH)
SPHERE_Q30(high, LOBE_SPHERE_LIGHT_HIGH)
