/* What ships of this case, read several times with other meanings of the macros. A new tier is a line here and one in
 * harness/registry_rows.h.
 *   columns: tier, prefix of the bounds in models/coeffs/sg_light_bounds.h */
SG_F32(low, LOBE_SG_LIGHT_LOW)
SG_Q30(low, LOBE_SG_LIGHT_LOW)
SG_F32(medium, LOBE_SG_LIGHT_MEDIUM)
SG_Q30(medium, LOBE_SG_LIGHT_MEDIUM)
SG_F32(high, LOBE_SG_LIGHT_HIGH)
SG_Q30(high, LOBE_SG_LIGHT_HIGH)
