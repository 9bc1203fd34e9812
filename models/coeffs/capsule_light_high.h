/* Generated, not edited: build/lobefit fit capsule_light --tier high
 * BRDF     GGX, height-correlated Smith, alpha = roughness^2, F = 1
 * domain   alpha .05 to 1, radius 1.5 to 15 degrees, half length .1 to 1 distance, view 0 to 85 degrees,
 *          lights above and through the horizon
 * grid     225 cells of 60 capsules: cases/capsule_light/cells.h
 * metric   relative L2 error of a cell over its positions, rms over the cells; cases/capsule_light/fit_tiers.h
 * error    all cells 0.08255, worst cell 0.312, energy -0.14, on those cells, in double;
 *          what ships is measured on a finer one: capsule_light_bounds.h
 * seed     1
 * kernel   lobe_capsule_line in models/capsule_light.h, digest f5869c9a49353c50 */
#ifndef LOBE_COEFFS_CAPSULE_LIGHT_HIGH_H
#define LOBE_COEFFS_CAPSULE_LIGHT_HIGH_H
#if defined(LOBE_FIT)
#define LOBE_CAPSULE_LIGHT_HIGH_C0 p[0]
#define LOBE_CAPSULE_LIGHT_HIGH_C1 p[1]
#define LOBE_CAPSULE_LIGHT_HIGH_C2 p[2]
#define LOBE_CAPSULE_LIGHT_HIGH_C3 p[3]
#define LOBE_CAPSULE_LIGHT_HIGH_C4 p[4]
#define LOBE_CAPSULE_LIGHT_HIGH_C5 p[5]
#define LOBE_CAPSULE_LIGHT_HIGH_C6 p[6]
#define LOBE_CAPSULE_LIGHT_HIGH_C7 p[7]
#else
#define LOBE_CAPSULE_LIGHT_HIGH_C0 LOBE_R(0.0846532583)
#define LOBE_CAPSULE_LIGHT_HIGH_C1 LOBE_R(-0.627072632)
#define LOBE_CAPSULE_LIGHT_HIGH_C2 LOBE_R(1.52851844)
#define LOBE_CAPSULE_LIGHT_HIGH_C3 LOBE_R(2.59504366)
#define LOBE_CAPSULE_LIGHT_HIGH_C4 LOBE_R(0.730074167)
#define LOBE_CAPSULE_LIGHT_HIGH_C5 LOBE_R(0.869448841)
#define LOBE_CAPSULE_LIGHT_HIGH_C6 LOBE_R(0.112226546)
#define LOBE_CAPSULE_LIGHT_HIGH_C7 LOBE_R(0.971740365)
#endif
#endif
