/* What ships of this case, read several times with other meanings of the macros. A new tier is a line here and one in
 * harness/registry_rows.h.
 *   columns: tier, prefix of the bounds in models/coeffs/diffuse_sh_bounds.h */
SH9(exact, LOBE_DIFFUSE_SH_EXACT)
SH9(medium, LOBE_DIFFUSE_SH_MEDIUM)
SH9(low, LOBE_DIFFUSE_SH_LOW)
SH9(zonal, LOBE_DIFFUSE_SH_ZONAL)
SH9(zonal_low, LOBE_DIFFUSE_SH_ZONAL_LOW)
SH9_CONSTANT(lambert, LOBE_DIFFUSE_SH_LAMBERT)
