/* From the exploration that cases/sphere_light/README.md tells of: the start of lobefit fit sphere_light --tier high. */
#ifndef LOBE_COEFFS_SPHERE_LIGHT_HIGH_H
#define LOBE_COEFFS_SPHERE_LIGHT_HIGH_H
#if defined(LOBE_FIT)
#define LOBE_SPHERE_LIGHT_HIGH_C0 p[0]
#define LOBE_SPHERE_LIGHT_HIGH_C1 p[1]
#define LOBE_SPHERE_LIGHT_HIGH_C2 p[2]
#define LOBE_SPHERE_LIGHT_HIGH_C3 p[3]
#define LOBE_SPHERE_LIGHT_HIGH_C4 p[4]
#else
#define LOBE_SPHERE_LIGHT_HIGH_C0 LOBE_R(0.508859148)
#define LOBE_SPHERE_LIGHT_HIGH_C1 LOBE_R(0.523379007)
#define LOBE_SPHERE_LIGHT_HIGH_C2 LOBE_R(-0.538869241)
#define LOBE_SPHERE_LIGHT_HIGH_C3 LOBE_R(-0.332403675)
#define LOBE_SPHERE_LIGHT_HIGH_C4 LOBE_R(-0.458395216)
#endif
#endif
