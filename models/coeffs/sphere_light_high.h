/* Generated, not edited: build/lobefit fit sphere_light --tier high
 * BRDF     GGX, height-correlated Smith, alpha = roughness^2, F = 1
 * domain   alpha .05 to 1, half angle 1 to 45 degrees, view 0 to 85 degrees, lights above and through
 *          the horizon
 * grid     294 cells of 200 light positions, uniform and mixed: cases/sphere_light/cells.h
 * metric   relative L2 error of a cell over its positions, rms over the cells; cases/sphere_light/lit_tiers.h
 * error    uniform / mixed positions: all cells 0.03996 / 0.03951, worst cell 0.249 / 0.226,
 *          energy +0.223 / +0.213, on those cells, in double;
 *          F0 = .02 adds +0.247 / -0.426 points to all cells;
 *          what ships is measured on a finer one: sphere_light_bounds.h
 * seed     1
 * kernel   lobe_sphere_high_risen in models/sphere_light_high.h, digest f75d5075fce5f981 */
#ifndef LOBE_COEFFS_SPHERE_LIGHT_HIGH_H
#define LOBE_COEFFS_SPHERE_LIGHT_HIGH_H
#if defined(LOBE_FIT)
#define LOBE_SPHERE_LIGHT_HIGH_C0 p[0]
#define LOBE_SPHERE_LIGHT_HIGH_C1 p[1]
#define LOBE_SPHERE_LIGHT_HIGH_C2 p[2]
#define LOBE_SPHERE_LIGHT_HIGH_C3 p[3]
#define LOBE_SPHERE_LIGHT_HIGH_C4 p[4]
#define LOBE_SPHERE_LIGHT_HIGH_C5 p[5]
#define LOBE_SPHERE_LIGHT_HIGH_C6 p[6]
#define LOBE_SPHERE_LIGHT_HIGH_C7 p[7]
#define LOBE_SPHERE_LIGHT_HIGH_C8 p[8]
#define LOBE_SPHERE_LIGHT_HIGH_C9 p[9]
#define LOBE_SPHERE_LIGHT_HIGH_C10 p[10]
#define LOBE_SPHERE_LIGHT_HIGH_C11 p[11]
#define LOBE_SPHERE_LIGHT_HIGH_C12 p[12]
#define LOBE_SPHERE_LIGHT_HIGH_C13 p[13]
#define LOBE_SPHERE_LIGHT_HIGH_C14 p[14]
#define LOBE_SPHERE_LIGHT_HIGH_C15 p[15]
#define LOBE_SPHERE_LIGHT_HIGH_C16 p[16]
#else
#define LOBE_SPHERE_LIGHT_HIGH_C0 LOBE_R(0.83933872)
#define LOBE_SPHERE_LIGHT_HIGH_C1 LOBE_R(0.257717013)
#define LOBE_SPHERE_LIGHT_HIGH_C2 LOBE_R(-0.562072456)
#define LOBE_SPHERE_LIGHT_HIGH_C3 LOBE_R(-0.0593150631)
#define LOBE_SPHERE_LIGHT_HIGH_C4 LOBE_R(-0.440864921)
#define LOBE_SPHERE_LIGHT_HIGH_C5 LOBE_R(0.487020433)
#define LOBE_SPHERE_LIGHT_HIGH_C6 LOBE_R(0.253581971)
#define LOBE_SPHERE_LIGHT_HIGH_C7 LOBE_R(1.91554594)
#define LOBE_SPHERE_LIGHT_HIGH_C8 LOBE_R(0.240446106)
#define LOBE_SPHERE_LIGHT_HIGH_C9 LOBE_R(-1.31079233)
#define LOBE_SPHERE_LIGHT_HIGH_C10 LOBE_R(0.104204044)
#define LOBE_SPHERE_LIGHT_HIGH_C11 LOBE_R(-0.173925817)
#define LOBE_SPHERE_LIGHT_HIGH_C12 LOBE_R(0.363214344)
#define LOBE_SPHERE_LIGHT_HIGH_C13 LOBE_R(0.575947523)
#define LOBE_SPHERE_LIGHT_HIGH_C14 LOBE_R(-0.0535758808)
#define LOBE_SPHERE_LIGHT_HIGH_C15 LOBE_R(0.0251345485)
#define LOBE_SPHERE_LIGHT_HIGH_C16 LOBE_R(0.0995341167)
#endif
#endif
