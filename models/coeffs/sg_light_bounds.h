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
#define LOBE_SG_LIGHT_MEDIUM_OPS 38
/* medium, f32, in the domain: max 1.785544e-01 at
 *   0.400044918 0.0500210524 -0.0734743476 5.36441803e-07 0.121773481, rms 1.211858e-02 */
/* medium, f32, beyond it: max 6.679491e-01 at
 *   0.371802092 0.00100004673 -0.513762712 0.00504601002 0.224509239, rms 5.212699e-02 */
#define LOBE_SG_LIGHT_MEDIUM_F32_MAX 0.179
#define LOBE_SG_LIGHT_MEDIUM_F32_RMS 0.0122
#define LOBE_SG_LIGHT_MEDIUM_F32_BELOW_MAX 0.668
/* medium, f32, held-out cells, uniform: all 0.1538, smooth 0.0774, worst cell 1.5098, energy +0.4241 */
/* medium, f32, held-out cells, mixed: all 0.0959, smooth 0.0742, worst cell 0.2203, energy -0.1615 */
#define LOBE_SG_LIGHT_MEDIUM_F32_CELLS 0.154
#define LOBE_SG_LIGHT_MEDIUM_F32_CELLS_SMOOTH 0.0775
/* medium, q30, in the domain: max 1.785544e-01 at
 *   0.400044858 0.0500210524 -0.0734743476 5.36441803e-07 0.121773481, rms 1.211858e-02 */
/* medium, q30, beyond it: max 6.679496e-01 at
 *   0.371663988 0.00100004673 -0.514027238 0.00505703688 0.224659204, rms 5.212699e-02 */
#define LOBE_SG_LIGHT_MEDIUM_Q30_MAX 0.179
#define LOBE_SG_LIGHT_MEDIUM_Q30_RMS 0.0122
#define LOBE_SG_LIGHT_MEDIUM_Q30_BELOW_MAX 0.668
/* medium, q30, held-out cells, uniform: all 0.1538, smooth 0.0774, worst cell 1.5098, energy +0.4241 */
/* medium, q30, held-out cells, mixed: all 0.0959, smooth 0.0742, worst cell 0.2203, energy -0.1615 */
#define LOBE_SG_LIGHT_MEDIUM_Q30_CELLS 0.154
#define LOBE_SG_LIGHT_MEDIUM_Q30_CELLS_SMOOTH 0.0775
#define LOBE_SG_LIGHT_HIGH_OPS 94
/* high, f32, in the domain: max 1.960110e-01 at
 *   0.253765464 0.0500000119 0.133858562 1.50203705e-05 0.25, rms 9.357310e-03 */
/* high, f32, beyond it: max 8.227749e-01 at
 *   0.453184426 0.00100004673 -0.690835953 0.0191882849 0.425374806, rms 6.189538e-02 */
#define LOBE_SG_LIGHT_HIGH_F32_MAX 0.197
#define LOBE_SG_LIGHT_HIGH_F32_RMS 0.00936
#define LOBE_SG_LIGHT_HIGH_F32_BELOW_MAX 0.823
/* high, f32, held-out cells, uniform: all 0.1104, smooth 0.0650, worst cell 1.0312, energy +0.3740 */
/* high, f32, held-out cells, mixed: all 0.0676, smooth 0.0569, worst cell 0.1626, energy -0.1058 */
#define LOBE_SG_LIGHT_HIGH_F32_CELLS 0.111
#define LOBE_SG_LIGHT_HIGH_F32_CELLS_SMOOTH 0.065
/* high, q30, in the domain: max 1.960110e-01 at
 *   0.253687084 0.0500000119 0.133413613 1.47819519e-05 0.25, rms 9.357310e-03 */
/* high, q30, beyond it: max 8.245717e-01 at
 *   0.450691879 0.00100004673 -0.708703637 0.0217399597 0.435103118, rms 6.189538e-02 */
#define LOBE_SG_LIGHT_HIGH_Q30_MAX 0.197
#define LOBE_SG_LIGHT_HIGH_Q30_RMS 0.00936
#define LOBE_SG_LIGHT_HIGH_Q30_BELOW_MAX 0.825
/* high, q30, held-out cells, uniform: all 0.1104, smooth 0.0650, worst cell 1.0312, energy +0.3740 */
/* high, q30, held-out cells, mixed: all 0.0676, smooth 0.0569, worst cell 0.1626, energy -0.1058 */
#define LOBE_SG_LIGHT_HIGH_Q30_CELLS 0.111
#define LOBE_SG_LIGHT_HIGH_Q30_CELLS_SMOOTH 0.065
