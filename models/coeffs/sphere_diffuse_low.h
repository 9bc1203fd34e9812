/* Generated, not edited: build/lobefit fit sphere_diffuse --tier low
 * BRDF     Lambert, base colour 1
 * domain   n_dot_l in [-sine, sine], sine in (0, 1]
 * grid     64 half angles up to 90 degrees by 81 heights; witness n_dot_l, sine
 * metric   largest error as a part of sine^2
 * error    max 0.007805 at 0.881362724 0.98917651, rms 0.00333, on that grid, in double;
 *          what ships is measured on a finer one: sphere_diffuse_bounds.h
 * seed     0, nothing in this fit is random
 * kernel   lobe_sphere_diffuse_low in models/sphere_diffuse.h, digest df5cbec573ab661b */
#ifndef LOBE_COEFFS_SPHERE_DIFFUSE_LOW_H
#define LOBE_COEFFS_SPHERE_DIFFUSE_LOW_H
#if defined(LOBE_FIT)
#define LOBE_SPHERE_DIFFUSE_LOW_C0 p[0]
#define LOBE_SPHERE_DIFFUSE_LOW_C1 p[1]
#define LOBE_SPHERE_DIFFUSE_LOW_C2 p[2]
#else
#define LOBE_SPHERE_DIFFUSE_LOW_C0 LOBE_R(0.836739242)
#define LOBE_SPHERE_DIFFUSE_LOW_C1 LOBE_R(-0.567846358)
#define LOBE_SPHERE_DIFFUSE_LOW_C2 LOBE_R(-0.206790656)
#endif
#endif
