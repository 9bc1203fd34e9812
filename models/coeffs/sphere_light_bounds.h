/* Generated, not edited: build/lobefit bounds sphere_light
 * What ships, measured against the truth (GGX, height-correlated Smith, alpha = roughness^2, F = 1;
 * its own error 5e-7 relative). MAX and RMS are of the absolute error of the radiance of a light
 * of radiance 1. Domain: roughness [0.22, 1], n_dot_v [0.08, 1], n_dot_l [-1, 1], sine (0, 0.7072]:
 * a Latin hypercube of 131072 rows, each second one near the mirror direction, the vectors, and a walk
 * uphill from the 4 largest errors; RMS over the hypercube. BELOW_MAX: of half as many where roughness, down
 * to 0.05, where the truth ends, n_dot_v, down to 0.001, or sine, up to 1, is outside.
 * CELLS: relative L2 error on held-out cells (cases/sphere_light/cells.h), root of the mean square,
 * the worse of two sets of positions; ENERGY of the worst cell. OPS: beyond a punctual light.
 * Witnesses are roughness, n_dot_v, n_dot_l, tangent2, sine. Macros are rounded up. */
#define LOBE_SPHERE_LIGHT_LOW_OPS 20
/* low, f32, in the domain: max 7.419486e-01 at
 *   0.220000029 0.152674317 0.0937802196 0.136047482 0.707199991, rms 2.648622e-02 */
/* low, f32, beyond it: max 9.999159e-01 at
 *   0.0500000119 0.387837887 0.132606804 0.373949528 1, rms 1.339908e-01 */
#define LOBE_SPHERE_LIGHT_LOW_F32_MAX 0.742
#define LOBE_SPHERE_LIGHT_LOW_F32_RMS 0.0265
#define LOBE_SPHERE_LIGHT_LOW_F32_BELOW_MAX 1
/* low, f32, held-out cells, uniform: all 0.1266, view <= 60 0.0858, view >= 75 0.1827,
 *   worst cell 0.6871, energy -0.4200, over a punctual light where sine < alpha / 2 0.0557 */
/* low, f32, held-out cells, mixed: all 0.1312, view <= 60 0.0829, view >= 75 0.1947,
 *   worst cell 0.5280, energy +0.3477, over a punctual light where sine < alpha / 2 0.0220 */
#define LOBE_SPHERE_LIGHT_LOW_F32_CELLS 0.132
#define LOBE_SPHERE_LIGHT_LOW_F32_CELLS_VIEW60 0.0859
#define LOBE_SPHERE_LIGHT_LOW_F32_CELLS_VIEW75 0.195
#define LOBE_SPHERE_LIGHT_LOW_F32_CELLS_ENERGY 0.42
#define LOBE_SPHERE_LIGHT_LOW_F32_CELLS_EXCESS 0.0558
/* low, q30, in the domain: max 7.419488e-01 at
 *   0.220000029 0.152362525 0.0937808156 0.136068106 0.707199931, rms 2.648622e-02 */
/* low, q30, beyond it: max 9.999159e-01 at
 *   0.0500000119 0.387939155 0.132607222 0.373970449 1, rms 1.340112e-01 */
#define LOBE_SPHERE_LIGHT_LOW_Q30_MAX 0.742
#define LOBE_SPHERE_LIGHT_LOW_Q30_RMS 0.0265
#define LOBE_SPHERE_LIGHT_LOW_Q30_BELOW_MAX 1
/* low, q30, held-out cells, uniform: all 0.1266, view <= 60 0.0858, view >= 75 0.1827,
 *   worst cell 0.6871, energy -0.4200, over a punctual light where sine < alpha / 2 0.0557 */
/* low, q30, held-out cells, mixed: all 0.1312, view <= 60 0.0829, view >= 75 0.1947,
 *   worst cell 0.5280, energy +0.3477, over a punctual light where sine < alpha / 2 0.0220 */
#define LOBE_SPHERE_LIGHT_LOW_Q30_CELLS 0.132
#define LOBE_SPHERE_LIGHT_LOW_Q30_CELLS_VIEW60 0.0859
#define LOBE_SPHERE_LIGHT_LOW_Q30_CELLS_VIEW75 0.195
#define LOBE_SPHERE_LIGHT_LOW_Q30_CELLS_ENERGY 0.42
#define LOBE_SPHERE_LIGHT_LOW_Q30_CELLS_EXCESS 0.0558
#define LOBE_SPHERE_LIGHT_MEDIUM_OPS 38
/* medium, f32, in the domain: max 6.638037e-01 at
 *   0.220000029 0.1519925 0.0977346301 0.135591269 0.707199931, rms 2.069948e-02 */
/* medium, f32, beyond it: max 9.998355e-01 at
 *   0.0500000119 0.275252998 0.138199389 0.434044063 1, rms 8.944028e-02 */
#define LOBE_SPHERE_LIGHT_MEDIUM_F32_MAX 0.664
#define LOBE_SPHERE_LIGHT_MEDIUM_F32_RMS 0.0207
#define LOBE_SPHERE_LIGHT_MEDIUM_F32_BELOW_MAX 1
/* medium, f32, held-out cells, uniform: all 0.0983, view <= 60 0.0606, view >= 75 0.1471,
 *   worst cell 0.5985, energy -0.3031, over a punctual light where sine < alpha / 2 0.0516 */
/* medium, f32, held-out cells, mixed: all 0.0789, view <= 60 0.0465, view >= 75 0.1197,
 *   worst cell 0.2169, energy -0.1890, over a punctual light where sine < alpha / 2 0.0000 */
#define LOBE_SPHERE_LIGHT_MEDIUM_F32_CELLS 0.0983
#define LOBE_SPHERE_LIGHT_MEDIUM_F32_CELLS_VIEW60 0.0606
#define LOBE_SPHERE_LIGHT_MEDIUM_F32_CELLS_VIEW75 0.148
#define LOBE_SPHERE_LIGHT_MEDIUM_F32_CELLS_ENERGY 0.304
#define LOBE_SPHERE_LIGHT_MEDIUM_F32_CELLS_EXCESS 0.0516
/* medium, q30, in the domain: max 6.638036e-01 at
 *   0.220000029 0.151753724 0.0977348685 0.135602772 0.707199991, rms 2.069948e-02 */
/* medium, q30, beyond it: max 9.998355e-01 at
 *   0.0500000119 0.275525391 0.138197899 0.434072077 1, rms 8.938214e-02 */
#define LOBE_SPHERE_LIGHT_MEDIUM_Q30_MAX 0.664
#define LOBE_SPHERE_LIGHT_MEDIUM_Q30_RMS 0.0207
#define LOBE_SPHERE_LIGHT_MEDIUM_Q30_BELOW_MAX 1
/* medium, q30, held-out cells, uniform: all 0.0983, view <= 60 0.0606, view >= 75 0.1471,
 *   worst cell 0.5985, energy -0.3031, over a punctual light where sine < alpha / 2 0.0516 */
/* medium, q30, held-out cells, mixed: all 0.0789, view <= 60 0.0465, view >= 75 0.1197,
 *   worst cell 0.2169, energy -0.1890, over a punctual light where sine < alpha / 2 0.0000 */
#define LOBE_SPHERE_LIGHT_MEDIUM_Q30_CELLS 0.0983
#define LOBE_SPHERE_LIGHT_MEDIUM_Q30_CELLS_VIEW60 0.0606
#define LOBE_SPHERE_LIGHT_MEDIUM_Q30_CELLS_VIEW75 0.148
#define LOBE_SPHERE_LIGHT_MEDIUM_Q30_CELLS_ENERGY 0.304
#define LOBE_SPHERE_LIGHT_MEDIUM_Q30_CELLS_EXCESS 0.0516
#define LOBE_SPHERE_LIGHT_HIGH_OPS 106
/* high, f32, in the domain: max 2.700656e-01 at
 *   0.220000088 0.0956202745 -0.461147189 0.00292110443 0.61821717, rms 1.054040e-02 */
/* high, f32, beyond it: max 9.664927e-01 at
 *   0.210596561 0.00100004673 -0.531122029 0.24990952 0.937215924, rms 6.936179e-02 */
#define LOBE_SPHERE_LIGHT_HIGH_F32_MAX 0.271
#define LOBE_SPHERE_LIGHT_HIGH_F32_RMS 0.0106
#define LOBE_SPHERE_LIGHT_HIGH_F32_BELOW_MAX 0.967
/* high, f32, held-out cells, uniform: all 0.0301, view <= 60 0.0134, view >= 75 0.0487,
 *   worst cell 0.1168, energy +0.0633, over a punctual light where sine < alpha / 2 0.0000 */
/* high, f32, held-out cells, mixed: all 0.0301, view <= 60 0.0104, view >= 75 0.0499,
 *   worst cell 0.1152, energy +0.0852, over a punctual light where sine < alpha / 2 0.0000 */
#define LOBE_SPHERE_LIGHT_HIGH_F32_CELLS 0.0302
#define LOBE_SPHERE_LIGHT_HIGH_F32_CELLS_VIEW60 0.0134
#define LOBE_SPHERE_LIGHT_HIGH_F32_CELLS_VIEW75 0.05
#define LOBE_SPHERE_LIGHT_HIGH_F32_CELLS_ENERGY 0.0852
#define LOBE_SPHERE_LIGHT_HIGH_F32_CELLS_EXCESS 0
/* high, q30, in the domain: max 2.700657e-01 at
 *   0.220000029 0.0956917405 -0.460648477 0.00290673971 0.61777848, rms 1.054040e-02 */
/* high, q30, beyond it: max 9.664927e-01 at
 *   0.210596561 0.00100004673 -0.531122029 0.24990952 0.937215924, rms 6.936178e-02 */
#define LOBE_SPHERE_LIGHT_HIGH_Q30_MAX 0.271
#define LOBE_SPHERE_LIGHT_HIGH_Q30_RMS 0.0106
#define LOBE_SPHERE_LIGHT_HIGH_Q30_BELOW_MAX 0.967
/* high, q30, held-out cells, uniform: all 0.0301, view <= 60 0.0134, view >= 75 0.0487,
 *   worst cell 0.1168, energy +0.0633, over a punctual light where sine < alpha / 2 0.0000 */
/* high, q30, held-out cells, mixed: all 0.0301, view <= 60 0.0104, view >= 75 0.0499,
 *   worst cell 0.1152, energy +0.0852, over a punctual light where sine < alpha / 2 0.0000 */
#define LOBE_SPHERE_LIGHT_HIGH_Q30_CELLS 0.0302
#define LOBE_SPHERE_LIGHT_HIGH_Q30_CELLS_VIEW60 0.0134
#define LOBE_SPHERE_LIGHT_HIGH_Q30_CELLS_VIEW75 0.05
#define LOBE_SPHERE_LIGHT_HIGH_Q30_CELLS_ENERGY 0.0852
#define LOBE_SPHERE_LIGHT_HIGH_Q30_CELLS_EXCESS 0
