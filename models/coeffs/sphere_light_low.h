/* Generated, not edited: build/lobefit fit sphere_light --tier low
 * BRDF     GGX, height-correlated Smith, alpha = roughness^2, F = 1
 * domain   alpha .05 to 1, half angle 1 to 45 degrees, view 0 to 85 degrees, lights above and through
 *          the horizon
 * grid     294 cells of 200 light positions, uniform and mixed: cases/sphere_light/cells.h
 * metric   relative L2 error of a cell over its positions, rms over the cells; cases/sphere_light/fit_tiers.h
 * error    uniform / mixed positions: all cells 0.1188 / 0.1224, worst cell 0.615 / 0.525,
 *          energy +0.357 / -0.223, on those cells, in double;
 *          what ships is measured on a finer one: sphere_light_bounds.h
 * seed     1
 * kernel   lobe_sphere_light_low in models/sphere_light.h, digest db6d9859d01bb49c */
#ifndef LOBE_COEFFS_SPHERE_LIGHT_LOW_H
#define LOBE_COEFFS_SPHERE_LIGHT_LOW_H
#if defined(LOBE_FIT)
#define LOBE_SPHERE_LIGHT_LOW_C0 p[0]
#define LOBE_SPHERE_LIGHT_LOW_C1 p[1]
#define LOBE_SPHERE_LIGHT_LOW_C2 p[2]
#define LOBE_SPHERE_LIGHT_LOW_C3 p[3]
#define LOBE_SPHERE_LIGHT_LOW_C4 p[4]
#define LOBE_SPHERE_LIGHT_LOW_C5 p[5]
#define LOBE_SPHERE_LIGHT_LOW_C6 p[6]
#define LOBE_SPHERE_LIGHT_LOW_C7 p[7]
#else
#define LOBE_SPHERE_LIGHT_LOW_C0 LOBE_R(0.170342028)
#define LOBE_SPHERE_LIGHT_LOW_C1 LOBE_R(0.133098975)
#define LOBE_SPHERE_LIGHT_LOW_C2 LOBE_R(0.70150435)
#define LOBE_SPHERE_LIGHT_LOW_C3 LOBE_R(3.00608349)
#define LOBE_SPHERE_LIGHT_LOW_C4 LOBE_R(0.81042856)
#define LOBE_SPHERE_LIGHT_LOW_C5 LOBE_R(1.70476758)
#define LOBE_SPHERE_LIGHT_LOW_C6 LOBE_R(0.190320656)
#define LOBE_SPHERE_LIGHT_LOW_C7 LOBE_R(0.606621921)
#endif
#endif
