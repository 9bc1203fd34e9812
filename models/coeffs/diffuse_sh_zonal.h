/* Generated, not edited: build/lobefit fit diffuse_sh --tier zonal
 * BRDF     Burley 2012, F90 = .5 + 2 roughness (l.h)^2, base colour 1
 * domain   roughness, n_dot_v in [0, 1]
 * grid     65 x 65, uniform, edges included; band 0 counts twice
 * metric   relative rms of the radiance at a point over random order-3 lighting
 * error    max 0.04644 at 0.921875 0, rms 0.01066, on that grid, in double;
 *          what ships is measured on a finer one: diffuse_sh_bounds.h
 * seed     0, nothing in this fit is random
 * kernel   lobe_diffuse_zonal_shape in models/diffuse_zonal.h, digest 6a0c0fe5f95159ac */
#ifndef LOBE_COEFFS_DIFFUSE_SH_ZONAL_H
#define LOBE_COEFFS_DIFFUSE_SH_ZONAL_H
#if defined(LOBE_FIT)
#define LOBE_DIFFUSE_SH_ZONAL_C0 p[0]
#define LOBE_DIFFUSE_SH_ZONAL_C1 p[1]
#define LOBE_DIFFUSE_SH_ZONAL_C2 p[2]
#define LOBE_DIFFUSE_SH_ZONAL_C3 p[3]
#define LOBE_DIFFUSE_SH_ZONAL_C4 p[4]
#define LOBE_DIFFUSE_SH_ZONAL_C5 p[5]
#define LOBE_DIFFUSE_SH_ZONAL_C6 p[6]
#define LOBE_DIFFUSE_SH_ZONAL_C7 p[7]
#define LOBE_DIFFUSE_SH_ZONAL_C8 p[8]
#define LOBE_DIFFUSE_SH_ZONAL_C9 p[9]
#define LOBE_DIFFUSE_SH_ZONAL_C10 p[10]
#define LOBE_DIFFUSE_SH_ZONAL_C11 p[11]
#define LOBE_DIFFUSE_SH_ZONAL_C12 p[12]
#define LOBE_DIFFUSE_SH_ZONAL_C13 p[13]
#else
#define LOBE_DIFFUSE_SH_ZONAL_C0 LOBE_R(0.2754291)
#define LOBE_DIFFUSE_SH_ZONAL_C1 LOBE_R(0.0159880091)
#define LOBE_DIFFUSE_SH_ZONAL_C2 LOBE_R(-0.140002236)
#define LOBE_DIFFUSE_SH_ZONAL_C3 LOBE_R(0.284301221)
#define LOBE_DIFFUSE_SH_ZONAL_C4 LOBE_R(0.161065236)
#define LOBE_DIFFUSE_SH_ZONAL_C5 LOBE_R(1.1710006)
#define LOBE_DIFFUSE_SH_ZONAL_C6 LOBE_R(-0.0378890969)
#define LOBE_DIFFUSE_SH_ZONAL_C7 LOBE_R(0.040173199)
#define LOBE_DIFFUSE_SH_ZONAL_C8 LOBE_R(0.591550827)
#define LOBE_DIFFUSE_SH_ZONAL_C9 LOBE_R(-0.07686124)
#define LOBE_DIFFUSE_SH_ZONAL_C10 LOBE_R(0.0966882259)
#define LOBE_DIFFUSE_SH_ZONAL_C11 LOBE_R(0.0260592028)
#define LOBE_DIFFUSE_SH_ZONAL_C12 LOBE_R(0.460560083)
#define LOBE_DIFFUSE_SH_ZONAL_C13 LOBE_R(-0.235438332)
#endif
#endif
