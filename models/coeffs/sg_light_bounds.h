/* Generated, not edited: build/lobefit bounds sg_light
 * What ships, measured against the truth (GGX, height-correlated Smith, alpha = roughness^2, F = 1;
 * its own error 1e-7 relative). MAX and RMS are of the absolute error of the radiance of a light
 * of amplitude 1. Domain: roughness [0.22, 1], n_dot_v [0.05, 1], n_dot_l [-1, 1], versine [0.000244140625, 0.25]:
 * a Latin hypercube of 32768 rows, each second one near the mirror direction, the vectors, and a walk
 * uphill from the 2 largest errors; RMS over the hypercube. BELOW_MAX: of a quarter as many where roughness, down
 * to 0.05, n_dot_v, down to 0.001, or versine, from 1.52587891e-05 to 1, is outside.
 * CELLS: relative L2 error on held-out cells (cases/sg_light/cells.h), root of the mean square,
 * the worse of two sets of positions; SMOOTH where alpha <= .25 and n_dot_v >= .4. OPS: beyond a punctual
 * light. Witnesses are roughness, n_dot_v, n_dot_l, tangent2, versine. Macros are rounded up. */
#define LOBE_SG_LIGHT_LOW_OPS 17
/* low, f32, in the domain: max 4.072303e-01 at
 *   0.220000029 0.107361138 0.00283753872 8.34465027e-06 0.0337330103, rms 1.599335e-02 */
/* low, f32, beyond it: max 7.515965e-01 at
 *   0.0500000119 0.00916206837 0.000130593777 5.96046448e-08 0.000728189945, rms 5.307883e-02 */
#define LOBE_SG_LIGHT_LOW_F32_MAX 0.408
#define LOBE_SG_LIGHT_LOW_F32_RMS 0.016
#define LOBE_SG_LIGHT_LOW_F32_BELOW_MAX 0.752
/* low, f32, held-out cells, uniform: all 0.1366, smooth 0.1009, worst cell 0.6870, energy -0.5584 */
/* low, f32, held-out cells, mixed: all 0.1104, smooth 0.0793, worst cell 0.3598, energy -0.3779 */
#define LOBE_SG_LIGHT_LOW_F32_CELLS 0.137
#define LOBE_SG_LIGHT_LOW_F32_CELLS_SMOOTH 0.101
/* low, q30, in the domain: max 4.072822e-01 at
 *   0.220000029 0.105600476 0.00288498402 7.80820847e-06 0.0335258842, rms 1.599335e-02 */
/* low, q30, beyond it: max 7.516573e-01 at
 *   0.0500000119 0.00914138556 0.000133574009 5.96046448e-08 0.00072067976, rms 5.307883e-02 */
#define LOBE_SG_LIGHT_LOW_Q30_MAX 0.408
#define LOBE_SG_LIGHT_LOW_Q30_RMS 0.016
#define LOBE_SG_LIGHT_LOW_Q30_BELOW_MAX 0.752
/* low, q30, held-out cells, uniform: all 0.1366, smooth 0.1009, worst cell 0.6870, energy -0.5584 */
/* low, q30, held-out cells, mixed: all 0.1104, smooth 0.0793, worst cell 0.3598, energy -0.3779 */
#define LOBE_SG_LIGHT_LOW_Q30_CELLS 0.137
#define LOBE_SG_LIGHT_LOW_Q30_CELLS_SMOOTH 0.101
#define LOBE_SG_LIGHT_MEDIUM_OPS 40
/* medium, f32, in the domain: max 1.648112e-01 at
 *   0.395686746 0.0618107319 -0.0912055373 1.31130219e-06 0.102378547, rms 1.188121e-02 */
/* medium, f32, beyond it: max 5.899423e-01 at
 *   0.278094411 0.00100004673 -0.225427151 0.0924668908 0.259767413, rms 5.717610e-02 */
#define LOBE_SG_LIGHT_MEDIUM_F32_MAX 0.165
#define LOBE_SG_LIGHT_MEDIUM_F32_RMS 0.0119
#define LOBE_SG_LIGHT_MEDIUM_F32_BELOW_MAX 0.59
/* medium, f32, held-out cells, uniform: all 0.1019, smooth 0.0564, worst cell 0.4399, energy +0.2984 */
/* medium, f32, held-out cells, mixed: all 0.0856, smooth 0.0596, worst cell 0.2203, energy -0.1771 */
#define LOBE_SG_LIGHT_MEDIUM_F32_CELLS 0.102
#define LOBE_SG_LIGHT_MEDIUM_F32_CELLS_SMOOTH 0.0597
/* medium, q30, in the domain: max 1.648232e-01 at
 *   0.395662546 0.0617809296 -0.091150105 1.31130219e-06 0.102351606, rms 1.188121e-02 */
/* medium, q30, beyond it: max 5.899574e-01 at
 *   0.277449906 0.00100004673 -0.225668609 0.0944977403 0.263091505, rms 5.717610e-02 */
#define LOBE_SG_LIGHT_MEDIUM_Q30_MAX 0.165
#define LOBE_SG_LIGHT_MEDIUM_Q30_RMS 0.0119
#define LOBE_SG_LIGHT_MEDIUM_Q30_BELOW_MAX 0.59
/* medium, q30, held-out cells, uniform: all 0.1019, smooth 0.0564, worst cell 0.4399, energy +0.2984 */
/* medium, q30, held-out cells, mixed: all 0.0856, smooth 0.0596, worst cell 0.2203, energy -0.1771 */
#define LOBE_SG_LIGHT_MEDIUM_Q30_CELLS 0.102
#define LOBE_SG_LIGHT_MEDIUM_Q30_CELLS_SMOOTH 0.0597
#define LOBE_SG_LIGHT_HIGH_OPS 105
/* high, f32, in the domain: max 1.430242e-01 at
 *   0.267648399 0.0500000119 0.12285465 1.00135803e-05 0.25, rms 6.995560e-03 */
/* high, f32, beyond it: max 8.030418e-01 at
 *   0.544075966 0.00100016594 -0.942710459 0.140105486 0.812855124, rms 5.668244e-02 */
#define LOBE_SG_LIGHT_HIGH_F32_MAX 0.144
#define LOBE_SG_LIGHT_HIGH_F32_RMS 0.007
#define LOBE_SG_LIGHT_HIGH_F32_BELOW_MAX 0.804
/* high, f32, held-out cells, uniform: all 0.0647, smooth 0.0430, worst cell 0.3648, energy -0.1507 */
/* high, f32, held-out cells, mixed: all 0.0478, smooth 0.0319, worst cell 0.1180, energy -0.1039 */
#define LOBE_SG_LIGHT_HIGH_F32_CELLS 0.0647
#define LOBE_SG_LIGHT_HIGH_F32_CELLS_SMOOTH 0.0431
/* high, q30, in the domain: max 1.430241e-01 at
 *   0.267734408 0.0500000119 0.122991621 1.0073185e-05 0.25, rms 6.995560e-03 */
/* high, q30, beyond it: max 8.030418e-01 at
 *   0.544075966 0.00100016594 -0.942710459 0.140105486 0.812855124, rms 5.668244e-02 */
#define LOBE_SG_LIGHT_HIGH_Q30_MAX 0.144
#define LOBE_SG_LIGHT_HIGH_Q30_RMS 0.007
#define LOBE_SG_LIGHT_HIGH_Q30_BELOW_MAX 0.804
/* high, q30, held-out cells, uniform: all 0.0647, smooth 0.0430, worst cell 0.3648, energy -0.1507 */
/* high, q30, held-out cells, mixed: all 0.0478, smooth 0.0319, worst cell 0.1180, energy -0.1039 */
#define LOBE_SG_LIGHT_HIGH_Q30_CELLS 0.0647
#define LOBE_SG_LIGHT_HIGH_Q30_CELLS_SMOOTH 0.0431
