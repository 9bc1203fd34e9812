/* Generated, not edited: build/lobefit fit sphere_diffuse --tier medium
 * BRDF     Lambert, base colour 1
 * domain   n_dot_l in [-sine, sine], sine in (0, 1]
 * grid     64 half angles up to 90 degrees by 81 heights; witness n_dot_l, sine
 * metric   largest error as a part of sine^2
 * error    max 0.0005485 at 0 0.170961889, rms 0.0002794, on that grid, in double;
 *          what ships is measured on a finer one: sphere_diffuse_bounds.h
 * seed     0, nothing in this fit is random
 * kernel   lobe_sphere_diffuse_medium in models/sphere_diffuse.h, digest 7675f7de2e7ab73a */
#ifndef LOBE_COEFFS_SPHERE_DIFFUSE_MEDIUM_H
#define LOBE_COEFFS_SPHERE_DIFFUSE_MEDIUM_H
#if defined(LOBE_FIT)
#define LOBE_SPHERE_DIFFUSE_MEDIUM_C0 p[0]
#define LOBE_SPHERE_DIFFUSE_MEDIUM_C1 p[1]
#define LOBE_SPHERE_DIFFUSE_MEDIUM_C2 p[2]
#define LOBE_SPHERE_DIFFUSE_MEDIUM_C3 p[3]
#define LOBE_SPHERE_DIFFUSE_MEDIUM_C4 p[4]
#else
#define LOBE_SPHERE_DIFFUSE_MEDIUM_C0 LOBE_R(0.452953398)
#define LOBE_SPHERE_DIFFUSE_MEDIUM_C1 LOBE_R(0.0441019237)
#define LOBE_SPHERE_DIFFUSE_MEDIUM_C2 LOBE_R(0.769897044)
#define LOBE_SPHERE_DIFFUSE_MEDIUM_C3 LOBE_R(-0.159861267)
#define LOBE_SPHERE_DIFFUSE_MEDIUM_C4 LOBE_R(0.155519471)
#endif
#endif
