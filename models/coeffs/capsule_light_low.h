/* Stands in until the first fit: build/lobefit fit capsule_light writes this file. */
#ifndef LOBE_COEFFS_CAPSULE_LIGHT_LOW_H
#define LOBE_COEFFS_CAPSULE_LIGHT_LOW_H
#if defined(LOBE_FIT)
#define LOBE_CAPSULE_LIGHT_LOW_C0 p[0]
#define LOBE_CAPSULE_LIGHT_LOW_C1 p[1]
#define LOBE_CAPSULE_LIGHT_LOW_C2 p[2]
#define LOBE_CAPSULE_LIGHT_LOW_C3 p[3]
#else
#define LOBE_CAPSULE_LIGHT_LOW_C0 LOBE_R(0.46)
#define LOBE_CAPSULE_LIGHT_LOW_C1 LOBE_R(0.64)
#define LOBE_CAPSULE_LIGHT_LOW_C2 LOBE_R(2.2)
#define LOBE_CAPSULE_LIGHT_LOW_C3 LOBE_R(1.6)
#endif
#endif
