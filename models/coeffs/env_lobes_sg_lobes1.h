/* Generated, not edited: build/lobefit fit env_lobes_sg --tier lobes1
 * BRDF     GGX, height-correlated Smith, alpha = roughness^2, F = 1
 * domain   alpha .04 to 1, n_dot_v .05 to 1
 * grid     9 x 9, 6 environments in all orientations: cases/env_lobes_sg/scenes.c, lights.c
 * metric   relative mean square error of radiance, and .02 of that of the shape; cases/env_lobes_sg/radiance.h
 * error    on that grid and those environments: radiance 0.1874, shape 0.4460, root mean squares, relative,
 *          in double;
 *          what ships is measured on a finer one: env_lobes_sg_bounds.h
 * seed     11
 * kernel   lobe_env_lobes_sg_lobes1 in models/env_lobes_sg.h, digest 07a364ea7d66fc75 */
#ifndef LOBE_COEFFS_ENV_LOBES_SG_LOBES1_H
#define LOBE_COEFFS_ENV_LOBES_SG_LOBES1_H
#if defined(LOBE_FIT)
#define LOBE_ENV_LOBES_SG_LOBES1_C0 p[0]
#define LOBE_ENV_LOBES_SG_LOBES1_C1 p[1]
#define LOBE_ENV_LOBES_SG_LOBES1_C2 p[2]
#define LOBE_ENV_LOBES_SG_LOBES1_C3 p[3]
#define LOBE_ENV_LOBES_SG_LOBES1_C4 p[4]
#define LOBE_ENV_LOBES_SG_LOBES1_C5 p[5]
#define LOBE_ENV_LOBES_SG_LOBES1_C6 p[6]
#define LOBE_ENV_LOBES_SG_LOBES1_C7 p[7]
#define LOBE_ENV_LOBES_SG_LOBES1_C8 p[8]
#define LOBE_ENV_LOBES_SG_LOBES1_C9 p[9]
#define LOBE_ENV_LOBES_SG_LOBES1_C10 p[10]
#define LOBE_ENV_LOBES_SG_LOBES1_C11 p[11]
#define LOBE_ENV_LOBES_SG_LOBES1_C12 p[12]
#define LOBE_ENV_LOBES_SG_LOBES1_C13 p[13]
#define LOBE_ENV_LOBES_SG_LOBES1_C14 p[14]
#define LOBE_ENV_LOBES_SG_LOBES1_C15 p[15]
#define LOBE_ENV_LOBES_SG_LOBES1_C16 p[16]
#define LOBE_ENV_LOBES_SG_LOBES1_C17 p[17]
#define LOBE_ENV_LOBES_SG_LOBES1_C18 p[18]
#define LOBE_ENV_LOBES_SG_LOBES1_C19 p[19]
#define LOBE_ENV_LOBES_SG_LOBES1_C20 p[20]
#define LOBE_ENV_LOBES_SG_LOBES1_C21 p[21]
#define LOBE_ENV_LOBES_SG_LOBES1_C22 p[22]
#define LOBE_ENV_LOBES_SG_LOBES1_C23 p[23]
#else
#define LOBE_ENV_LOBES_SG_LOBES1_C0 LOBE_R(0.176547974)
#define LOBE_ENV_LOBES_SG_LOBES1_C1 LOBE_R(-0.525717139)
#define LOBE_ENV_LOBES_SG_LOBES1_C2 LOBE_R(0.825462759)
#define LOBE_ENV_LOBES_SG_LOBES1_C3 LOBE_R(1.01939833)
#define LOBE_ENV_LOBES_SG_LOBES1_C4 LOBE_R(2.21437669)
#define LOBE_ENV_LOBES_SG_LOBES1_C5 LOBE_R(-5.79216814)
#define LOBE_ENV_LOBES_SG_LOBES1_C6 LOBE_R(-1.66126037)
#define LOBE_ENV_LOBES_SG_LOBES1_C7 LOBE_R(4.204175)
#define LOBE_ENV_LOBES_SG_LOBES1_C8 LOBE_R(-9.16873455)
#define LOBE_ENV_LOBES_SG_LOBES1_C9 LOBE_R(6.60760641)
#define LOBE_ENV_LOBES_SG_LOBES1_C10 LOBE_R(4.13399935)
#define LOBE_ENV_LOBES_SG_LOBES1_C11 LOBE_R(-3.51879764)
#define LOBE_ENV_LOBES_SG_LOBES1_C12 LOBE_R(-1.72490573)
#define LOBE_ENV_LOBES_SG_LOBES1_C13 LOBE_R(1.96915495)
#define LOBE_ENV_LOBES_SG_LOBES1_C14 LOBE_R(-0.346765012)
#define LOBE_ENV_LOBES_SG_LOBES1_C15 LOBE_R(1.79827785)
#define LOBE_ENV_LOBES_SG_LOBES1_C16 LOBE_R(-3.28099036)
#define LOBE_ENV_LOBES_SG_LOBES1_C17 LOBE_R(0.385071874)
#define LOBE_ENV_LOBES_SG_LOBES1_C18 LOBE_R(1.38747954)
#define LOBE_ENV_LOBES_SG_LOBES1_C19 LOBE_R(-2.74742937)
#define LOBE_ENV_LOBES_SG_LOBES1_C20 LOBE_R(-0.0836548135)
#define LOBE_ENV_LOBES_SG_LOBES1_C21 LOBE_R(2.06696367)
#define LOBE_ENV_LOBES_SG_LOBES1_C22 LOBE_R(1.4208889)
#define LOBE_ENV_LOBES_SG_LOBES1_C23 LOBE_R(-0.281359106)
#endif
#endif
