/* Generated, not edited: build/lobefit fit sphere_light --tier schlick
 * BRDF     GGX, height-correlated Smith, alpha = roughness^2, F = 1
 * domain   alpha .05 to 1, half angle 1 to 45 degrees, view 0 to 85 degrees, lights above and through
 *          the horizon
 * grid     294 cells of 200 light positions, uniform and mixed: cases/sphere_light/cells.h
 * metric   relative L2 error of a cell over its positions, rms over the cells; cases/sphere_light/lit_tiers.h
 * error    uniform / mixed positions: F0 = .02 adds to all cells of low +1.447 / +1.852 points,
 *          of medium +2.274 / +1.708, on those cells, in double;
 *          what ships is measured on a finer one: sphere_light_bounds.h
 * seed     1
 * kernel   lobe_sphere_light_schlick in models/sphere_light_schlick.h, digest 5304ab18d1f7f604 */
#ifndef LOBE_COEFFS_SPHERE_LIGHT_SCHLICK_H
#define LOBE_COEFFS_SPHERE_LIGHT_SCHLICK_H
#if defined(LOBE_FIT)
#define LOBE_SPHERE_LIGHT_SCHLICK_C0 p[0]
#define LOBE_SPHERE_LIGHT_SCHLICK_C1 p[1]
#define LOBE_SPHERE_LIGHT_SCHLICK_C2 p[2]
#define LOBE_SPHERE_LIGHT_SCHLICK_C3 p[3]
#define LOBE_SPHERE_LIGHT_SCHLICK_C4 p[4]
#else
#define LOBE_SPHERE_LIGHT_SCHLICK_C0 LOBE_R(0.803403556)
#define LOBE_SPHERE_LIGHT_SCHLICK_C1 LOBE_R(1.81609738)
#define LOBE_SPHERE_LIGHT_SCHLICK_C2 LOBE_R(0.951155066)
#define LOBE_SPHERE_LIGHT_SCHLICK_C3 LOBE_R(0.485537469)
#define LOBE_SPHERE_LIGHT_SCHLICK_C4 LOBE_R(-1.49549186)
#endif
#endif
