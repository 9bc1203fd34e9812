/* Generated, not edited: build/lobefit fit diffuse_sh --tier low
 * BRDF     Burley 2012, F90 = .5 + 2 roughness (l.h)^2, base colour 1
 * domain   roughness, n_dot_v in [0, 1]
 * grid     65 x 65, uniform, edges included; band 0 counts twice
 * metric   relative rms of the radiance at a point over random order-3 lighting
 * error    max 0.03379 at 1 0, rms 0.01002, on that grid, in double;
 *          what ships is measured on a finer one: diffuse_sh_bounds.h
 * seed     0, nothing in this fit is random
 * kernel   lobe_diffuse_shape_low in models/diffuse_sh.h, digest 66956302bcfa3d4e */
#ifndef LOBE_COEFFS_DIFFUSE_SH_LOW_H
#define LOBE_COEFFS_DIFFUSE_SH_LOW_H
#if defined(LOBE_FIT)
#define LOBE_DIFFUSE_SH_LOW_C0 p[0]
#define LOBE_DIFFUSE_SH_LOW_C1 p[1]
#define LOBE_DIFFUSE_SH_LOW_C2 p[2]
#define LOBE_DIFFUSE_SH_LOW_C3 p[3]
#define LOBE_DIFFUSE_SH_LOW_C4 p[4]
#define LOBE_DIFFUSE_SH_LOW_C5 p[5]
#define LOBE_DIFFUSE_SH_LOW_C6 p[6]
#define LOBE_DIFFUSE_SH_LOW_C7 p[7]
#define LOBE_DIFFUSE_SH_LOW_C8 p[8]
#define LOBE_DIFFUSE_SH_LOW_C9 p[9]
#else
#define LOBE_DIFFUSE_SH_LOW_C0 LOBE_R(0.277305901)
#define LOBE_DIFFUSE_SH_LOW_C1 LOBE_R(0.0142554659)
#define LOBE_DIFFUSE_SH_LOW_C2 LOBE_R(-0.140948623)
#define LOBE_DIFFUSE_SH_LOW_C3 LOBE_R(0.295499176)
#define LOBE_DIFFUSE_SH_LOW_C4 LOBE_R(1.15333915)
#define LOBE_DIFFUSE_SH_LOW_C5 LOBE_R(0.589273751)
#define LOBE_DIFFUSE_SH_LOW_C6 LOBE_R(-0.0653509274)
#define LOBE_DIFFUSE_SH_LOW_C7 LOBE_R(0.00790160988)
#define LOBE_DIFFUSE_SH_LOW_C8 LOBE_R(0.132407457)
#define LOBE_DIFFUSE_SH_LOW_C9 LOBE_R(1.07335198)
#endif
#endif
