/* Generated, not edited: build/lobefit fit sg_diffuse --tier high
 * BRDF     Lambert, base colour 1
 * domain   sharpness .5 to 4096, n_dot_l -1 to 1
 * grid     27 sharpnesses, 41 heights
 * metric   error over what the light gives overhead, least squares
 * error    max 5.002e-03 of what the light gives overhead, at sharpness 2.828, height 1.00; rms 1.07e-03,
 *          in double on that grid;
 *          what ships is measured on a finer one: sg_diffuse_bounds.h
 * seed     0, nothing in this fit is random
 * kernel   lobe_sg_diffuse_high in models/sg_diffuse.h, digest cbc1a4b686e0b6c1 */
#ifndef LOBE_COEFFS_SG_DIFFUSE_HIGH_H
#define LOBE_COEFFS_SG_DIFFUSE_HIGH_H
#if defined(LOBE_FIT)
#define LOBE_SG_DIFFUSE_HIGH_C0 p[0]
#define LOBE_SG_DIFFUSE_HIGH_C1 p[1]
#define LOBE_SG_DIFFUSE_HIGH_C2 p[2]
#define LOBE_SG_DIFFUSE_HIGH_C3 p[3]
#else
#define LOBE_SG_DIFFUSE_HIGH_C0 LOBE_R(0.434370697)
#define LOBE_SG_DIFFUSE_HIGH_C1 LOBE_R(1.52264977)
#define LOBE_SG_DIFFUSE_HIGH_C2 LOBE_R(1.22692549)
#define LOBE_SG_DIFFUSE_HIGH_C3 LOBE_R(3.23316336)
#endif
#endif
