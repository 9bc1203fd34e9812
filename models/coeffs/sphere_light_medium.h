/* Generated, not edited: build/lobefit fit sphere_light --tier medium
 * BRDF     GGX, height-correlated Smith, alpha = roughness^2, F = 1
 * domain   alpha .05 to 1, half angle 1 to 45 degrees, view 0 to 85 degrees, lights above and through
 *          the horizon
 * grid     294 cells of 200 light positions, uniform and mixed: cases/sphere_light/cells.h
 * metric   relative L2 error of a cell over its positions, rms over the cells; cases/sphere_light/fit_tiers.h
 * error    uniform / mixed positions: all cells 0.09064 / 0.06967, worst cell 0.543 / 0.205,
 *          energy +0.306 / -0.182, on those cells, in double;
 *          what ships is measured on a finer one: sphere_light_bounds.h
 * seed     1
 * kernel   lobe_sphere_light_medium in models/sphere_light.h, digest 84a2a67aa821f947 */
#ifndef LOBE_COEFFS_SPHERE_LIGHT_MEDIUM_H
#define LOBE_COEFFS_SPHERE_LIGHT_MEDIUM_H
#if defined(LOBE_FIT)
#define LOBE_SPHERE_LIGHT_MEDIUM_C0 p[0]
#define LOBE_SPHERE_LIGHT_MEDIUM_C1 p[1]
#define LOBE_SPHERE_LIGHT_MEDIUM_C2 p[2]
#define LOBE_SPHERE_LIGHT_MEDIUM_C3 p[3]
#define LOBE_SPHERE_LIGHT_MEDIUM_C4 p[4]
#define LOBE_SPHERE_LIGHT_MEDIUM_C5 p[5]
#define LOBE_SPHERE_LIGHT_MEDIUM_C6 p[6]
#define LOBE_SPHERE_LIGHT_MEDIUM_C7 p[7]
#define LOBE_SPHERE_LIGHT_MEDIUM_C8 p[8]
#define LOBE_SPHERE_LIGHT_MEDIUM_C9 p[9]
#else
#define LOBE_SPHERE_LIGHT_MEDIUM_C0 LOBE_R(0.287939638)
#define LOBE_SPHERE_LIGHT_MEDIUM_C1 LOBE_R(0.201451793)
#define LOBE_SPHERE_LIGHT_MEDIUM_C2 LOBE_R(5.24582481)
#define LOBE_SPHERE_LIGHT_MEDIUM_C3 LOBE_R(1.52370644)
#define LOBE_SPHERE_LIGHT_MEDIUM_C4 LOBE_R(0.202274695)
#define LOBE_SPHERE_LIGHT_MEDIUM_C5 LOBE_R(0.291428596)
#define LOBE_SPHERE_LIGHT_MEDIUM_C6 LOBE_R(1.03065455)
#define LOBE_SPHERE_LIGHT_MEDIUM_C7 LOBE_R(-0.862078905)
#define LOBE_SPHERE_LIGHT_MEDIUM_C8 LOBE_R(0.440598935)
#define LOBE_SPHERE_LIGHT_MEDIUM_C9 LOBE_R(0.294725478)
#endif
#endif
