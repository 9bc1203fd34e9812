/* Operations of the candidates beyond a punctual light, counted from the texts of their kernels. */
#ifndef LOBE_SPHERE_LIGHT_OPERATIONS_H
#define LOBE_SPHERE_LIGHT_OPERATIONS_H
#ifdef __cplusplus
extern "C" {
#endif

/* Fused multiply-add, add, multiply, select, min and max 1; division, root, exp2 and log2 4; equal subexpressions and
 * divisors once; clamps of the inputs and fetches of textures nothing. -1 where no candidate of that name is counted.
 */
int lobe_sphere_operations(const char *name);

#ifdef __cplusplus
}
#endif
#endif
