/* What ships of this case, read several times with other meanings of the macro. A new tier is a line here and one in
 * harness/registry_rows.h.
 *   columns: tier, prefix of the bounds in models/coeffs/sphere_diffuse_bounds.h */
TIER(low, LOBE_SPHERE_DIFFUSE_LOW)
TIER(medium, LOBE_SPHERE_DIFFUSE_MEDIUM)
TIER(exact, LOBE_SPHERE_DIFFUSE_EXACT)
