/* Generated, not edited: build/lobefit fit env_lobes --tier lobes1
 * BRDF     GGX, height-correlated Smith, alpha = roughness^2, F = 1
 * domain   alpha in [.02, 1], n_dot_v in [.03, 1]
 * grid     10 x 10, denser toward low alpha and grazing views; nine environments, 80 orientations of each
 * metric   radiance relative to each orientation's; to its rms over all orientations (.5); shape (.05)
 * error    rms of the three from alpha .04 on: 0.2796, 0.3600, 0.5718;
 *          what ships is measured on a finer one: env_lobes_bounds.h
 * seed     1
 * kernel   lobe_env_lobes_lobes1 in models/env_lobes1.h, digest 07ff2be1e1ee2126 */
#ifndef LOBE_COEFFS_ENV_LOBES_LOBES1_H
#define LOBE_COEFFS_ENV_LOBES_LOBES1_H
#if defined(LOBE_FIT)
#define LOBE_ENV_LOBES_LOBES1_C0 p[0]
#define LOBE_ENV_LOBES_LOBES1_C1 p[1]
#define LOBE_ENV_LOBES_LOBES1_C2 p[2]
#define LOBE_ENV_LOBES_LOBES1_C3 p[3]
#define LOBE_ENV_LOBES_LOBES1_C4 p[4]
#define LOBE_ENV_LOBES_LOBES1_C5 p[5]
#define LOBE_ENV_LOBES_LOBES1_C6 p[6]
#define LOBE_ENV_LOBES_LOBES1_C7 p[7]
#define LOBE_ENV_LOBES_LOBES1_C8 p[8]
#define LOBE_ENV_LOBES_LOBES1_C9 p[9]
#define LOBE_ENV_LOBES_LOBES1_C10 p[10]
#define LOBE_ENV_LOBES_LOBES1_C11 p[11]
#define LOBE_ENV_LOBES_LOBES1_C12 p[12]
#define LOBE_ENV_LOBES_LOBES1_C13 p[13]
#define LOBE_ENV_LOBES_LOBES1_C14 p[14]
#define LOBE_ENV_LOBES_LOBES1_C15 p[15]
#define LOBE_ENV_LOBES_LOBES1_C16 p[16]
#define LOBE_ENV_LOBES_LOBES1_C17 p[17]
#define LOBE_ENV_LOBES_LOBES1_C18 p[18]
#define LOBE_ENV_LOBES_LOBES1_C19 p[19]
#define LOBE_ENV_LOBES_LOBES1_C20 p[20]
#define LOBE_ENV_LOBES_LOBES1_C21 p[21]
#define LOBE_ENV_LOBES_LOBES1_C22 p[22]
#define LOBE_ENV_LOBES_LOBES1_C23 p[23]
#else
#define LOBE_ENV_LOBES_LOBES1_C0 LOBE_R(0.634777069)
#define LOBE_ENV_LOBES_LOBES1_C1 LOBE_R(-1.65860212)
#define LOBE_ENV_LOBES_LOBES1_C2 LOBE_R(2.09034705)
#define LOBE_ENV_LOBES_LOBES1_C3 LOBE_R(-1.29136455)
#define LOBE_ENV_LOBES_LOBES1_C4 LOBE_R(2.63298011)
#define LOBE_ENV_LOBES_LOBES1_C5 LOBE_R(-7.72428942)
#define LOBE_ENV_LOBES_LOBES1_C6 LOBE_R(-3.78150892)
#define LOBE_ENV_LOBES_LOBES1_C7 LOBE_R(11.4659138)
#define LOBE_ENV_LOBES_LOBES1_C8 LOBE_R(-10.1856995)
#define LOBE_ENV_LOBES_LOBES1_C9 LOBE_R(8.30633163)
#define LOBE_ENV_LOBES_LOBES1_C10 LOBE_R(7.51934052)
#define LOBE_ENV_LOBES_LOBES1_C11 LOBE_R(-9.49023819)
#define LOBE_ENV_LOBES_LOBES1_C12 LOBE_R(-0.472665787)
#define LOBE_ENV_LOBES_LOBES1_C13 LOBE_R(-2.0242393)
#define LOBE_ENV_LOBES_LOBES1_C14 LOBE_R(-2.92444038)
#define LOBE_ENV_LOBES_LOBES1_C15 LOBE_R(24.5176144)
#define LOBE_ENV_LOBES_LOBES1_C16 LOBE_R(10.4064322)
#define LOBE_ENV_LOBES_LOBES1_C17 LOBE_R(-29.5462666)
#define LOBE_ENV_LOBES_LOBES1_C18 LOBE_R(-20.740591)
#define LOBE_ENV_LOBES_LOBES1_C19 LOBE_R(23.4515362)
#define LOBE_ENV_LOBES_LOBES1_C20 LOBE_R(-75.4285965)
#define LOBE_ENV_LOBES_LOBES1_C21 LOBE_R(75.4555206)
#define LOBE_ENV_LOBES_LOBES1_C22 LOBE_R(60.6632195)
#define LOBE_ENV_LOBES_LOBES1_C23 LOBE_R(-55.3144035)
#endif
#endif
