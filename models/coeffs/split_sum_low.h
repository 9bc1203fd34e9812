/* Generated, not edited: build/lobefit fit split_sum --tier low
 * BRDF     GGX, height-correlated Smith, alpha = roughness^2
 * domain   roughness, n_dot_v in [0.02, 1]
 * grid     60 x 60, denser toward the edges, low roughness and grazing views
 * metric   absolute error of scale, bias and E
 * error    max 0.02411 at 0.228949756 0.228062626, rms 0.009185, on that grid, in double;
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
#define LOBE_SPLIT_SUM_LOW_C0 LOBE_R(0.994642258)
#define LOBE_SPLIT_SUM_LOW_C1 LOBE_R(-0.57110709)
#define LOBE_SPLIT_SUM_LOW_C2 LOBE_R(1.02116108)
#define LOBE_SPLIT_SUM_LOW_C3 LOBE_R(-0.541570723)
#define LOBE_SPLIT_SUM_LOW_C4 LOBE_R(10.4717541)
#define LOBE_SPLIT_SUM_LOW_C5 LOBE_R(-0.877512574)
#define LOBE_SPLIT_SUM_LOW_C6 LOBE_R(0.315228224)
#define LOBE_SPLIT_SUM_LOW_C7 LOBE_R(1.72710645)
#define LOBE_SPLIT_SUM_LOW_C8 LOBE_R(0.869417906)
#define LOBE_SPLIT_SUM_LOW_C9 LOBE_R(-1.3556807)
#define LOBE_SPLIT_SUM_LOW_C10 LOBE_R(0.789429486)
#define LOBE_SPLIT_SUM_LOW_C11 LOBE_R(0.898928225)
#define LOBE_SPLIT_SUM_LOW_C12 LOBE_R(-0.217432022)
#endif
#endif
