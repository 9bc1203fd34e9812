/* Generated, not edited: build/lobefit bounds capsule_light
 * What ships, measured against the truth (GGX, height-correlated Smith, alpha = roughness^2, F = 1;
 * to 1e-5 here). MAX and RMS are of the absolute error of the radiance of a light of radiance 1.
 * Domain: roughness in [0.22, 1], n_dot_v in [0.08, 1], middle (mx, my, mz) of length 1, arm (ex, ey, ez) to 1, its line at 1.5 radius and .2 or farther, not set, radius in [0.001, 0.5]:
 * a Latin hypercube of 32768 rows, each second one near the mirror direction, the vectors, and a walk
 * uphill from the 4 largest errors; RMS over the hypercube. BELOW_MAX: of half as many and no walk,
 * roughness in [0.05, 1], n_dot_v in [0.001, 1], middle (mx, my, mz) of length 1, arm (ex, ey, ez) to 1, its line at 1.05 radius or farther, not set, radius in [0.001, .9], at least one below 0.22, below 0.08 or above 0.5.
 * CELLS: relative L2 error on held-out cells (cases/capsule_light/cells.h), root of the mean square;
 * ENERGY of the worst cell. OPS: beyond a punctual light.
 * Witnesses are rows of roughness, n_dot_v, middle, arm, radius. Macros are rounded up. */
#define LOBE_CAPSULE_LIGHT_LOW_OPS 193
/* low, f32, in the domain: max 9.535428e-01 at
 *   0.220011234 0.267228186 -0.934459269 -0.336509049 -0.116394043 -0.464116931 0.0713183284 -0.518341422 0.493658245, rms 3.806273e-02 */
/* low, f32, beyond it: max 9.984977e-01 at
 *   0.0716817379 0.264459491 -0.311392009 -0.828354776 0.465685904 0.413575351 -0.256836057 0.74845916 0.720824242, rms 1.101343e-01 */
#define LOBE_CAPSULE_LIGHT_LOW_F32_MAX 0.954
#define LOBE_CAPSULE_LIGHT_LOW_F32_RMS 0.0381
#define LOBE_CAPSULE_LIGHT_LOW_F32_BELOW_MAX 0.999
/* low, f32, held-out cells: all 0.2415, view <= 60 0.1650, view >= 75 0.3240, worst cell 0.6149,
 *   energy +0.3638 */
#define LOBE_CAPSULE_LIGHT_LOW_F32_CELLS 0.242
#define LOBE_CAPSULE_LIGHT_LOW_F32_CELLS_VIEW60 0.166
#define LOBE_CAPSULE_LIGHT_LOW_F32_CELLS_VIEW75 0.324
#define LOBE_CAPSULE_LIGHT_LOW_F32_CELLS_ENERGY 0.364
/* low, q30, in the domain: max 9.535428e-01 at
 *   0.220011234 0.267228186 -0.934459269 -0.336509049 -0.116394043 -0.464116931 0.0713183284 -0.518341422 0.493658245, rms 3.806273e-02 */
/* low, q30, beyond it: max 9.984977e-01 at
 *   0.0716817379 0.264459491 -0.311392009 -0.828354776 0.465685904 0.413575351 -0.256836057 0.74845916 0.720824242, rms 1.101342e-01 */
#define LOBE_CAPSULE_LIGHT_LOW_Q30_MAX 0.954
#define LOBE_CAPSULE_LIGHT_LOW_Q30_RMS 0.0381
#define LOBE_CAPSULE_LIGHT_LOW_Q30_BELOW_MAX 0.999
/* low, q30, held-out cells: all 0.2415, view <= 60 0.1650, view >= 75 0.3240, worst cell 0.6149,
 *   energy +0.3638 */
#define LOBE_CAPSULE_LIGHT_LOW_Q30_CELLS 0.242
#define LOBE_CAPSULE_LIGHT_LOW_Q30_CELLS_VIEW60 0.166
#define LOBE_CAPSULE_LIGHT_LOW_Q30_CELLS_VIEW75 0.324
#define LOBE_CAPSULE_LIGHT_LOW_Q30_CELLS_ENERGY 0.364
#define LOBE_CAPSULE_LIGHT_MEDIUM_OPS 363
/* medium, f32, in the domain: max 9.048677e-01 at
 *   0.220044494 0.161443532 -0.700051963 0.345753253 0.62480557 -0.872149169 0.066351831 -0.484553158 0.499954045, rms 2.483727e-02 */
/* medium, f32, beyond it: max 9.934528e-01 at
 *   0.0675066113 0.0655445457 -0.362129629 0.18770957 0.913031876 0.0465035439 -0.0930697322 0.0814776421 0.882658362, rms 8.232230e-02 */
#define LOBE_CAPSULE_LIGHT_MEDIUM_F32_MAX 0.905
#define LOBE_CAPSULE_LIGHT_MEDIUM_F32_RMS 0.0249
#define LOBE_CAPSULE_LIGHT_MEDIUM_F32_BELOW_MAX 0.994
/* medium, f32, held-out cells: all 0.1093, view <= 60 0.0655, view >= 75 0.1530, worst cell 0.2991,
 *   energy +0.1275 */
#define LOBE_CAPSULE_LIGHT_MEDIUM_F32_CELLS 0.11
#define LOBE_CAPSULE_LIGHT_MEDIUM_F32_CELLS_VIEW60 0.0656
#define LOBE_CAPSULE_LIGHT_MEDIUM_F32_CELLS_VIEW75 0.153
#define LOBE_CAPSULE_LIGHT_MEDIUM_F32_CELLS_ENERGY 0.128
/* medium, q30, in the domain: max 9.048678e-01 at
 *   0.220044494 0.161443532 -0.700051963 0.345753253 0.62480557 -0.872149169 0.066351831 -0.484553158 0.499954045, rms 2.483726e-02 */
/* medium, q30, beyond it: max 9.934528e-01 at
 *   0.0675066113 0.0655445457 -0.362129629 0.18770957 0.913031876 0.0465035439 -0.0930697322 0.0814776421 0.882658362, rms 8.213384e-02 */
#define LOBE_CAPSULE_LIGHT_MEDIUM_Q30_MAX 0.905
#define LOBE_CAPSULE_LIGHT_MEDIUM_Q30_RMS 0.0249
#define LOBE_CAPSULE_LIGHT_MEDIUM_Q30_BELOW_MAX 0.994
/* medium, q30, held-out cells: all 0.1093, view <= 60 0.0655, view >= 75 0.1530, worst cell 0.2991,
 *   energy +0.1275 */
#define LOBE_CAPSULE_LIGHT_MEDIUM_Q30_CELLS 0.11
#define LOBE_CAPSULE_LIGHT_MEDIUM_Q30_CELLS_VIEW60 0.0656
#define LOBE_CAPSULE_LIGHT_MEDIUM_Q30_CELLS_VIEW75 0.153
#define LOBE_CAPSULE_LIGHT_MEDIUM_Q30_CELLS_ENERGY 0.128
#define LOBE_CAPSULE_LIGHT_HIGH_OPS 420
/* high, f32, in the domain: max 9.443814e-01 at
 *   0.220084727 0.236111343 -0.836025715 0.330880105 0.437697828 0.913402796 -0.146331131 0.379646838 0.49998951, rms 2.038014e-02 */
/* high, f32, beyond it: max 9.986821e-01 at
 *   0.0622245669 0.119284928 -0.982664406 0.185190082 -0.00867438316 0.249054015 0.429827631 0.0881803632 0.396992028, rms 7.276480e-02 */
#define LOBE_CAPSULE_LIGHT_HIGH_F32_MAX 0.945
#define LOBE_CAPSULE_LIGHT_HIGH_F32_RMS 0.0204
#define LOBE_CAPSULE_LIGHT_HIGH_F32_BELOW_MAX 0.999
/* high, f32, held-out cells: all 0.0869, view <= 60 0.0506, view >= 75 0.1227, worst cell 0.2759,
 *   energy +0.1377 */
#define LOBE_CAPSULE_LIGHT_HIGH_F32_CELLS 0.087
#define LOBE_CAPSULE_LIGHT_HIGH_F32_CELLS_VIEW60 0.0507
#define LOBE_CAPSULE_LIGHT_HIGH_F32_CELLS_VIEW75 0.123
#define LOBE_CAPSULE_LIGHT_HIGH_F32_CELLS_ENERGY 0.138
/* high, q30, in the domain: max 9.443814e-01 at
 *   0.220084727 0.236111343 -0.836025715 0.330880105 0.437697828 0.913402796 -0.146331131 0.379646838 0.49998951, rms 2.038014e-02 */
/* high, q30, beyond it: max 9.986821e-01 at
 *   0.0622245669 0.119284928 -0.982664406 0.185190082 -0.00867438316 0.249054015 0.429827631 0.0881803632 0.396992028, rms 7.276480e-02 */
#define LOBE_CAPSULE_LIGHT_HIGH_Q30_MAX 0.945
#define LOBE_CAPSULE_LIGHT_HIGH_Q30_RMS 0.0204
#define LOBE_CAPSULE_LIGHT_HIGH_Q30_BELOW_MAX 0.999
/* high, q30, held-out cells: all 0.0869, view <= 60 0.0506, view >= 75 0.1227, worst cell 0.2759,
 *   energy +0.1377 */
#define LOBE_CAPSULE_LIGHT_HIGH_Q30_CELLS 0.087
#define LOBE_CAPSULE_LIGHT_HIGH_Q30_CELLS_VIEW60 0.0507
#define LOBE_CAPSULE_LIGHT_HIGH_Q30_CELLS_VIEW75 0.123
#define LOBE_CAPSULE_LIGHT_HIGH_Q30_CELLS_ENERGY 0.138
