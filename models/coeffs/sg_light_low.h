/* Generated, not edited: build/lobefit fit sg_light --tier low
 * BRDF     GGX, height-correlated Smith, alpha = roughness^2, F = 1
 * domain   alpha .05 to 1, sharpness 4 to 4096, n_dot_v .05 to 1, axes above and below the horizon
 * grid     216 cells of 120 positions of the axis, uniform and mixed: cases/sg_light/cells.h
 * metric   relative L2 error of a cell over its positions, rms over the cells; cases/sg_light/fit_tiers.h
 * error    uniform / mixed positions: all cells 0.1436 / 0.1109, smooth 0.09076 / 0.07079,
 *          worst cell 0.888 / 0.412, energy -0.524 / -0.42, on those cells, in double;
 *          what ships is measured on a finer one: sg_light_bounds.h
 * seed     1
 * kernel   lobe_sg_light_low in models/sg_light.h, digest 75bc6e6a2345d56a */
#ifndef LOBE_COEFFS_SG_LIGHT_LOW_H
#define LOBE_COEFFS_SG_LIGHT_LOW_H
#if defined(LOBE_FIT)
#define LOBE_SG_LIGHT_LOW_C0 p[0]
#define LOBE_SG_LIGHT_LOW_C1 p[1]
#define LOBE_SG_LIGHT_LOW_C2 p[2]
#define LOBE_SG_LIGHT_LOW_C3 p[3]
#define LOBE_SG_LIGHT_LOW_C4 p[4]
#define LOBE_SG_LIGHT_LOW_C5 p[5]
#define LOBE_SG_LIGHT_LOW_C6 p[6]
#define LOBE_SG_LIGHT_LOW_C7 p[7]
#else
#define LOBE_SG_LIGHT_LOW_C0 LOBE_R(0.641928196)
#define LOBE_SG_LIGHT_LOW_C1 LOBE_R(1.6311121)
#define LOBE_SG_LIGHT_LOW_C2 LOBE_R(0.226484865)
#define LOBE_SG_LIGHT_LOW_C3 LOBE_R(0.0715517625)
#define LOBE_SG_LIGHT_LOW_C4 LOBE_R(0.722934306)
#define LOBE_SG_LIGHT_LOW_C5 LOBE_R(1.10803044)
#define LOBE_SG_LIGHT_LOW_C6 LOBE_R(1.06364012)
#define LOBE_SG_LIGHT_LOW_C7 LOBE_R(0.195304766)
#endif
#endif
