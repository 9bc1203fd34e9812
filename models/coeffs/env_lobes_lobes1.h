/* Generated, not edited: build/lobefit fit env_lobes --tier lobes1
 * BRDF     GGX, height-correlated Smith, alpha = roughness^2
 * domain   alpha in [.02, 1], n_dot_v in [.03, 1]
 * grid     10 x 10, denser toward low alpha and grazing views; nine environments, 80 orientations of each
 * metric   radiance relative to each orientation's; to its rms over all orientations (.5; for few taps 2); shape (.05)
 * error    rms of the three from alpha .04 on: 0.3595, 0.2894, 0.4942;
 *          what ships is measured on a finer one: env_lobes_bounds.h
 * seed     1
 * kernel   lobe_env_lobes_lobes1 in models/env_lobes1.h, digest d852c0f2ab48f308 */
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
#define LOBE_ENV_LOBES_LOBES1_C0 LOBE_R(0.472743303)
#define LOBE_ENV_LOBES_LOBES1_C1 LOBE_R(-0.186262384)
#define LOBE_ENV_LOBES_LOBES1_C2 LOBE_R(-0.770719707)
#define LOBE_ENV_LOBES_LOBES1_C3 LOBE_R(-1.77174449)
#define LOBE_ENV_LOBES_LOBES1_C4 LOBE_R(-3.69350934)
#define LOBE_ENV_LOBES_LOBES1_C5 LOBE_R(1.98503649)
#define LOBE_ENV_LOBES_LOBES1_C6 LOBE_R(-2.61299968)
#define LOBE_ENV_LOBES_LOBES1_C7 LOBE_R(0.347858161)
#define LOBE_ENV_LOBES_LOBES1_C8 LOBE_R(1.19761133)
#define LOBE_ENV_LOBES_LOBES1_C9 LOBE_R(3.7571764)
#define LOBE_ENV_LOBES_LOBES1_C10 LOBE_R(2.46976399)
#define LOBE_ENV_LOBES_LOBES1_C11 LOBE_R(-2.67620802)
#define LOBE_ENV_LOBES_LOBES1_C12 LOBE_R(-0.524673045)
#define LOBE_ENV_LOBES_LOBES1_C13 LOBE_R(-2.71400785)
#define LOBE_ENV_LOBES_LOBES1_C14 LOBE_R(1.13839746)
#define LOBE_ENV_LOBES_LOBES1_C15 LOBE_R(21.8820171)
#define LOBE_ENV_LOBES_LOBES1_C16 LOBE_R(18.9248276)
#define LOBE_ENV_LOBES_LOBES1_C17 LOBE_R(-38.6122704)
#define LOBE_ENV_LOBES_LOBES1_C18 LOBE_R(-17.6783237)
#define LOBE_ENV_LOBES_LOBES1_C19 LOBE_R(31.3538284)
#define LOBE_ENV_LOBES_LOBES1_C20 LOBE_R(-78.7630692)
#define LOBE_ENV_LOBES_LOBES1_C21 LOBE_R(65.2702026)
#define LOBE_ENV_LOBES_LOBES1_C22 LOBE_R(55.527195)
#define LOBE_ENV_LOBES_LOBES1_C23 LOBE_R(-48.6458778)
#endif
#endif
