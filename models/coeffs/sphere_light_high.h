/* Generated, not edited: build/lobefit fit sphere_light --tier high
 * BRDF     GGX, height-correlated Smith, alpha = roughness^2, F = 1
 * domain   alpha .05 to 1, half angle 1 to 45 degrees, view 0 to 85 degrees, lights above and through
 *          the horizon
 * grid     294 cells of 200 light positions, uniform and mixed: cases/sphere_light/cells.h
 * metric   relative L2 error of a cell over its positions, rms over the cells; cases/sphere_light/fit_tiers.h
 * error    uniform / mixed positions: all cells 0.03724 / 0.03332, worst cell 0.26 / 0.169,
 *          energy +0.153 / +0.145, on those cells, in double;
 *          what ships is measured on a finer one: sphere_light_bounds.h
 * seed     1
 * kernel   lobe_sphere_light_high in models/sphere_light_high.h, digest 198fa239e1701e22 */
#ifndef LOBE_COEFFS_SPHERE_LIGHT_HIGH_H
#define LOBE_COEFFS_SPHERE_LIGHT_HIGH_H
#if defined(LOBE_FIT)
#define LOBE_SPHERE_LIGHT_HIGH_C0 p[0]
#define LOBE_SPHERE_LIGHT_HIGH_C1 p[1]
#define LOBE_SPHERE_LIGHT_HIGH_C2 p[2]
#define LOBE_SPHERE_LIGHT_HIGH_C3 p[3]
#define LOBE_SPHERE_LIGHT_HIGH_C4 p[4]
#else
#define LOBE_SPHERE_LIGHT_HIGH_C0 LOBE_R(0.508655131)
#define LOBE_SPHERE_LIGHT_HIGH_C1 LOBE_R(0.523353696)
#define LOBE_SPHERE_LIGHT_HIGH_C2 LOBE_R(-0.538729966)
#define LOBE_SPHERE_LIGHT_HIGH_C3 LOBE_R(-0.332529426)
#define LOBE_SPHERE_LIGHT_HIGH_C4 LOBE_R(-0.458416879)
#endif
#endif
