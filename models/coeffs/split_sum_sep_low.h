/* Generated, not edited: build/lobefit fit split_sum_sep --tier low
 * BRDF     GGX, separable Smith, alpha = roughness^2
 * domain   roughness, n_dot_v in [0.02, 1]
 * grid     60 x 60, denser toward the edges, low roughness and grazing views
 * metric   absolute error of scale, bias and E
 * error    max 0.02019 at 0.855305337 1, rms 0.01006, on that grid, in double;
 *          what ships is measured on a finer one: split_sum_sep_bounds.h
 * seed     1
 * kernel   lobe_split_sum_sep_low in models/split_sum_sep.h, digest cd99a62aa3dda553 */
#ifndef LOBE_COEFFS_SPLIT_SUM_SEP_LOW_H
#define LOBE_COEFFS_SPLIT_SUM_SEP_LOW_H
#if defined(LOBE_FIT)
#define LOBE_SPLIT_SUM_SEP_LOW_C0 p[0]
#define LOBE_SPLIT_SUM_SEP_LOW_C1 p[1]
#define LOBE_SPLIT_SUM_SEP_LOW_C2 p[2]
#define LOBE_SPLIT_SUM_SEP_LOW_C3 p[3]
#define LOBE_SPLIT_SUM_SEP_LOW_C4 p[4]
#define LOBE_SPLIT_SUM_SEP_LOW_C5 p[5]
#define LOBE_SPLIT_SUM_SEP_LOW_C6 p[6]
#define LOBE_SPLIT_SUM_SEP_LOW_C7 p[7]
#define LOBE_SPLIT_SUM_SEP_LOW_C8 p[8]
#define LOBE_SPLIT_SUM_SEP_LOW_C9 p[9]
#define LOBE_SPLIT_SUM_SEP_LOW_C10 p[10]
#define LOBE_SPLIT_SUM_SEP_LOW_C11 p[11]
#define LOBE_SPLIT_SUM_SEP_LOW_C12 p[12]
#define LOBE_SPLIT_SUM_SEP_LOW_C13 p[13]
#define LOBE_SPLIT_SUM_SEP_LOW_C14 p[14]
#define LOBE_SPLIT_SUM_SEP_LOW_C15 p[15]
#define LOBE_SPLIT_SUM_SEP_LOW_C16 p[16]
#else
#define LOBE_SPLIT_SUM_SEP_LOW_C0 LOBE_R(-1.13147557)
#define LOBE_SPLIT_SUM_SEP_LOW_C1 LOBE_R(0.981268823)
#define LOBE_SPLIT_SUM_SEP_LOW_C2 LOBE_R(-0.686492801)
#define LOBE_SPLIT_SUM_SEP_LOW_C3 LOBE_R(1.01897323)
#define LOBE_SPLIT_SUM_SEP_LOW_C4 LOBE_R(-0.432240278)
#define LOBE_SPLIT_SUM_SEP_LOW_C5 LOBE_R(0.400775313)
#define LOBE_SPLIT_SUM_SEP_LOW_C6 LOBE_R(-2.10592675)
#define LOBE_SPLIT_SUM_SEP_LOW_C7 LOBE_R(-0.363388419)
#define LOBE_SPLIT_SUM_SEP_LOW_C8 LOBE_R(-9.12277031)
#define LOBE_SPLIT_SUM_SEP_LOW_C9 LOBE_R(2.80115747)
#define LOBE_SPLIT_SUM_SEP_LOW_C10 LOBE_R(-1.17354822)
#define LOBE_SPLIT_SUM_SEP_LOW_C11 LOBE_R(-0.0807994902)
#define LOBE_SPLIT_SUM_SEP_LOW_C12 LOBE_R(1.07616985)
#define LOBE_SPLIT_SUM_SEP_LOW_C13 LOBE_R(0.839578986)
#define LOBE_SPLIT_SUM_SEP_LOW_C14 LOBE_R(-0.780181408)
#define LOBE_SPLIT_SUM_SEP_LOW_C15 LOBE_R(0.0580498092)
#define LOBE_SPLIT_SUM_SEP_LOW_C16 LOBE_R(0.984458268)
#endif
#endif
