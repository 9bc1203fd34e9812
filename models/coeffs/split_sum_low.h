/* Generated, not edited: build/lobefit fit split_sum --tier low
 * BRDF     GGX, height-correlated Smith, alpha = roughness^2
 * domain   roughness, n_dot_v in [0.02, 1]
 * grid     40 x 40, denser toward the edges, low roughness and grazing views
 * metric   absolute error of scale, bias and E
 * error    max 0.02323 at 1 0.0957167791, rms 0.008943, on that grid, in double;
 *          what ships is measured on a finer one: split_sum_bounds.h
 * seed     1
 * kernel   lobe_split_sum_low in models/split_sum.h, digest 11729120584f443a */
#ifndef LOBE_COEFFS_SPLIT_SUM_LOW_H
#define LOBE_COEFFS_SPLIT_SUM_LOW_H
#if defined(LOBE_FIT)
#define LOBE_SPLIT_SUM_LOW_C0 p[0]
#define LOBE_SPLIT_SUM_LOW_C1 p[1]
#define LOBE_SPLIT_SUM_LOW_C2 p[2]
#define LOBE_SPLIT_SUM_LOW_C3 p[3]
#define LOBE_SPLIT_SUM_LOW_C4 p[4]
#define LOBE_SPLIT_SUM_LOW_C5 p[5]
#define LOBE_SPLIT_SUM_LOW_C6 p[6]
#define LOBE_SPLIT_SUM_LOW_C7 p[7]
#define LOBE_SPLIT_SUM_LOW_C8 p[8]
#define LOBE_SPLIT_SUM_LOW_C9 p[9]
#define LOBE_SPLIT_SUM_LOW_C10 p[10]
#define LOBE_SPLIT_SUM_LOW_C11 p[11]
#define LOBE_SPLIT_SUM_LOW_C12 p[12]
#else
#define LOBE_SPLIT_SUM_LOW_C0 LOBE_R(0.996284127)
#define LOBE_SPLIT_SUM_LOW_C1 LOBE_R(-0.570804119)
#define LOBE_SPLIT_SUM_LOW_C2 LOBE_R(1.02098799)
#define LOBE_SPLIT_SUM_LOW_C3 LOBE_R(-0.539590299)
#define LOBE_SPLIT_SUM_LOW_C4 LOBE_R(10.2874794)
#define LOBE_SPLIT_SUM_LOW_C5 LOBE_R(-0.875699162)
#define LOBE_SPLIT_SUM_LOW_C6 LOBE_R(0.311268657)
#define LOBE_SPLIT_SUM_LOW_C7 LOBE_R(1.74304032)
#define LOBE_SPLIT_SUM_LOW_C8 LOBE_R(0.875730336)
#define LOBE_SPLIT_SUM_LOW_C9 LOBE_R(-1.35779893)
#define LOBE_SPLIT_SUM_LOW_C10 LOBE_R(0.78145802)
#define LOBE_SPLIT_SUM_LOW_C11 LOBE_R(0.901199043)
#define LOBE_SPLIT_SUM_LOW_C12 LOBE_R(-0.219975561)
#endif
#endif
