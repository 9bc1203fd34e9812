/* Generated, not edited: build/lobefit fit capsule_light --tier medium
 * BRDF     GGX, height-correlated Smith, alpha = roughness^2, F = 1
 * domain   alpha .05 to 1, radius 1.5 to 15 degrees, half length .1 to 1 distance, view 0 to 85 degrees,
 *          lights above and through the horizon
 * grid     225 cells of 60 capsules: cases/capsule_light/cells.h
 * metric   relative L2 error of a cell over its positions, rms over the cells; cases/capsule_light/fit_tiers.h
 * error    all cells 0.1015, worst cell 0.434, energy +0.145, on those cells, in double;
 *          what ships is measured on a finer one: capsule_light_bounds.h
 * seed     1
 * kernel   lobe_capsule_line in models/capsule_light.h, digest f5869c9a49353c50 */
#ifndef LOBE_COEFFS_CAPSULE_LIGHT_MEDIUM_H
#define LOBE_COEFFS_CAPSULE_LIGHT_MEDIUM_H
#if defined(LOBE_FIT)
#define LOBE_CAPSULE_LIGHT_MEDIUM_C0 p[0]
#define LOBE_CAPSULE_LIGHT_MEDIUM_C1 p[1]
#define LOBE_CAPSULE_LIGHT_MEDIUM_C2 p[2]
#define LOBE_CAPSULE_LIGHT_MEDIUM_C3 p[3]
#define LOBE_CAPSULE_LIGHT_MEDIUM_C4 p[4]
#define LOBE_CAPSULE_LIGHT_MEDIUM_C5 p[5]
#define LOBE_CAPSULE_LIGHT_MEDIUM_C6 p[6]
#define LOBE_CAPSULE_LIGHT_MEDIUM_C7 p[7]
#else
#define LOBE_CAPSULE_LIGHT_MEDIUM_C0 LOBE_R(0.0839020386)
#define LOBE_CAPSULE_LIGHT_MEDIUM_C1 LOBE_R(0.353189349)
#define LOBE_CAPSULE_LIGHT_MEDIUM_C2 LOBE_R(0.291638702)
#define LOBE_CAPSULE_LIGHT_MEDIUM_C3 LOBE_R(6.3534503)
#define LOBE_CAPSULE_LIGHT_MEDIUM_C4 LOBE_R(0.693381786)
#define LOBE_CAPSULE_LIGHT_MEDIUM_C5 LOBE_R(0.857344866)
#define LOBE_CAPSULE_LIGHT_MEDIUM_C6 LOBE_R(0.0912156552)
#define LOBE_CAPSULE_LIGHT_MEDIUM_C7 LOBE_R(0.979472637)
#endif
#endif
