/* Generated, not edited: build/lobefit fit split_sum_sep --tier low
 * BRDF     GGX, separable Smith, alpha = roughness^2
 * domain   roughness, n_dot_v in [0.02, 1]
 * grid     40 x 40, denser toward the edges, low roughness and grazing views
 * metric   absolute error of scale, bias and E
 * error    max 0.02558 at 0.335210489 0.02, rms 0.011, on that grid, in double;
 *          what ships is measured on a finer one: split_sum_sep_bounds.h
 * seed     1
 * kernel   lobe_split_sum_sep_low in models/split_sum_sep.h, digest 3664cc45cc6b1898 */
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
#define LOBE_SPLIT_SUM_SEP_LOW_C0 LOBE_R(0.781764865)
#define LOBE_SPLIT_SUM_SEP_LOW_C1 LOBE_R(-0.573627234)
#define LOBE_SPLIT_SUM_SEP_LOW_C2 LOBE_R(0.81743443)
#define LOBE_SPLIT_SUM_SEP_LOW_C3 LOBE_R(-0.234540552)
#define LOBE_SPLIT_SUM_SEP_LOW_C4 LOBE_R(-2.07037425)
#define LOBE_SPLIT_SUM_SEP_LOW_C5 LOBE_R(3.7226975)
#define LOBE_SPLIT_SUM_SEP_LOW_C6 LOBE_R(0.210772067)
#define LOBE_SPLIT_SUM_SEP_LOW_C7 LOBE_R(3.63875198)
#define LOBE_SPLIT_SUM_SEP_LOW_C8 LOBE_R(-2.27150154)
#define LOBE_SPLIT_SUM_SEP_LOW_C9 LOBE_R(2.76362658)
#define LOBE_SPLIT_SUM_SEP_LOW_C10 LOBE_R(0.158089593)
#define LOBE_SPLIT_SUM_SEP_LOW_C11 LOBE_R(-0.364302903)
#define LOBE_SPLIT_SUM_SEP_LOW_C12 LOBE_R(0.572711349)
#define LOBE_SPLIT_SUM_SEP_LOW_C13 LOBE_R(-0.0411403514)
#define LOBE_SPLIT_SUM_SEP_LOW_C14 LOBE_R(6.23281431)
#define LOBE_SPLIT_SUM_SEP_LOW_C15 LOBE_R(1.60434055)
#define LOBE_SPLIT_SUM_SEP_LOW_C16 LOBE_R(1.05419016)
#endif
#endif
