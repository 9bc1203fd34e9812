/* Generated, not edited: build/lobefit fit diffuse_sh --tier zonal_low
 * BRDF     Burley 2012, F90 = .5 + 2 roughness (l.h)^2, base colour 1
 * domain   roughness, n_dot_v in [0, 1]
 * grid     65 x 65, uniform, edges included; band 0 counts twice
 * metric   relative rms of the radiance at a point over random order-3 lighting
 * error    max 0.1077 at 1 0, rms 0.02065, on that grid, in double;
 *          what ships is measured on a finer one: diffuse_sh_bounds.h
 * seed     0, nothing in this fit is random
 * kernel   lobe_diffuse_zonal_shape_low in models/diffuse_zonal.h, digest 45c75811f0c8987d */
#ifndef LOBE_COEFFS_DIFFUSE_SH_ZONAL_LOW_H
#define LOBE_COEFFS_DIFFUSE_SH_ZONAL_LOW_H
#if defined(LOBE_FIT)
#define LOBE_DIFFUSE_SH_ZONAL_LOW_C0 p[0]
#define LOBE_DIFFUSE_SH_ZONAL_LOW_C1 p[1]
#define LOBE_DIFFUSE_SH_ZONAL_LOW_C2 p[2]
#define LOBE_DIFFUSE_SH_ZONAL_LOW_C3 p[3]
#define LOBE_DIFFUSE_SH_ZONAL_LOW_C4 p[4]
#define LOBE_DIFFUSE_SH_ZONAL_LOW_C5 p[5]
#define LOBE_DIFFUSE_SH_ZONAL_LOW_C6 p[6]
#define LOBE_DIFFUSE_SH_ZONAL_LOW_C7 p[7]
#else
#define LOBE_DIFFUSE_SH_ZONAL_LOW_C0 LOBE_R(0.278245598)
#define LOBE_DIFFUSE_SH_ZONAL_LOW_C1 LOBE_R(0.0110921748)
#define LOBE_DIFFUSE_SH_ZONAL_LOW_C2 LOBE_R(-0.142194703)
#define LOBE_DIFFUSE_SH_ZONAL_LOW_C3 LOBE_R(0.305833787)
#define LOBE_DIFFUSE_SH_ZONAL_LOW_C4 LOBE_R(1.15598547)
#define LOBE_DIFFUSE_SH_ZONAL_LOW_C5 LOBE_R(0.562568963)
#define LOBE_DIFFUSE_SH_ZONAL_LOW_C6 LOBE_R(0.0269633327)
#define LOBE_DIFFUSE_SH_ZONAL_LOW_C7 LOBE_R(0.274753809)
#endif
#endif
