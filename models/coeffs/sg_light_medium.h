/* Generated, not edited: build/lobefit fit sg_light --tier medium
 * BRDF     GGX, height-correlated Smith, alpha = roughness^2, F = 1
 * domain   alpha .05 to 1, sharpness 4 to 4096, n_dot_v .05 to 1, axes above and below the horizon
 * grid     216 cells of 120 positions of the axis, uniform and mixed: cases/sg_light/cells.h
 * metric   relative L2 error of a cell over its positions, rms over the cells; cases/sg_light/fit_tiers.h
 * error    uniform / mixed positions: all cells 0.09416 / 0.08199, smooth 0.05523 / 0.05928,
 *          worst cell 0.322 / 0.268, energy +0.272 / -0.196, on those cells, in double;
 *          what ships is measured on a finer one: sg_light_bounds.h
 * seed     1
 * kernel   lobe_sg_light_medium in models/sg_light.h, digest 8e810ebb6c7733c2 */
#ifndef LOBE_COEFFS_SG_LIGHT_MEDIUM_H
#define LOBE_COEFFS_SG_LIGHT_MEDIUM_H
#if defined(LOBE_FIT)
#define LOBE_SG_LIGHT_MEDIUM_C0 p[0]
#define LOBE_SG_LIGHT_MEDIUM_C1 p[1]
#define LOBE_SG_LIGHT_MEDIUM_C2 p[2]
#define LOBE_SG_LIGHT_MEDIUM_C3 p[3]
#define LOBE_SG_LIGHT_MEDIUM_C4 p[4]
#define LOBE_SG_LIGHT_MEDIUM_C5 p[5]
#define LOBE_SG_LIGHT_MEDIUM_C6 p[6]
#else
#define LOBE_SG_LIGHT_MEDIUM_C0 LOBE_R(0.500240028)
#define LOBE_SG_LIGHT_MEDIUM_C1 LOBE_R(5.64919281)
#define LOBE_SG_LIGHT_MEDIUM_C2 LOBE_R(0.567691028)
#define LOBE_SG_LIGHT_MEDIUM_C3 LOBE_R(0.611612916)
#define LOBE_SG_LIGHT_MEDIUM_C4 LOBE_R(2.80565572)
#define LOBE_SG_LIGHT_MEDIUM_C5 LOBE_R(1.60105741)
#define LOBE_SG_LIGHT_MEDIUM_C6 LOBE_R(0.119928621)
#endif
#endif
