/* Generated, not edited: build/lobefit bounds split_sum
 * What ships, measured against the truth (GGX, height-correlated Smith, alpha = roughness^2; its own error 2e-11).
 * [.02, 1]: a grid of 1024 x 1024, 2^17 random points denser toward low roughness and grazing views,
 * the vectors, and a walk uphill from each maximum; rms over the grid. Witnesses are roughness and
 * n_dot_v. Macros are rounded up: MAX over all outputs and their sum E, RMS the largest of theirs. */
#define LOBE_SPLIT_SUM_LOW_OPS 20
#define LOBE_SPLIT_SUM_LOW_DOMAIN_LO 0.02
/* low, f32, [.02, 1]:
 *   scale   max 2.337835e-02 at 0.254804194 0.0200000405, rms 8.940199e-03;
 *   bias    max 2.438893e-02 at 0.231646478 0.230737925, rms 5.702255e-03;
 *   E       max 2.332458e-02 at 1 0.0200000405, rms 9.773039e-03 */
/* low, f32, below, down to .001:
 *   scale   max 9.109301e-02 at 0.140324056 0.00100004673;
 *   bias    max 1.069964e-01 at 0.0482708812 0.0022880435;
 *   E       max 9.588859e-02 at 0.141829431 0.00100004673 */
#define LOBE_SPLIT_SUM_LOW_F32_MAX 0.0244
#define LOBE_SPLIT_SUM_LOW_F32_RMS 0.00978
#define LOBE_SPLIT_SUM_LOW_F32_BELOW_MAX 0.107
/* low, q30, [.02, 1]:
 *   scale   max 2.337819e-02 at 0.254814446 0.0200000405, rms 8.940199e-03;
 *   bias    max 2.438891e-02 at 0.231646478 0.230737925, rms 5.702255e-03;
 *   E       max 2.332462e-02 at 1 0.0200000405, rms 9.773039e-03 */
/* low, q30, below, down to .001:
 *   scale   max 9.109288e-02 at 0.14047581 0.00100004673;
 *   bias    max 1.069965e-01 at 0.0482708812 0.0022880435;
 *   E       max 9.588856e-02 at 0.141820967 0.00100004673 */
#define LOBE_SPLIT_SUM_LOW_Q30_MAX 0.0244
#define LOBE_SPLIT_SUM_LOW_Q30_RMS 0.00978
#define LOBE_SPLIT_SUM_LOW_Q30_BELOW_MAX 0.107
#define LOBE_SPLIT_SUM_MEDIUM_OPS 40
#define LOBE_SPLIT_SUM_MEDIUM_DOMAIN_LO 0.02
/* medium, f32, [.02, 1]:
 *   scale   max 5.156575e-03 at 0.561251223 1, rms 2.616175e-03;
 *   bias    max 5.158767e-03 at 0.0920934677 0.0200000405, rms 1.893509e-03;
 *   E       max 5.196876e-03 at 0.955933511 0.749566376, rms 2.489760e-03 */
/* medium, f32, below, down to .001:
 *   scale   max 3.858053e-02 at 0.14410007 0.00100004673;
 *   bias    max 3.535735e-02 at 0.148465157 0.00100004673;
 *   E       max 8.085682e-03 at 0.0201246738 0.00100004673 */
#define LOBE_SPLIT_SUM_MEDIUM_F32_MAX 0.0052
#define LOBE_SPLIT_SUM_MEDIUM_F32_RMS 0.00262
#define LOBE_SPLIT_SUM_MEDIUM_F32_BELOW_MAX 0.0386
/* medium, q30, [.02, 1]:
 *   scale   max 5.156607e-03 at 0.561852098 1, rms 2.616175e-03;
 *   bias    max 5.158593e-03 at 0.0921625495 0.0200000405, rms 1.893509e-03;
 *   E       max 5.196728e-03 at 0.955848753 0.74903065, rms 2.489759e-03 */
/* medium, q30, below, down to .001:
 *   scale   max 3.858045e-02 at 0.144083023 0.00100004673;
 *   bias    max 3.535731e-02 at 0.14861083 0.00100004673;
 *   E       max 8.085640e-03 at 0.0201213956 0.00100004673 */
#define LOBE_SPLIT_SUM_MEDIUM_Q30_MAX 0.0052
#define LOBE_SPLIT_SUM_MEDIUM_Q30_RMS 0.00262
#define LOBE_SPLIT_SUM_MEDIUM_Q30_BELOW_MAX 0.0386
#define LOBE_SPLIT_SUM_HIGH_OPS 80
#define LOBE_SPLIT_SUM_HIGH_DOMAIN_LO 0.02
/* high, f32, [.02, 1]:
 *   scale   max 1.611736e-04 at 0.786366463 0.103343129, rms 7.760263e-05;
 *   bias    max 1.645723e-04 at 0.908993185 0.0200000405, rms 6.940729e-05;
 *   E       max 1.590941e-04 at 0.481409311 1, rms 8.555148e-05 */
/* high, f32, below, down to .001:
 *   scale   max 7.171157e-03 at 0.0836130977 0.00100004673;
 *   bias    max 7.029735e-03 at 0.0860650539 0.00100004673;
 *   E       max 4.552083e-04 at 0.0153027177 0.00100004673 */
#define LOBE_SPLIT_SUM_HIGH_F32_MAX 0.000165
#define LOBE_SPLIT_SUM_HIGH_F32_RMS 8.56e-05
#define LOBE_SPLIT_SUM_HIGH_F32_BELOW_MAX 0.00718
/* high, q30, [.02, 1]:
 *   scale   max 1.615239e-04 at 1 0.0200004578, rms 7.760414e-05;
 *   bias    max 1.623507e-04 at 1 0.0200004578, rms 6.940329e-05;
 *   E       max 1.588210e-04 at 0.480960965 1, rms 8.554859e-05 */
/* high, q30, below, down to .001:
 *   scale   max 7.171041e-03 at 0.0836884975 0.00100004673;
 *   bias    max 7.029519e-03 at 0.0860251784 0.00100004673;
 *   E       max 4.549569e-04 at 0.0152800679 0.00100004673 */
#define LOBE_SPLIT_SUM_HIGH_Q30_MAX 0.000163
#define LOBE_SPLIT_SUM_HIGH_Q30_RMS 8.56e-05
#define LOBE_SPLIT_SUM_HIGH_Q30_BELOW_MAX 0.00718
#define LOBE_SPLIT_SUM_TABLE32_OPS 26
#define LOBE_SPLIT_SUM_TABLE32_DOMAIN_LO 0.02
/* table32, f32, [.02, 1]:
 *   scale   max 1.263774e-03 at 0.123501301 0.0247234702, rms 1.676919e-04;
 *   bias    max 2.386174e-03 at 0.0769220591 0.0248827338, rms 1.062521e-04;
 *   E       max 3.148339e-03 at 0.111684978 0.0209795237, rms 1.405012e-04 */
/* table32, f32, below, down to .001:
 *   scale   max 4.731717e-03 at 0.0542781949 0.00341707468;
 *   bias    max 3.952831e-02 at 0.0260766745 0.00100004673;
 *   E       max 4.004968e-02 at 0.0262697935 0.00100004673 */
#define LOBE_SPLIT_SUM_TABLE32_F32_MAX 0.00315
#define LOBE_SPLIT_SUM_TABLE32_F32_RMS 0.000168
#define LOBE_SPLIT_SUM_TABLE32_F32_BELOW_MAX 0.0401
/* table32, q30, [.02, 1]:
 *   scale   max 1.266650e-03 at 0.123505473 0.0247333646, rms 1.678990e-04;
 *   bias    max 2.387476e-03 at 0.0769853592 0.0248827338, rms 1.062761e-04;
 *   E       max 3.154002e-03 at 0.111684978 0.0209795237, rms 1.408582e-04 */
/* table32, q30, below, down to .001:
 *   scale   max 4.734895e-03 at 0.054256916 0.00341707468;
 *   bias    max 3.953042e-02 at 0.0260733366 0.00100004673;
 *   E       max 4.004841e-02 at 0.0262664557 0.00100004673 */
#define LOBE_SPLIT_SUM_TABLE32_Q30_MAX 0.00316
#define LOBE_SPLIT_SUM_TABLE32_Q30_RMS 0.000168
#define LOBE_SPLIT_SUM_TABLE32_Q30_BELOW_MAX 0.0401
#define LOBE_SPLIT_SUM_TABLE64_OPS 26
#define LOBE_SPLIT_SUM_TABLE64_DOMAIN_LO 0.02
/* table64, f32, [.02, 1]:
 *   scale   max 3.261116e-04 at 0.115610719 0.0224323869, rms 3.955239e-05;
 *   bias    max 6.831271e-04 at 0.0705301166 0.0224334598, rms 2.519826e-05;
 *   E       max 4.972648e-04 at 0.0705596209 0.0224994421, rms 3.259664e-05 */
/* table64, f32, below, down to .001:
 *   scale   max 2.744244e-03 at 0.0759990811 0.00100004673;
 *   bias    max 2.063631e-02 at 0.0249747038 0.00100004673;
 *   E       max 2.179601e-02 at 0.0249531269 0.00100004673 */
#define LOBE_SPLIT_SUM_TABLE64_F32_MAX 0.000684
#define LOBE_SPLIT_SUM_TABLE64_F32_RMS 3.96e-05
#define LOBE_SPLIT_SUM_TABLE64_F32_BELOW_MAX 0.0218
/* table64, q30, [.02, 1]:
 *   scale   max 3.304727e-04 at 0.115614653 0.022439003, rms 3.965460e-05;
 *   bias    max 6.851593e-04 at 0.0705375075 0.0224268436, rms 2.540726e-05;
 *   E       max 5.031694e-04 at 0.0705963373 0.0224812627, rms 3.285913e-05 */
/* table64, q30, below, down to .001:
 *   scale   max 2.749813e-03 at 0.0759990811 0.00100004673;
 *   bias    max 2.063647e-02 at 0.02497226 0.00100004673;
 *   E       max 2.179405e-02 at 0.0249539614 0.00100004673 */
#define LOBE_SPLIT_SUM_TABLE64_Q30_MAX 0.000686
#define LOBE_SPLIT_SUM_TABLE64_Q30_RMS 3.97e-05
#define LOBE_SPLIT_SUM_TABLE64_Q30_BELOW_MAX 0.0218
#define LOBE_SPLIT_SUM_TABLE128_OPS 26
#define LOBE_SPLIT_SUM_TABLE128_DOMAIN_LO 0.02
/* table128, f32, [.02, 1]:
 *   scale   max 8.712422e-05 at 0.111794472 0.0213648081, rms 9.507977e-06;
 *   bias    max 1.789620e-04 at 0.0616739392 0.0212916732, rms 6.277687e-06;
 *   E       max 1.382390e-04 at 0.0616739392 0.0212851167, rms 7.830803e-06 */
/* table128, f32, below, down to .001:
 *   scale   max 2.129026e-03 at 0.06437397 0.00100004673;
 *   bias    max 1.680023e-02 at 0.0228111148 0.00100004673;
 *   E       max 1.739815e-02 at 0.0227715373 0.00100004673 */
#define LOBE_SPLIT_SUM_TABLE128_F32_MAX 0.000179
#define LOBE_SPLIT_SUM_TABLE128_F32_RMS 9.51e-06
#define LOBE_SPLIT_SUM_TABLE128_F32_BELOW_MAX 0.0174
/* table128, q30, [.02, 1]:
 *   scale   max 9.042066e-05 at 0.111726403 0.0213606954, rms 1.000839e-05;
 *   bias    max 1.761956e-04 at 0.061675787 0.0212801695, rms 6.929031e-06;
 *   E       max 1.351914e-04 at 0.0616703629 0.0212851167, rms 8.915283e-06 */
/* table128, q30, below, down to .001:
 *   scale   max 2.128401e-03 at 0.0643721819 0.00100004673;
 *   bias    max 1.680161e-02 at 0.0228177309 0.00100004673;
 *   E       max 1.740418e-02 at 0.0227616429 0.00100004673 */
#define LOBE_SPLIT_SUM_TABLE128_Q30_MAX 0.000177
#define LOBE_SPLIT_SUM_TABLE128_Q30_RMS 1.01e-05
#define LOBE_SPLIT_SUM_TABLE128_Q30_BELOW_MAX 0.0175
