/* Generated, not edited: build/lobefit bounds sphere_light
 * What ships, measured against the truth (GGX, height-correlated Smith, alpha = roughness^2, F = 1;
 * its own error 5e-7 relative). MAX and RMS are of the absolute error of the radiance of a light
 * of radiance 1. Domain: roughness [0.22, 1], n_dot_v [0.08, 1], n_dot_l [-1, 1], sine (0, 0.7072]:
 * a Latin hypercube of 131072 rows, each second one near the mirror direction, the vectors, and a walk
 * uphill from the 4 largest errors; RMS over the hypercube. BELOW_MAX: of half as many where roughness, down
 * to 0.05, where the truth ends, n_dot_v, down to 0.001, or sine, up to 1, is outside.
 * CELLS: relative L2 error on held-out cells (cases/sphere_light/cells.h), root of the mean square,
 * the worse of two sets of positions; ENERGY of the worst cell, over 1000 even positions and
 * over the mixed ones, SAMPLED over 200 uniform ones, where a single one can be all of the light. OPS: beyond a punctual light.
 * Witnesses are roughness, n_dot_v, n_dot_l, tangent2, sine. Macros are rounded up. */
#define LOBE_SPHERE_LIGHT_LOW_OPS 19
/* low, f32, in the domain: max 8.044802e-01 at
 *   0.220000029 0.147960246 0.128902197 0.133975208 0.707199931, rms 2.503677e-02 */
/* low, f32, beyond it: max 9.999247e-01 at
 *   0.0500000119 0.412703216 0.160426021 0.362902999 1, rms 1.276634e-01 */
#define LOBE_SPHERE_LIGHT_LOW_F32_MAX 0.805
#define LOBE_SPHERE_LIGHT_LOW_F32_RMS 0.0251
#define LOBE_SPHERE_LIGHT_LOW_F32_BELOW_MAX 1
/* low, f32, held-out cells, uniform: all 0.1202, view <= 60 0.0757, view >= 75 0.1786,
 *   worst cell 0.6671, energy -0.4041, over a punctual light where sine < alpha / 2 0.0009 */
/* low, f32, held-out cells, mixed: all 0.1214, view <= 60 0.0747, view >= 75 0.1818,
 *   worst cell 0.4645, energy +0.2405, over a punctual light where sine < alpha / 2 0.0000 */
#define LOBE_SPHERE_LIGHT_LOW_F32_CELLS 0.122
#define LOBE_SPHERE_LIGHT_LOW_F32_CELLS_VIEW60 0.0758
#define LOBE_SPHERE_LIGHT_LOW_F32_CELLS_VIEW75 0.182
/* low, f32, held-out cells, energy over even positions: worst cell +0.2230 */
#define LOBE_SPHERE_LIGHT_LOW_F32_CELLS_ENERGY 0.241
#define LOBE_SPHERE_LIGHT_LOW_F32_CELLS_ENERGY_SAMPLED 0.405
#define LOBE_SPHERE_LIGHT_LOW_F32_CELLS_EXCESS 0.000915
/* low, q30, in the domain: max 8.044802e-01 at
 *   0.220000029 0.147989213 0.12910372 0.133984506 0.707199991, rms 2.503677e-02 */
/* low, q30, beyond it: max 9.999247e-01 at
 *   0.0500000119 0.412283123 0.160427511 0.36302793 1, rms 1.276637e-01 */
#define LOBE_SPHERE_LIGHT_LOW_Q30_MAX 0.805
#define LOBE_SPHERE_LIGHT_LOW_Q30_RMS 0.0251
#define LOBE_SPHERE_LIGHT_LOW_Q30_BELOW_MAX 1
/* low, q30, held-out cells, uniform: all 0.1202, view <= 60 0.0757, view >= 75 0.1786,
 *   worst cell 0.6671, energy -0.4041, over a punctual light where sine < alpha / 2 0.0009 */
/* low, q30, held-out cells, mixed: all 0.1214, view <= 60 0.0747, view >= 75 0.1818,
 *   worst cell 0.4645, energy +0.2405, over a punctual light where sine < alpha / 2 0.0000 */
#define LOBE_SPHERE_LIGHT_LOW_Q30_CELLS 0.122
#define LOBE_SPHERE_LIGHT_LOW_Q30_CELLS_VIEW60 0.0758
#define LOBE_SPHERE_LIGHT_LOW_Q30_CELLS_VIEW75 0.182
/* low, q30, held-out cells, energy over even positions: worst cell +0.2230 */
#define LOBE_SPHERE_LIGHT_LOW_Q30_CELLS_ENERGY 0.241
#define LOBE_SPHERE_LIGHT_LOW_Q30_CELLS_ENERGY_SAMPLED 0.405
#define LOBE_SPHERE_LIGHT_LOW_Q30_CELLS_EXCESS 0.000915
#define LOBE_SPHERE_LIGHT_MEDIUM_OPS 40
/* medium, f32, in the domain: max 7.488547e-01 at
 *   0.220000029 0.124503374 -0.494779766 0.0037946105 0.707199991, rms 1.929828e-02 */
/* medium, f32, beyond it: max 9.999134e-01 at
 *   0.0500000119 0.35885936 -0.699632168 0.0119780898 1, rms 1.105928e-01 */
#define LOBE_SPHERE_LIGHT_MEDIUM_F32_MAX 0.749
#define LOBE_SPHERE_LIGHT_MEDIUM_F32_RMS 0.0193
#define LOBE_SPHERE_LIGHT_MEDIUM_F32_BELOW_MAX 1
/* medium, f32, held-out cells, uniform: all 0.0902, view <= 60 0.0610, view >= 75 0.1303,
 *   worst cell 0.5070, energy -0.2723, over a punctual light where sine < alpha / 2 0.0038 */
/* medium, f32, held-out cells, mixed: all 0.0673, view <= 60 0.0462, view >= 75 0.0964,
 *   worst cell 0.1854, energy -0.1456, over a punctual light where sine < alpha / 2 0.0000 */
#define LOBE_SPHERE_LIGHT_MEDIUM_F32_CELLS 0.0903
#define LOBE_SPHERE_LIGHT_MEDIUM_F32_CELLS_VIEW60 0.0611
#define LOBE_SPHERE_LIGHT_MEDIUM_F32_CELLS_VIEW75 0.131
/* medium, f32, held-out cells, energy over even positions: worst cell +0.1157 */
#define LOBE_SPHERE_LIGHT_MEDIUM_F32_CELLS_ENERGY 0.146
#define LOBE_SPHERE_LIGHT_MEDIUM_F32_CELLS_ENERGY_SAMPLED 0.273
#define LOBE_SPHERE_LIGHT_MEDIUM_F32_CELLS_EXCESS 0.00381
/* medium, q30, in the domain: max 7.488547e-01 at
 *   0.220000029 0.124503434 -0.494779766 0.0037946105 0.707199991, rms 1.929828e-02 */
/* medium, q30, beyond it: max 9.999134e-01 at
 *   0.0500000119 0.35885936 -0.699632168 0.0119780898 1, rms 1.090001e-01 */
#define LOBE_SPHERE_LIGHT_MEDIUM_Q30_MAX 0.749
#define LOBE_SPHERE_LIGHT_MEDIUM_Q30_RMS 0.0193
#define LOBE_SPHERE_LIGHT_MEDIUM_Q30_BELOW_MAX 1
/* medium, q30, held-out cells, uniform: all 0.0902, view <= 60 0.0610, view >= 75 0.1303,
 *   worst cell 0.5070, energy -0.2723, over a punctual light where sine < alpha / 2 0.0038 */
/* medium, q30, held-out cells, mixed: all 0.0673, view <= 60 0.0462, view >= 75 0.0964,
 *   worst cell 0.1854, energy -0.1456, over a punctual light where sine < alpha / 2 0.0000 */
#define LOBE_SPHERE_LIGHT_MEDIUM_Q30_CELLS 0.0903
#define LOBE_SPHERE_LIGHT_MEDIUM_Q30_CELLS_VIEW60 0.0611
#define LOBE_SPHERE_LIGHT_MEDIUM_Q30_CELLS_VIEW75 0.131
/* medium, q30, held-out cells, energy over even positions: worst cell +0.1157 */
#define LOBE_SPHERE_LIGHT_MEDIUM_Q30_CELLS_ENERGY 0.146
#define LOBE_SPHERE_LIGHT_MEDIUM_Q30_CELLS_ENERGY_SAMPLED 0.273
#define LOBE_SPHERE_LIGHT_MEDIUM_Q30_CELLS_EXCESS 0.00381
#define LOBE_SPHERE_LIGHT_HIGH_OPS 97
/* high, f32, in the domain: max 2.002253e-01 at
 *   0.362374127 0.0800000429 0.146827996 1.47819519e-05 0.707199991, rms 1.163697e-02 */
/* high, f32, beyond it: max 9.720509e-01 at
 *   0.301032782 0.00100016594 -0.782786965 0.263431966 0.98955071, rms 7.663677e-02 */
#define LOBE_SPHERE_LIGHT_HIGH_F32_MAX 0.201
#define LOBE_SPHERE_LIGHT_HIGH_F32_RMS 0.0117
#define LOBE_SPHERE_LIGHT_HIGH_F32_BELOW_MAX 0.973
/* high, f32, held-out cells, uniform: all 0.0308, view <= 60 0.0110, view >= 75 0.0510,
 *   worst cell 0.1234, energy +0.1047, over a punctual light where sine < alpha / 2 0.0000 */
/* high, f32, held-out cells, mixed: all 0.0322, view <= 60 0.0091, view >= 75 0.0543,
 *   worst cell 0.1435, energy +0.1266, over a punctual light where sine < alpha / 2 0.0000 */
#define LOBE_SPHERE_LIGHT_HIGH_F32_CELLS 0.0323
#define LOBE_SPHERE_LIGHT_HIGH_F32_CELLS_VIEW60 0.011
#define LOBE_SPHERE_LIGHT_HIGH_F32_CELLS_VIEW75 0.0544
/* high, f32, held-out cells, energy over even positions: worst cell +0.1050 */
#define LOBE_SPHERE_LIGHT_HIGH_F32_CELLS_ENERGY 0.127
#define LOBE_SPHERE_LIGHT_HIGH_F32_CELLS_ENERGY_SAMPLED 0.127
#define LOBE_SPHERE_LIGHT_HIGH_F32_CELLS_EXCESS 0
/* high, q30, in the domain: max 2.002252e-01 at
 *   0.362442613 0.0800000429 0.146857977 1.4603138e-05 0.707199991, rms 1.163697e-02 */
/* high, q30, beyond it: max 9.720509e-01 at
 *   0.301032782 0.00100016594 -0.782786965 0.263431966 0.98955071, rms 7.663677e-02 */
#define LOBE_SPHERE_LIGHT_HIGH_Q30_MAX 0.201
#define LOBE_SPHERE_LIGHT_HIGH_Q30_RMS 0.0117
#define LOBE_SPHERE_LIGHT_HIGH_Q30_BELOW_MAX 0.973
/* high, q30, held-out cells, uniform: all 0.0308, view <= 60 0.0110, view >= 75 0.0510,
 *   worst cell 0.1234, energy +0.1047, over a punctual light where sine < alpha / 2 0.0000 */
/* high, q30, held-out cells, mixed: all 0.0322, view <= 60 0.0091, view >= 75 0.0543,
 *   worst cell 0.1435, energy +0.1266, over a punctual light where sine < alpha / 2 0.0000 */
#define LOBE_SPHERE_LIGHT_HIGH_Q30_CELLS 0.0323
#define LOBE_SPHERE_LIGHT_HIGH_Q30_CELLS_VIEW60 0.011
#define LOBE_SPHERE_LIGHT_HIGH_Q30_CELLS_VIEW75 0.0544
/* high, q30, held-out cells, energy over even positions: worst cell +0.1050 */
#define LOBE_SPHERE_LIGHT_HIGH_Q30_CELLS_ENERGY 0.127
#define LOBE_SPHERE_LIGHT_HIGH_Q30_CELLS_ENERGY_SAMPLED 0.127
#define LOBE_SPHERE_LIGHT_HIGH_Q30_CELLS_EXCESS 0
