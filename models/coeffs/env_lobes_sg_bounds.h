/* Generated, not edited: build/lobefit bounds env_lobes_sg
 * What ships, measured against the truth (GGX, height-correlated Smith, alpha = roughness^2; its own error 2e-11).
 * [.02, 1]: a grid of 1024 x 1024, 2^17 random points denser toward low roughness and grazing views,
 * the vectors, and a walk uphill from each maximum; rms over the grid. Witnesses are roughness and
 * n_dot_v. Macros are rounded up. MAX, RMS: of the sum of the weights, E is the albedo; ENERGY: of
 * |E / sum - 1|, which a white furnace shows. OPS: the kernel's in models/env_lobes*.h, the albedo given. */
#define LOBE_ENV_LOBES_SG_LOBES1_OPS 86
#define LOBE_ENV_LOBES_SG_LOBES1_DOMAIN_LO 0.02
/* lobes1, f32, [.02, 1]:
 *   E       max 5.216425e-05 at 0.0360519886 0.020018518, rms 2.485065e-05;
 *   furnace max 5.447142e-05 at 0.181228876 0.0200000405, rms 3.010158e-05 */
/* lobes1, f32, below, down to .001:
 *   E       max 1.727682e-03 at 0.177301049 0.00100004673;
 *   furnace max 1.750323e-03 at 0.986849606 0.0027077198 */
#define LOBE_ENV_LOBES_SG_LOBES1_F32_MAX 5.22e-05
#define LOBE_ENV_LOBES_SG_LOBES1_F32_RMS 2.49e-05
#define LOBE_ENV_LOBES_SG_LOBES1_F32_BELOW_MAX 0.00173
#define LOBE_ENV_LOBES_SG_LOBES1_F32_ENERGY 5.45e-05
#define LOBE_ENV_LOBES_SG_LOBES1_F32_BELOW_ENERGY 0.00176
/* lobes1, q30, [.02, 1]:
 *   E       max 5.949101e-05 at 0.0947214365 0.468426824, rms 2.525802e-05;
 *   furnace max 7.595640e-05 at 1 0.996168137, rms 3.070358e-05 */
/* lobes1, q30, below, down to .001:
 *   E       max 1.735192e-03 at 0.176918566 0.00100004673;
 *   furnace max 1.750791e-03 at 0.978626847 0.00286763906 */
#define LOBE_ENV_LOBES_SG_LOBES1_Q30_MAX 5.95e-05
#define LOBE_ENV_LOBES_SG_LOBES1_Q30_RMS 2.53e-05
#define LOBE_ENV_LOBES_SG_LOBES1_Q30_BELOW_MAX 0.00174
#define LOBE_ENV_LOBES_SG_LOBES1_Q30_ENERGY 7.6e-05
#define LOBE_ENV_LOBES_SG_LOBES1_Q30_BELOW_ENERGY 0.00176
#define LOBE_ENV_LOBES_SG_LOBES2_OPS 150
#define LOBE_ENV_LOBES_SG_LOBES2_DOMAIN_LO 0.02
/* lobes2, f32, [.02, 1]:
 *   E       max 5.218531e-05 at 0.0360524058 0.0200176835, rms 2.485071e-05;
 *   furnace max 5.447844e-05 at 0.181228578 0.0200000405, rms 3.010166e-05 */
/* lobes2, f32, below, down to .001:
 *   E       max 1.727703e-03 at 0.177444696 0.00100004673;
 *   furnace max 1.750414e-03 at 0.986849606 0.0027077198 */
#define LOBE_ENV_LOBES_SG_LOBES2_F32_MAX 5.22e-05
#define LOBE_ENV_LOBES_SG_LOBES2_F32_RMS 2.49e-05
#define LOBE_ENV_LOBES_SG_LOBES2_F32_BELOW_MAX 0.00173
#define LOBE_ENV_LOBES_SG_LOBES2_F32_ENERGY 5.45e-05
#define LOBE_ENV_LOBES_SG_LOBES2_F32_BELOW_ENERGY 0.00176
/* lobes2, q30, [.02, 1]:
 *   E       max 5.949101e-05 at 0.0947214365 0.468426824, rms 2.525802e-05;
 *   furnace max 7.595640e-05 at 1 0.996168137, rms 3.070358e-05 */
/* lobes2, q30, below, down to .001:
 *   E       max 1.735192e-03 at 0.176918566 0.00100004673;
 *   furnace max 1.750791e-03 at 0.978626847 0.00286763906 */
#define LOBE_ENV_LOBES_SG_LOBES2_Q30_MAX 5.95e-05
#define LOBE_ENV_LOBES_SG_LOBES2_Q30_RMS 2.53e-05
#define LOBE_ENV_LOBES_SG_LOBES2_Q30_BELOW_MAX 0.00174
#define LOBE_ENV_LOBES_SG_LOBES2_Q30_ENERGY 7.6e-05
#define LOBE_ENV_LOBES_SG_LOBES2_Q30_BELOW_ENERGY 0.00176
#define LOBE_ENV_LOBES_SG_LOBES4_OPS 223
#define LOBE_ENV_LOBES_SG_LOBES4_DOMAIN_LO 0.02
/* lobes4, f32, [.02, 1]:
 *   E       max 5.208770e-05 at 0.0360524058 0.0200119615, rms 2.485109e-05;
 *   furnace max 5.447932e-05 at 0.181011021 0.0200000405, rms 3.010225e-05 */
/* lobes4, f32, below, down to .001:
 *   E       max 1.727693e-03 at 0.176597416 0.00100004673;
 *   furnace max 1.749663e-03 at 0.983403265 0.00262457132 */
#define LOBE_ENV_LOBES_SG_LOBES4_F32_MAX 5.21e-05
#define LOBE_ENV_LOBES_SG_LOBES4_F32_RMS 2.49e-05
#define LOBE_ENV_LOBES_SG_LOBES4_F32_BELOW_MAX 0.00173
#define LOBE_ENV_LOBES_SG_LOBES4_F32_ENERGY 5.45e-05
#define LOBE_ENV_LOBES_SG_LOBES4_F32_BELOW_ENERGY 0.00175
/* lobes4, q30, [.02, 1]:
 *   E       max 5.949101e-05 at 0.0947214365 0.468426824, rms 2.525802e-05;
 *   furnace max 7.595640e-05 at 1 0.996168137, rms 3.070358e-05 */
/* lobes4, q30, below, down to .001:
 *   E       max 1.735192e-03 at 0.176918566 0.00100004673;
 *   furnace max 1.750791e-03 at 0.978626847 0.00286763906 */
#define LOBE_ENV_LOBES_SG_LOBES4_Q30_MAX 5.95e-05
#define LOBE_ENV_LOBES_SG_LOBES4_Q30_RMS 2.53e-05
#define LOBE_ENV_LOBES_SG_LOBES4_Q30_BELOW_MAX 0.00174
#define LOBE_ENV_LOBES_SG_LOBES4_Q30_ENERGY 7.6e-05
#define LOBE_ENV_LOBES_SG_LOBES4_Q30_BELOW_ENERGY 0.00176
#define LOBE_ENV_LOBES_SG_LOBES8_OPS 287
#define LOBE_ENV_LOBES_SG_LOBES8_DOMAIN_LO 0.02
/* lobes8, f32, [.02, 1]:
 *   E       max 5.216200e-05 at 0.0360524058 0.0200101137, rms 2.485110e-05;
 *   furnace max 5.484686e-05 at 0.99552691 0.0425660014, rms 3.010293e-05 */
/* lobes8, f32, below, down to .001:
 *   E       max 1.727762e-03 at 0.177084208 0.00100004673;
 *   furnace max 1.747354e-03 at 0.979784608 0.00275039673 */
#define LOBE_ENV_LOBES_SG_LOBES8_F32_MAX 5.22e-05
#define LOBE_ENV_LOBES_SG_LOBES8_F32_RMS 2.49e-05
#define LOBE_ENV_LOBES_SG_LOBES8_F32_BELOW_MAX 0.00173
#define LOBE_ENV_LOBES_SG_LOBES8_F32_ENERGY 5.49e-05
#define LOBE_ENV_LOBES_SG_LOBES8_F32_BELOW_ENERGY 0.00175
/* lobes8, q30, [.02, 1]:
 *   E       max 5.949101e-05 at 0.0947214365 0.468426824, rms 2.525802e-05;
 *   furnace max 7.595640e-05 at 1 0.996168137, rms 3.070358e-05 */
/* lobes8, q30, below, down to .001:
 *   E       max 1.735192e-03 at 0.176918566 0.00100004673;
 *   furnace max 1.750791e-03 at 0.978626847 0.00286763906 */
#define LOBE_ENV_LOBES_SG_LOBES8_Q30_MAX 5.95e-05
#define LOBE_ENV_LOBES_SG_LOBES8_Q30_RMS 2.53e-05
#define LOBE_ENV_LOBES_SG_LOBES8_Q30_BELOW_MAX 0.00174
#define LOBE_ENV_LOBES_SG_LOBES8_Q30_ENERGY 7.6e-05
#define LOBE_ENV_LOBES_SG_LOBES8_Q30_BELOW_ENERGY 0.00176
