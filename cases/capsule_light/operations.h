/* Operations of the candidates beyond a punctual light, counted from the texts of their kernels. */
#ifndef LOBE_CAPSULE_LIGHT_OPERATIONS_H
#define LOBE_CAPSULE_LIGHT_OPERATIONS_H
#ifdef __cplusplus
extern "C" {
#endif

/* Fused multiply-add, add, multiply, select, min and max 1; division and root 4; equal subexpressions and divisors
 * once; clamps of the inputs nothing. -1 where no candidate of that name is counted. */
int lobe_capsule_operations(const char *name);

#ifdef __cplusplus
}
#endif
#endif
