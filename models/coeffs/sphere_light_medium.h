/* Generated, not edited: build/lobefit fit sphere_light --tier medium
 * BRDF     GGX, height-correlated Smith, alpha = roughness^2, F = 1
 * domain   alpha .05 to 1, half angle 1 to 45 degrees, view 0 to 85 degrees, lights above and through
 *          the horizon
 * grid     294 cells of 200 light positions, uniform and mixed: cases/sphere_light/cells.h
 * metric   relative L2 error of a cell over its positions, rms over the cells; cases/sphere_light/fit_tiers.h
 * error    uniform / mixed positions: all cells 0.09658 / 0.08329, worst cell 0.469 / 0.254,
 *          energy +0.563 / -0.213, on those cells, in double;
 *          what ships is measured on a finer one: sphere_light_bounds.h
 * seed     1
 * kernel   lobe_sphere_light_medium in models/sphere_light.h, digest cf10967692fdcc66 */
#ifndef LOBE_COEFFS_SPHERE_LIGHT_MEDIUM_H
#define LOBE_COEFFS_SPHERE_LIGHT_MEDIUM_H
#if defined(LOBE_FIT)
#define LOBE_SPHERE_LIGHT_MEDIUM_C0 p[0]
#define LOBE_SPHERE_LIGHT_MEDIUM_C1 p[1]
#define LOBE_SPHERE_LIGHT_MEDIUM_C2 p[2]
#define LOBE_SPHERE_LIGHT_MEDIUM_C3 p[3]
#define LOBE_SPHERE_LIGHT_MEDIUM_C4 p[4]
#define LOBE_SPHERE_LIGHT_MEDIUM_C5 p[5]
#else
#define LOBE_SPHERE_LIGHT_MEDIUM_C0 LOBE_R(0.121418953)
#define LOBE_SPHERE_LIGHT_MEDIUM_C1 LOBE_R(5.74988508)
#define LOBE_SPHERE_LIGHT_MEDIUM_C2 LOBE_R(0.0820185393)
#define LOBE_SPHERE_LIGHT_MEDIUM_C3 LOBE_R(0.579964221)
#define LOBE_SPHERE_LIGHT_MEDIUM_C4 LOBE_R(2.12015748)
#define LOBE_SPHERE_LIGHT_MEDIUM_C5 LOBE_R(1.11908031)
#endif
#endif
