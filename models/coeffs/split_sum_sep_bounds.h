/* Generated, not edited: build/lobefit bounds split_sum_sep
 * What ships, measured against the truth (GGX, separable Smith, alpha = roughness^2; its own error 2e-11).
 * [.02, 1]: a grid of 1024 x 1024, 2^17 random points denser toward low roughness and grazing views,
 * the vectors, and a walk uphill from each maximum; rms over the grid. Witnesses are roughness and
 * n_dot_v. Macros are rounded up: MAX over all outputs and their sum E, RMS the largest of theirs. */
#define LOBE_SPLIT_SUM_SEP_LOW_OPS 19
#define LOBE_SPLIT_SUM_SEP_LOW_DOMAIN_LO 0.02
/* low, f32, [.02, 1]:
 *   scale   max 2.343510e-02 at 0.268575132 0.209758162, rms 1.109477e-02;
 *   bias    max 2.186458e-02 at 0.300697982 0.241295338, rms 4.594724e-03;
 *   E       max 2.361839e-02 at 0.418143332 0.999803126, rms 1.006521e-02 */
/* low, f32, below, down to .001:
 *   scale   max 7.511536e-02 at 0.135996163 0.00100004673;
 *   bias    max 1.201030e-01 at 0.0573982 0.00242984295;
 *   E       max 1.029509e-01 at 0.0381007195 0.00138378143 */
#define LOBE_SPLIT_SUM_SEP_LOW_F32_MAX 0.0237
#define LOBE_SPLIT_SUM_SEP_LOW_F32_RMS 0.0111
#define LOBE_SPLIT_SUM_SEP_LOW_F32_BELOW_MAX 0.121
/* low, q30, [.02, 1]:
 *   scale   max 2.343519e-02 at 0.268575132 0.209758162, rms 1.109477e-02;
 *   bias    max 2.186457e-02 at 0.300697982 0.241295338, rms 4.594724e-03;
 *   E       max 2.361837e-02 at 0.418143332 0.999803126, rms 1.006521e-02 */
/* low, q30, below, down to .001:
 *   scale   max 7.511508e-02 at 0.136042297 0.00100004673;
 *   bias    max 1.201031e-01 at 0.0573982 0.00242984295;
 *   E       max 1.029509e-01 at 0.0381007195 0.00138378143 */
#define LOBE_SPLIT_SUM_SEP_LOW_Q30_MAX 0.0237
#define LOBE_SPLIT_SUM_SEP_LOW_Q30_RMS 0.0111
#define LOBE_SPLIT_SUM_SEP_LOW_Q30_BELOW_MAX 0.121
#define LOBE_SPLIT_SUM_SEP_MEDIUM_OPS 39
#define LOBE_SPLIT_SUM_SEP_MEDIUM_DOMAIN_LO 0.02
/* medium, f32, [.02, 1]:
 *   scale   max 2.476352e-03 at 0.936459303 0.7802248, rms 1.230743e-03;
 *   bias    max 2.472839e-03 at 0.142623365 0.0411604047, rms 7.951545e-04;
 *   E       max 2.482839e-03 at 0.86484766 0.313426375, rms 1.423311e-03 */
/* medium, f32, below, down to .001:
 *   scale   max 1.770834e-02 at 0.103526652 0.00100004673;
 *   bias    max 2.377030e-02 at 0.123434603 0.00100004673;
 *   E       max 1.124093e-02 at 0.29034704 0.00100004673 */
#define LOBE_SPLIT_SUM_SEP_MEDIUM_F32_MAX 0.00249
#define LOBE_SPLIT_SUM_SEP_MEDIUM_F32_RMS 0.00143
#define LOBE_SPLIT_SUM_SEP_MEDIUM_F32_BELOW_MAX 0.0238
/* medium, q30, [.02, 1]:
 *   scale   max 2.476271e-03 at 0.936271369 0.780658185, rms 1.230744e-03;
 *   bias    max 2.472705e-03 at 0.142560363 0.0410890579, rms 7.951534e-04;
 *   E       max 2.482813e-03 at 0.864768624 0.313607693, rms 1.423312e-03 */
/* medium, q30, below, down to .001:
 *   scale   max 1.770819e-02 at 0.103455842 0.00100004673;
 *   bias    max 2.377015e-02 at 0.123459101 0.00100004673;
 *   E       max 1.124092e-02 at 0.291038454 0.00100004673 */
#define LOBE_SPLIT_SUM_SEP_MEDIUM_Q30_MAX 0.00249
#define LOBE_SPLIT_SUM_SEP_MEDIUM_Q30_RMS 0.00143
#define LOBE_SPLIT_SUM_SEP_MEDIUM_Q30_BELOW_MAX 0.0238
#define LOBE_SPLIT_SUM_SEP_HIGH_OPS 77
#define LOBE_SPLIT_SUM_SEP_HIGH_DOMAIN_LO 0.02
/* high, f32, [.02, 1]:
 *   scale   max 1.331191e-04 at 0.139745831 0.0200000405, rms 6.963892e-05;
 *   bias    max 1.323090e-04 at 0.169184446 0.0200000405, rms 5.378273e-05;
 *   E       max 1.342132e-04 at 0.0713579059 0.0200001597, rms 6.921358e-05 */
/* high, f32, below, down to .001:
 *   scale   max 7.053593e-03 at 0.0874791145 0.00100004673;
 *   bias    max 6.857074e-03 at 0.0839533806 0.00100004673;
 *   E       max 4.493621e-04 at 0.158718407 0.00100004673 */
#define LOBE_SPLIT_SUM_SEP_HIGH_F32_MAX 0.000135
#define LOBE_SPLIT_SUM_SEP_HIGH_F32_RMS 6.97e-05
#define LOBE_SPLIT_SUM_SEP_HIGH_F32_BELOW_MAX 0.00706
/* high, q30, [.02, 1]:
 *   scale   max 1.330480e-04 at 0.140083194 0.0200000405, rms 6.963697e-05;
 *   bias    max 1.322054e-04 at 0.169385731 0.0200000405, rms 5.378124e-05;
 *   E       max 1.337516e-04 at 0.0713873506 0.0200001597, rms 6.920898e-05 */
/* high, q30, below, down to .001:
 *   scale   max 7.053489e-03 at 0.0875898004 0.00100004673;
 *   bias    max 6.857005e-03 at 0.0840934515 0.00100004673;
 *   E       max 4.494313e-04 at 0.156975389 0.00100004673 */
#define LOBE_SPLIT_SUM_SEP_HIGH_Q30_MAX 0.000134
#define LOBE_SPLIT_SUM_SEP_HIGH_Q30_RMS 6.97e-05
#define LOBE_SPLIT_SUM_SEP_HIGH_Q30_BELOW_MAX 0.00706
#define LOBE_SPLIT_SUM_SEP_TABLE32_OPS 26
#define LOBE_SPLIT_SUM_SEP_TABLE32_DOMAIN_LO 0.02
/* table32, f32, [.02, 1]:
 *   scale   max 1.238075e-03 at 0.123517692 0.0247234106, rms 1.851858e-04;
 *   bias    max 2.471460e-03 at 0.0770639777 0.0248129964, rms 1.075983e-04;
 *   E       max 3.145032e-03 at 0.111684978 0.0209795237, rms 1.559417e-04 */
/* table32, f32, below, down to .001:
 *   scale   max 4.675097e-03 at 0.0542427301 0.00341075659;
 *   bias    max 4.129640e-02 at 0.0261799097 0.00100004673;
 *   E       max 4.183930e-02 at 0.0263797045 0.00100004673 */
#define LOBE_SPLIT_SUM_SEP_TABLE32_F32_MAX 0.00315
#define LOBE_SPLIT_SUM_SEP_TABLE32_F32_RMS 0.000186
#define LOBE_SPLIT_SUM_SEP_TABLE32_F32_BELOW_MAX 0.0419
/* table32, q30, [.02, 1]:
 *   scale   max 1.234477e-03 at 0.12350136 0.0247367024, rms 1.852411e-04;
 *   bias    max 2.472118e-03 at 0.0770900249 0.0248230696, rms 1.076762e-04;
 *   E       max 3.146638e-03 at 0.111684978 0.0209795237, rms 1.560765e-04 */
/* table32, q30, below, down to .001:
 *   scale   max 4.673613e-03 at 0.054256916 0.00341075659;
 *   bias    max 4.129457e-02 at 0.026173234 0.00100004673;
 *   E       max 4.183934e-02 at 0.0263797045 0.00100004673 */
#define LOBE_SPLIT_SUM_SEP_TABLE32_Q30_MAX 0.00315
#define LOBE_SPLIT_SUM_SEP_TABLE32_Q30_RMS 0.000186
#define LOBE_SPLIT_SUM_SEP_TABLE32_Q30_BELOW_MAX 0.0419
#define LOBE_SPLIT_SUM_SEP_TABLE64_OPS 26
#define LOBE_SPLIT_SUM_SEP_TABLE64_DOMAIN_LO 0.02
/* table64, f32, [.02, 1]:
 *   scale   max 3.201015e-04 at 0.115630746 0.022429049, rms 4.398297e-05;
 *   bias    max 7.020231e-04 at 0.0705522299 0.0224202871, rms 2.544029e-05;
 *   E       max 5.169199e-04 at 0.0706092119 0.0224747658, rms 3.647427e-05 */
/* table64, f32, below, down to .001:
 *   scale   max 2.673083e-03 at 0.0759990811 0.00100004673;
 *   bias    max 2.166938e-02 at 0.0251217484 0.00100004673;
 *   E       max 2.282887e-02 at 0.0250909925 0.00100004673 */
#define LOBE_SPLIT_SUM_SEP_TABLE64_F32_MAX 0.000703
#define LOBE_SPLIT_SUM_SEP_TABLE64_F32_RMS 4.4e-05
#define LOBE_SPLIT_SUM_SEP_TABLE64_F32_BELOW_MAX 0.0229
/* table64, q30, [.02, 1]:
 *   scale   max 3.190790e-04 at 0.115614653 0.022439003, rms 4.405324e-05;
 *   bias    max 7.069709e-04 at 0.0705375075 0.0224219561, rms 2.566498e-05;
 *   E       max 5.189274e-04 at 0.0705963373 0.0224590898, rms 3.658899e-05 */
/* table64, q30, below, down to .001:
 *   scale   max 2.669123e-03 at 0.0759990811 0.00100004673;
 *   bias    max 2.166694e-02 at 0.0251184702 0.00100004673;
 *   E       max 2.282773e-02 at 0.0250852108 0.00100004673 */
#define LOBE_SPLIT_SUM_SEP_TABLE64_Q30_MAX 0.000707
#define LOBE_SPLIT_SUM_SEP_TABLE64_Q30_RMS 4.41e-05
#define LOBE_SPLIT_SUM_SEP_TABLE64_Q30_BELOW_MAX 0.0229
#define LOBE_SPLIT_SUM_SEP_TABLE128_OPS 26
#define LOBE_SPLIT_SUM_SEP_TABLE128_DOMAIN_LO 0.02
/* table128, f32, [.02, 1]:
 *   scale   max 8.597879e-05 at 0.111802399 0.0213574171, rms 1.060214e-05;
 *   bias    max 1.814213e-04 at 0.0616505146 0.0212900043, rms 6.334619e-06;
 *   E       max 1.407197e-04 at 0.0616757274 0.0212900043, rms 8.764572e-06 */
/* table128, f32, below, down to .001:
 *   scale   max 2.082722e-03 at 0.06437397 0.00100004673;
 *   bias    max 1.775488e-02 at 0.0229921341 0.00100004673;
 *   E       max 1.834811e-02 at 0.0229359865 0.00100004673 */
#define LOBE_SPLIT_SUM_SEP_TABLE128_F32_MAX 0.000182
#define LOBE_SPLIT_SUM_SEP_TABLE128_F32_RMS 1.07e-05
#define LOBE_SPLIT_SUM_SEP_TABLE128_F32_BELOW_MAX 0.0184
/* table128, q30, [.02, 1]:
 *   scale   max 8.517982e-05 at 0.123178065 0.0213645697, rms 1.106119e-05;
 *   bias    max 1.886322e-04 at 0.0671430826 0.0213177204, rms 6.987233e-06;
 *   E       max 1.426749e-04 at 0.0671784878 0.0213252306, rms 9.712266e-06 */
/* table128, q30, below, down to .001:
 *   scale   max 2.084389e-03 at 0.0643721819 0.00100004673;
 *   bias    max 1.775681e-02 at 0.0229922533 0.00100004673;
 *   E       max 1.834744e-02 at 0.0229326487 0.00100004673 */
#define LOBE_SPLIT_SUM_SEP_TABLE128_Q30_MAX 0.000189
#define LOBE_SPLIT_SUM_SEP_TABLE128_Q30_RMS 1.11e-05
#define LOBE_SPLIT_SUM_SEP_TABLE128_Q30_BELOW_MAX 0.0184
