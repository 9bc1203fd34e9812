/* Generated, not edited: build/lobefit fit sg_light --tier high
 * BRDF     GGX, height-correlated Smith, alpha = roughness^2, F = 1
 * domain   alpha .05 to 1, sharpness 4 to 4096, n_dot_v .05 to 1, axes above and below the horizon
 * grid     216 cells of 120 positions of the axis, uniform and mixed: cases/sg_light/cells.h
 * metric   relative L2 error of a cell over its positions, rms over the cells; cases/sg_light/fit_tiers.h
 * error    uniform / mixed positions: all cells 0.06211 / 0.05149, smooth 0.0371 / 0.03079,
 *          worst cell 0.199 / 0.176, energy +0.189 / +0.156, on those cells, in double;
 *          what ships is measured on a finer one: sg_light_bounds.h
 * seed     1
 * kernel   lobe_sg_light_high in models/sg_light_high.h, digest 099a6297cea4b3ac */
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
#define LOBE_SG_LIGHT_HIGH_C13 p[13]
#define LOBE_SG_LIGHT_HIGH_C14 p[14]
#define LOBE_SG_LIGHT_HIGH_C15 p[15]
#else
#define LOBE_SG_LIGHT_HIGH_C0 LOBE_R(0.198566794)
#define LOBE_SG_LIGHT_HIGH_C1 LOBE_R(0.699467659)
#define LOBE_SG_LIGHT_HIGH_C2 LOBE_R(-0.3007963)
#define LOBE_SG_LIGHT_HIGH_C3 LOBE_R(0.690570772)
#define LOBE_SG_LIGHT_HIGH_C4 LOBE_R(1.51982093)
#define LOBE_SG_LIGHT_HIGH_C5 LOBE_R(0.257731169)
#define LOBE_SG_LIGHT_HIGH_C6 LOBE_R(0.349775583)
#define LOBE_SG_LIGHT_HIGH_C7 LOBE_R(1.20170772)
#define LOBE_SG_LIGHT_HIGH_C8 LOBE_R(0.624327421)
#define LOBE_SG_LIGHT_HIGH_C9 LOBE_R(0.937566459)
#define LOBE_SG_LIGHT_HIGH_C10 LOBE_R(2.52954268)
#define LOBE_SG_LIGHT_HIGH_C11 LOBE_R(3.11169815)
#define LOBE_SG_LIGHT_HIGH_C12 LOBE_R(5.69536257)
#define LOBE_SG_LIGHT_HIGH_C13 LOBE_R(0.672254264)
#define LOBE_SG_LIGHT_HIGH_C14 LOBE_R(0.92495662)
#define LOBE_SG_LIGHT_HIGH_C15 LOBE_R(-0.421420336)
#endif
#endif
