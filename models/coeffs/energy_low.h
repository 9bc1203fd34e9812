/* Zeros that stand in until the first fit: build/lobefit fit writes this file. */
#ifndef LOBE_COEFFS_ENERGY_LOW_H
#define LOBE_COEFFS_ENERGY_LOW_H
#if defined(LOBE_FIT)
#define LOBE_ENERGY_LOW_C0 p[0]
#define LOBE_ENERGY_LOW_C1 p[1]
#define LOBE_ENERGY_LOW_C2 p[2]
#define LOBE_ENERGY_LOW_C3 p[3]
#define LOBE_ENERGY_LOW_C4 p[4]
#define LOBE_ENERGY_LOW_C5 p[5]
#define LOBE_ENERGY_LOW_C6 p[6]
#define LOBE_ENERGY_LOW_C7 p[7]
#define LOBE_ENERGY_LOW_C8 p[8]
#define LOBE_ENERGY_LOW_C9 p[9]
#else
#define LOBE_ENERGY_LOW_C0 LOBE_R(0.0)
#define LOBE_ENERGY_LOW_C1 LOBE_R(0.0)
#define LOBE_ENERGY_LOW_C2 LOBE_R(0.0)
#define LOBE_ENERGY_LOW_C3 LOBE_R(0.0)
#define LOBE_ENERGY_LOW_C4 LOBE_R(0.0)
#define LOBE_ENERGY_LOW_C5 LOBE_R(0.0)
#define LOBE_ENERGY_LOW_C6 LOBE_R(0.0)
#define LOBE_ENERGY_LOW_C7 LOBE_R(0.0)
#define LOBE_ENERGY_LOW_C8 LOBE_R(0.0)
#define LOBE_ENERGY_LOW_C9 LOBE_R(0.0)
#endif
#endif
