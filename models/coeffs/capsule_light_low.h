/* Generated, not edited: build/lobefit fit capsule_light --tier low
 * BRDF     GGX, height-correlated Smith, alpha = roughness^2, F = 1
 * domain   alpha .05 to 1, radius 1.5 to 15 degrees, half length .1 to 1 distance, view 0 to 85 degrees,
 *          lights above and through the horizon
 * grid     225 cells of 60 capsules: cases/capsule_light/cells.h
 * metric   relative L2 error of a cell over its positions, rms over the cells; cases/capsule_light/fit_tiers.h
 * error    all cells 0.247, worst cell 0.843, energy +0.474, on those cells, in double;
 *          what ships is measured on a finer one: capsule_light_bounds.h
 * seed     1
 * kernel   lobe_capsule_light_low in models/capsule_light.h, digest 354331db28eedf85 */
#ifndef LOBE_COEFFS_CAPSULE_LIGHT_LOW_H
#define LOBE_COEFFS_CAPSULE_LIGHT_LOW_H
#if defined(LOBE_FIT)
#define LOBE_CAPSULE_LIGHT_LOW_C0 p[0]
#define LOBE_CAPSULE_LIGHT_LOW_C1 p[1]
#define LOBE_CAPSULE_LIGHT_LOW_C2 p[2]
#define LOBE_CAPSULE_LIGHT_LOW_C3 p[3]
#else
#define LOBE_CAPSULE_LIGHT_LOW_C0 LOBE_R(0.478666097)
#define LOBE_CAPSULE_LIGHT_LOW_C1 LOBE_R(0.59473753)
#define LOBE_CAPSULE_LIGHT_LOW_C2 LOBE_R(2.50540137)
#define LOBE_CAPSULE_LIGHT_LOW_C3 LOBE_R(1.56865394)
#endif
#endif
