/* Generated, not edited: build/lobefit fit sphere_light --tier low
 * BRDF     GGX, height-correlated Smith, alpha = roughness^2, F = 1
 * domain   alpha .05 to 1, half angle 1 to 45 degrees, view 0 to 85 degrees, lights above and through
 *          the horizon
 * grid     294 cells of 200 light positions, uniform and mixed: cases/sphere_light/cells.h
 * metric   relative L2 error of a cell over its positions, rms over the cells; cases/sphere_light/fit_tiers.h
 * error    uniform / mixed positions: all cells 0.1256 / 0.1395, worst cell 0.683 / 0.729,
 *          energy +0.514 / +0.502, on those cells, in double;
 *          what ships is measured on a finer one: sphere_light_bounds.h
 * seed     1
 * kernel   lobe_sphere_light_low in models/sphere_light.h, digest 804c907e3b991807 */
#ifndef LOBE_COEFFS_SPHERE_LIGHT_LOW_H
#define LOBE_COEFFS_SPHERE_LIGHT_LOW_H
#if defined(LOBE_FIT)
#define LOBE_SPHERE_LIGHT_LOW_C0 p[0]
#define LOBE_SPHERE_LIGHT_LOW_C1 p[1]
#define LOBE_SPHERE_LIGHT_LOW_C2 p[2]
#define LOBE_SPHERE_LIGHT_LOW_C3 p[3]
#define LOBE_SPHERE_LIGHT_LOW_C4 p[4]
#define LOBE_SPHERE_LIGHT_LOW_C5 p[5]
#else
#define LOBE_SPHERE_LIGHT_LOW_C0 LOBE_R(0.11708115)
#define LOBE_SPHERE_LIGHT_LOW_C1 LOBE_R(1.08365428)
#define LOBE_SPHERE_LIGHT_LOW_C2 LOBE_R(1.14378691)
#define LOBE_SPHERE_LIGHT_LOW_C3 LOBE_R(0.131234959)
#define LOBE_SPHERE_LIGHT_LOW_C4 LOBE_R(0.613038778)
#define LOBE_SPHERE_LIGHT_LOW_C5 LOBE_R(3.8370645)
#endif
#endif
