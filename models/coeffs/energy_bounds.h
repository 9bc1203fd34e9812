/* Generated, not edited: build/lobefit bounds energy
 * What ships, measured against the truth (GGX, height-correlated Smith, alpha = roughness^2; its own error 2e-11).
 * [.02, 1]: a grid of 1024 x 1024, 2^17 random points denser toward low roughness and grazing views,
 * the vectors, and a walk uphill from each maximum; rms over the grid. Witnesses are roughness and
 * n_dot_v. Macros are rounded up: MAX over all outputs and their sum E, RMS the largest of theirs. */
#define LOBE_ENERGY_LOW_OPS 20
#define LOBE_ENERGY_LOW_INVERSE_OPS 16
#define LOBE_ENERGY_LOW_DOMAIN_LO 0.02
/* low, f32, [.02, 1]:
 *   E       max 8.281825e-03 at 0.213509262 0.208890617, rms 3.912956e-03;
 *   furnace max 8.713173e-03 at 0.849364996 0.0200000405, rms 4.769062e-03 */
/* low, f32, below, down to .001:
 *   E       max 8.316199e-03 at 0.853681445 0.0172684193;
 *   furnace max 8.723810e-03 at 0.853051782 0.018623054 */
#define LOBE_ENERGY_LOW_F32_MAX 0.00829
#define LOBE_ENERGY_LOW_F32_RMS 0.00392
#define LOBE_ENERGY_LOW_F32_BELOW_MAX 0.00832
#define LOBE_ENERGY_LOW_F32_FURNACE 0.00872
#define LOBE_ENERGY_LOW_F32_BELOW_FURNACE 0.00873
/* low, q30, [.02, 1]:
 *   E       max 8.281783e-03 at 0.214467227 0.210902512, rms 3.912956e-03;
 *   furnace max 8.713111e-03 at 0.849677384 0.0200000405, rms 4.761743e-03 */
/* low, q30, below, down to .001:
 *   E       max 8.316201e-03 at 0.853051782 0.0173726678;
 *   furnace max 8.723762e-03 at 0.853051782 0.0187276006 */
#define LOBE_ENERGY_LOW_Q30_MAX 0.00829
#define LOBE_ENERGY_LOW_Q30_RMS 0.00392
#define LOBE_ENERGY_LOW_Q30_BELOW_MAX 0.00832
#define LOBE_ENERGY_LOW_Q30_FURNACE 0.00872
#define LOBE_ENERGY_LOW_Q30_BELOW_FURNACE 0.00873
#define LOBE_ENERGY_MEDIUM_OPS 40
#define LOBE_ENERGY_MEDIUM_INVERSE_OPS 36
#define LOBE_ENERGY_MEDIUM_DOMAIN_LO 0.02
/* medium, f32, [.02, 1]:
 *   E       max 7.651786e-04 at 0.0209594369 0.0221841931, rms 3.587844e-04;
 *   furnace max 7.742607e-04 at 0.0823114514 0.0200020075, rms 4.205212e-04 */
/* medium, f32, below, down to .001:
 *   E       max 3.323627e-03 at 1 0.00475144386;
 *   furnace max 3.399862e-03 at 1 0.00489664078 */
#define LOBE_ENERGY_MEDIUM_F32_MAX 0.000766
#define LOBE_ENERGY_MEDIUM_F32_RMS 0.000359
#define LOBE_ENERGY_MEDIUM_F32_BELOW_MAX 0.00333
#define LOBE_ENERGY_MEDIUM_F32_FURNACE 0.000775
#define LOBE_ENERGY_MEDIUM_F32_BELOW_FURNACE 0.0034
/* medium, q30, [.02, 1]:
 *   E       max 7.651390e-04 at 0.0200383067 0.0202718973, rms 3.587841e-04;
 *   furnace max 7.741843e-04 at 0.0822075605 0.0200000405, rms 4.205134e-04 */
/* medium, q30, below, down to .001:
 *   E       max 3.323549e-03 at 1 0.00473958254;
 *   furnace max 3.399792e-03 at 1 0.00489670038 */
#define LOBE_ENERGY_MEDIUM_Q30_MAX 0.000766
#define LOBE_ENERGY_MEDIUM_Q30_RMS 0.000359
#define LOBE_ENERGY_MEDIUM_Q30_BELOW_MAX 0.00333
#define LOBE_ENERGY_MEDIUM_Q30_FURNACE 0.000775
#define LOBE_ENERGY_MEDIUM_Q30_BELOW_FURNACE 0.0034
#define LOBE_ENERGY_HIGH_OPS 77
#define LOBE_ENERGY_HIGH_INVERSE_OPS 73
#define LOBE_ENERGY_HIGH_DOMAIN_LO 0.02
/* high, f32, [.02, 1]:
 *   E       max 5.216425e-05 at 0.0360519886 0.020018518, rms 2.485065e-05;
 *   furnace max 5.447477e-05 at 0.181228876 0.0200000405, rms 3.010922e-05 */
/* high, f32, below, down to .001:
 *   E       max 1.727682e-03 at 0.177301049 0.00100004673;
 *   furnace max 1.750323e-03 at 0.986849606 0.0027077198 */
#define LOBE_ENERGY_HIGH_F32_MAX 5.22e-05
#define LOBE_ENERGY_HIGH_F32_RMS 2.49e-05
#define LOBE_ENERGY_HIGH_F32_BELOW_MAX 0.00173
#define LOBE_ENERGY_HIGH_F32_FURNACE 5.45e-05
#define LOBE_ENERGY_HIGH_F32_BELOW_FURNACE 0.00176
/* high, q30, [.02, 1]:
 *   E       max 5.186764e-05 at 0.0945875049 0.465228021, rms 2.486000e-05;
 *   furnace max 5.439587e-05 at 0.181101799 0.0200000405, rms 3.010940e-05 */
/* high, q30, below, down to .001:
 *   E       max 1.727617e-03 at 0.17674166 0.00100004673;
 *   furnace max 1.750265e-03 at 0.986849606 0.0027077198 */
#define LOBE_ENERGY_HIGH_Q30_MAX 5.19e-05
#define LOBE_ENERGY_HIGH_Q30_RMS 2.49e-05
#define LOBE_ENERGY_HIGH_Q30_BELOW_MAX 0.00173
#define LOBE_ENERGY_HIGH_Q30_FURNACE 5.44e-05
#define LOBE_ENERGY_HIGH_Q30_BELOW_FURNACE 0.00176
