/* Generated, not edited: build/lobefit fit sg_light --tier high
 * BRDF     GGX, height-correlated Smith, alpha = roughness^2, F = 1
 * domain   alpha .05 to 1, sharpness 4 to 4096, n_dot_v .05 to 1, axes above and below the horizon
 * grid     216 cells of 120 positions of the axis, uniform and mixed: cases/sg_light/cells.h
 * metric   relative L2 error of a cell over its positions, rms over the cells; cases/sg_light/fit_tiers.h
 * error    uniform / mixed positions: all cells 0.09289 / 0.06751, smooth 0.06292 / 0.05366,
 *          worst cell 0.582 / 0.181, energy +0.617 / +0.175, on those cells, in double;
 *          what ships is measured on a finer one: sg_light_bounds.h
 * seed     1
 * kernel   lobe_sg_light_high in models/sg_light_high.h, digest a60a3ef430bfd0b7 */
#ifndef LOBE_COEFFS_SG_LIGHT_HIGH_H
#define LOBE_COEFFS_SG_LIGHT_HIGH_H
#if defined(LOBE_FIT)
#define LOBE_SG_LIGHT_HIGH_C0 p[0]
#define LOBE_SG_LIGHT_HIGH_C1 p[1]
#define LOBE_SG_LIGHT_HIGH_C2 p[2]
#define LOBE_SG_LIGHT_HIGH_C3 p[3]
#define LOBE_SG_LIGHT_HIGH_C4 p[4]
#define LOBE_SG_LIGHT_HIGH_C5 p[5]
#define LOBE_SG_LIGHT_HIGH_C6 p[6]
#define LOBE_SG_LIGHT_HIGH_C7 p[7]
#define LOBE_SG_LIGHT_HIGH_C8 p[8]
#define LOBE_SG_LIGHT_HIGH_C9 p[9]
#define LOBE_SG_LIGHT_HIGH_C10 p[10]
#define LOBE_SG_LIGHT_HIGH_C11 p[11]
#define LOBE_SG_LIGHT_HIGH_C12 p[12]
#else
#define LOBE_SG_LIGHT_HIGH_C0 LOBE_R(0.177885652)
#define LOBE_SG_LIGHT_HIGH_C1 LOBE_R(1.99396062)
#define LOBE_SG_LIGHT_HIGH_C2 LOBE_R(-0.346226811)
#define LOBE_SG_LIGHT_HIGH_C3 LOBE_R(0.538755178)
#define LOBE_SG_LIGHT_HIGH_C4 LOBE_R(0.761831462)
#define LOBE_SG_LIGHT_HIGH_C5 LOBE_R(1.05686283)
#define LOBE_SG_LIGHT_HIGH_C6 LOBE_R(0.225826114)
#define LOBE_SG_LIGHT_HIGH_C7 LOBE_R(1.37051857)
#define LOBE_SG_LIGHT_HIGH_C8 LOBE_R(0.73526448)
#define LOBE_SG_LIGHT_HIGH_C9 LOBE_R(1.5466274)
#define LOBE_SG_LIGHT_HIGH_C10 LOBE_R(0.566563308)
#define LOBE_SG_LIGHT_HIGH_C11 LOBE_R(0.603264809)
#define LOBE_SG_LIGHT_HIGH_C12 LOBE_R(-0.182621554)
#endif
#endif
