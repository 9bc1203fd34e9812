/* Generated, not edited: build/lobefit fit diffuse_sh --tier medium
 * BRDF     Burley 2012, F90 = .5 + 2 roughness (l.h)^2, base colour 1
 * domain   roughness, n_dot_v in [0, 1]
 * grid     65 x 65, uniform, edges included; band 0 counts twice
 * metric   relative rms of the radiance at a point over random order-3 lighting
 * error    max 0.0107 at 1 0, rms 0.002011, on that grid, in double;
 *          what ships is measured on a finer one: diffuse_sh_bounds.h
 * seed     0, nothing in this fit is random
 * kernel   lobe_diffuse_shape_medium in models/diffuse_sh.h, digest 0eef9dd68cec9509 */
#ifndef LOBE_COEFFS_DIFFUSE_SH_MEDIUM_H
#define LOBE_COEFFS_DIFFUSE_SH_MEDIUM_H
#if defined(LOBE_FIT)
#define LOBE_DIFFUSE_SH_MEDIUM_C0 p[0]
#define LOBE_DIFFUSE_SH_MEDIUM_C1 p[1]
#define LOBE_DIFFUSE_SH_MEDIUM_C2 p[2]
#define LOBE_DIFFUSE_SH_MEDIUM_C3 p[3]
#define LOBE_DIFFUSE_SH_MEDIUM_C4 p[4]
#define LOBE_DIFFUSE_SH_MEDIUM_C5 p[5]
#define LOBE_DIFFUSE_SH_MEDIUM_C6 p[6]
#define LOBE_DIFFUSE_SH_MEDIUM_C7 p[7]
#define LOBE_DIFFUSE_SH_MEDIUM_C8 p[8]
#define LOBE_DIFFUSE_SH_MEDIUM_C9 p[9]
#define LOBE_DIFFUSE_SH_MEDIUM_C10 p[10]
#define LOBE_DIFFUSE_SH_MEDIUM_C11 p[11]
#define LOBE_DIFFUSE_SH_MEDIUM_C12 p[12]
#define LOBE_DIFFUSE_SH_MEDIUM_C13 p[13]
#define LOBE_DIFFUSE_SH_MEDIUM_C14 p[14]
#define LOBE_DIFFUSE_SH_MEDIUM_C15 p[15]
#define LOBE_DIFFUSE_SH_MEDIUM_C16 p[16]
#define LOBE_DIFFUSE_SH_MEDIUM_C17 p[17]
#else
#define LOBE_DIFFUSE_SH_MEDIUM_C0 LOBE_R(0.275334746)
#define LOBE_DIFFUSE_SH_MEDIUM_C1 LOBE_R(0.0158221237)
#define LOBE_DIFFUSE_SH_MEDIUM_C2 LOBE_R(-0.137608126)
#define LOBE_DIFFUSE_SH_MEDIUM_C3 LOBE_R(0.266144007)
#define LOBE_DIFFUSE_SH_MEDIUM_C4 LOBE_R(0.180396631)
#define LOBE_DIFFUSE_SH_MEDIUM_C5 LOBE_R(0.0193218552)
#define LOBE_DIFFUSE_SH_MEDIUM_C6 LOBE_R(1.17229462)
#define LOBE_DIFFUSE_SH_MEDIUM_C7 LOBE_R(-0.0376469381)
#define LOBE_DIFFUSE_SH_MEDIUM_C8 LOBE_R(0.163381755)
#define LOBE_DIFFUSE_SH_MEDIUM_C9 LOBE_R(-0.0130381621)
#define LOBE_DIFFUSE_SH_MEDIUM_C10 LOBE_R(-0.0798900872)
#define LOBE_DIFFUSE_SH_MEDIUM_C11 LOBE_R(0.155789047)
#define LOBE_DIFFUSE_SH_MEDIUM_C12 LOBE_R(0.180931345)
#define LOBE_DIFFUSE_SH_MEDIUM_C13 LOBE_R(0.0107427472)
#define LOBE_DIFFUSE_SH_MEDIUM_C14 LOBE_R(0.111316644)
#define LOBE_DIFFUSE_SH_MEDIUM_C15 LOBE_R(0.021783188)
#define LOBE_DIFFUSE_SH_MEDIUM_C16 LOBE_R(0.00574346259)
#define LOBE_DIFFUSE_SH_MEDIUM_C17 LOBE_R(0.14786166)
#endif
#endif
