/* Generated, not edited: build/lobefit fit energy --tier low
 * BRDF     GGX, height-correlated Smith, alpha = roughness^2
 * domain   roughness, n_dot_v in [.001, 1]
 * grid     97 x 97, denser toward the edges, low roughness and grazing views
 * metric   furnace, |E f - 1| with f the polynomial for 1/E
 * error    max 0.00872 at 0.852729699 0.0180445581, rms 0.004265, on that grid, in double;
 *          what ships is measured on a finer one: energy_bounds.h
 * seed     0, nothing in this fit is random
 * kernel   lobe_energy_inverse_low in models/energy.h, digest d63a9624e940b764 */
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
#define LOBE_ENERGY_LOW_C0 LOBE_R(1.1267612)
#define LOBE_ENERGY_LOW_C1 LOBE_R(0.119200319)
#define LOBE_ENERGY_LOW_C2 LOBE_R(1.55402124)
#define LOBE_ENERGY_LOW_C3 LOBE_R(-1.75561142)
#define LOBE_ENERGY_LOW_C4 LOBE_R(0.0593701415)
#define LOBE_ENERGY_LOW_C5 LOBE_R(4.3681016)
#define LOBE_ENERGY_LOW_C6 LOBE_R(-1.86898804)
#define LOBE_ENERGY_LOW_C7 LOBE_R(2.14153481)
#define LOBE_ENERGY_LOW_C8 LOBE_R(-10.1263742)
#define LOBE_ENERGY_LOW_C9 LOBE_R(38.6894989)
#endif
#endif
