/* The rows of the registry, read several times with other meanings of DFG_F32 and its siblings.
 * A new tier is a line here, one in its case's tier_rows.h, and its model's bounds in registry.c.
 * A model of another shape needs its own pair of macros, NAME_F32 and NAME_Q30, in three places: twice in registry.c
 * (the functions that call it; its row, by ROW_OF, with a lobe_range an input) and in ports/count.c (its type); and its
 * kernel's inputs are scalars, or structs S that LOBE_FN S_of makes of scalars (ports/kernels.awk). Everything else
 * follows the row.
 *   columns: model, tier, prefix of the bounds in models/coeffs/MODEL_bounds.h
 *   DFG_F32, DFG_Q30: scale and bias, with an array version; DFG_Q30_SCALAR: without
 *   ENERGY_F32, ENERGY_Q30: E
 *   SH9_F32, SH9_Q30: nine coefficients, with an array version; SH9_CONSTANT_F32, SH9_CONSTANT_Q30: of no inputs
 *   SPHERE_F32, SPHERE_Q30: radiance of a sphere light, of five inputs
 *   SCHLICK_F32, SCHLICK_Q30: its Fresnel, of the same five, by a function of another name, which is the fourth column;
 *   LIT_F32, LIT_Q30: the same where that function gives it beside the radiance
 *   CAPSULE_F32, CAPSULE_Q30: the same of a capsule, of nine
 *   SG_F32, SG_Q30: radiance of a spherical Gaussian light, of five
 *   SPHERE_DIFFUSE_F32, SPHERE_DIFFUSE_Q30: a sphere's irradiance over pi, of two */
DFG_F32(split_sum, low, LOBE_SPLIT_SUM_LOW)
DFG_Q30(split_sum, low, LOBE_SPLIT_SUM_LOW)
DFG_F32(split_sum, medium, LOBE_SPLIT_SUM_MEDIUM)
DFG_Q30(split_sum, medium, LOBE_SPLIT_SUM_MEDIUM)
DFG_F32(split_sum, high, LOBE_SPLIT_SUM_HIGH)
DFG_Q30(split_sum, high, LOBE_SPLIT_SUM_HIGH)
DFG_F32(split_sum, table32, LOBE_SPLIT_SUM_TABLE32)
DFG_Q30(split_sum, table32, LOBE_SPLIT_SUM_TABLE32)
DFG_F32(split_sum, table64, LOBE_SPLIT_SUM_TABLE64)
DFG_Q30(split_sum, table64, LOBE_SPLIT_SUM_TABLE64)
DFG_F32(split_sum, table128, LOBE_SPLIT_SUM_TABLE128)
DFG_Q30(split_sum, table128, LOBE_SPLIT_SUM_TABLE128)
DFG_F32(split_sum_sep, low, LOBE_SPLIT_SUM_SEP_LOW)
DFG_Q30(split_sum_sep, low, LOBE_SPLIT_SUM_SEP_LOW)
DFG_F32(split_sum_sep, medium, LOBE_SPLIT_SUM_SEP_MEDIUM)
DFG_Q30(split_sum_sep, medium, LOBE_SPLIT_SUM_SEP_MEDIUM)
DFG_F32(split_sum_sep, high, LOBE_SPLIT_SUM_SEP_HIGH)
DFG_Q30(split_sum_sep, high, LOBE_SPLIT_SUM_SEP_HIGH)
DFG_F32(split_sum_sep, table32, LOBE_SPLIT_SUM_SEP_TABLE32)
DFG_Q30(split_sum_sep, table32, LOBE_SPLIT_SUM_SEP_TABLE32)
DFG_F32(split_sum_sep, table64, LOBE_SPLIT_SUM_SEP_TABLE64)
DFG_Q30(split_sum_sep, table64, LOBE_SPLIT_SUM_SEP_TABLE64)
DFG_F32(split_sum_sep, table128, LOBE_SPLIT_SUM_SEP_TABLE128)
DFG_Q30(split_sum_sep, table128, LOBE_SPLIT_SUM_SEP_TABLE128)
ENERGY_F32(energy, low, LOBE_ENERGY_LOW)
ENERGY_Q30(energy, low, LOBE_ENERGY_LOW)
ENERGY_F32(energy, medium, LOBE_ENERGY_MEDIUM)
ENERGY_Q30(energy, medium, LOBE_ENERGY_MEDIUM)
ENERGY_F32(energy, high, LOBE_ENERGY_HIGH)
ENERGY_Q30(energy, high, LOBE_ENERGY_HIGH)
SH9_F32(diffuse_sh, exact, LOBE_DIFFUSE_SH_EXACT)
SH9_Q30(diffuse_sh, exact, LOBE_DIFFUSE_SH_EXACT)
SH9_F32(diffuse_sh, medium, LOBE_DIFFUSE_SH_MEDIUM)
SH9_Q30(diffuse_sh, medium, LOBE_DIFFUSE_SH_MEDIUM)
SH9_F32(diffuse_sh, low, LOBE_DIFFUSE_SH_LOW)
SH9_Q30(diffuse_sh, low, LOBE_DIFFUSE_SH_LOW)
SH9_F32(diffuse_sh, zonal, LOBE_DIFFUSE_SH_ZONAL)
SH9_Q30(diffuse_sh, zonal, LOBE_DIFFUSE_SH_ZONAL)
SH9_F32(diffuse_sh, zonal_low, LOBE_DIFFUSE_SH_ZONAL_LOW)
SH9_Q30(diffuse_sh, zonal_low, LOBE_DIFFUSE_SH_ZONAL_LOW)
SH9_CONSTANT_F32(diffuse_sh, lambert, LOBE_DIFFUSE_SH_LAMBERT)
SH9_CONSTANT_Q30(diffuse_sh, lambert, LOBE_DIFFUSE_SH_LAMBERT)
SPHERE_F32(sphere_light, low, LOBE_SPHERE_LIGHT_LOW)
SPHERE_Q30(sphere_light, low, LOBE_SPHERE_LIGHT_LOW)
SPHERE_F32(sphere_light, medium, LOBE_SPHERE_LIGHT_MEDIUM)
SPHERE_Q30(sphere_light, medium, LOBE_SPHERE_LIGHT_MEDIUM)
SPHERE_F32(sphere_light, high, LOBE_SPHERE_LIGHT_HIGH)
SPHERE_Q30(sphere_light, high, LOBE_SPHERE_LIGHT_HIGH)
SCHLICK_F32(sphere_light_schlick, low, LOBE_SPHERE_LIGHT_SCHLICK_LOW, lobe_sphere_light_schlick)
SCHLICK_Q30(sphere_light_schlick, low, LOBE_SPHERE_LIGHT_SCHLICK_LOW, lobe_sphere_light_schlick)
LIT_F32(sphere_light_schlick, high, LOBE_SPHERE_LIGHT_SCHLICK_HIGH, lobe_sphere_light_high_lit)
LIT_Q30(sphere_light_schlick, high, LOBE_SPHERE_LIGHT_SCHLICK_HIGH, lobe_sphere_light_high_lit)
CAPSULE_F32(capsule_light, low, LOBE_CAPSULE_LIGHT_LOW)
CAPSULE_Q30(capsule_light, low, LOBE_CAPSULE_LIGHT_LOW)
CAPSULE_F32(capsule_light, medium, LOBE_CAPSULE_LIGHT_MEDIUM)
CAPSULE_Q30(capsule_light, medium, LOBE_CAPSULE_LIGHT_MEDIUM)
CAPSULE_F32(capsule_light, high, LOBE_CAPSULE_LIGHT_HIGH)
CAPSULE_Q30(capsule_light, high, LOBE_CAPSULE_LIGHT_HIGH)
SG_F32(sg_light, medium, LOBE_SG_LIGHT_MEDIUM)
SG_Q30(sg_light, medium, LOBE_SG_LIGHT_MEDIUM)
SG_F32(sg_light, high, LOBE_SG_LIGHT_HIGH)
SG_Q30(sg_light, high, LOBE_SG_LIGHT_HIGH)
SPHERE_DIFFUSE_F32(sphere_diffuse, low, LOBE_SPHERE_DIFFUSE_LOW)
SPHERE_DIFFUSE_Q30(sphere_diffuse, low, LOBE_SPHERE_DIFFUSE_LOW)
SPHERE_DIFFUSE_F32(sphere_diffuse, medium, LOBE_SPHERE_DIFFUSE_MEDIUM)
SPHERE_DIFFUSE_Q30(sphere_diffuse, medium, LOBE_SPHERE_DIFFUSE_MEDIUM)
SPHERE_DIFFUSE_F32(sphere_diffuse, exact, LOBE_SPHERE_DIFFUSE_EXACT)
SPHERE_DIFFUSE_Q30(sphere_diffuse, exact, LOBE_SPHERE_DIFFUSE_EXACT)
