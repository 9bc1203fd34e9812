/* Generated, not edited: build/lobefit bounds sg_diffuse
 * What ships, measured against the truth (its own error 1e-9 of the light overhead) on 97 versines
 * from 0.000244140625 to 1 and 161 heights. MAX and RMS are absolute, BEYOND_MAX for versines from 1 to 2,
 * OF_OVERHEAD is in parts of what the light gives overhead. Witnesses are n_dot_l and versine. Macros are
 * rounded up. */
#define LOBE_SG_DIFFUSE_HIGH_OPS 44
/* high, f32: max 2.481557e-03 at 1 0.385552704, rms 4.116585e-04;
 *   of the light overhead: max 5.002883e-03 at 1 0.385552704, rms 1.009609e-03 */
#define LOBE_SG_DIFFUSE_HIGH_F32_MAX 0.00249
#define LOBE_SG_DIFFUSE_HIGH_F32_RMS 0.000412
#define LOBE_SG_DIFFUSE_HIGH_F32_BEYOND_MAX 0.00238
#define LOBE_SG_DIFFUSE_HIGH_F32_OF_OVERHEAD 0.00501
#define LOBE_SG_DIFFUSE_HIGH_F32_OF_OVERHEAD_RMS 0.00101
/* high, q30: max 2.481548e-03 at -1 0.385552704, rms 4.116588e-04;
 *   of the light overhead: max 5.002865e-03 at -1 0.385552704, rms 1.009610e-03 */
#define LOBE_SG_DIFFUSE_HIGH_Q30_MAX 0.00249
#define LOBE_SG_DIFFUSE_HIGH_Q30_RMS 0.000412
#define LOBE_SG_DIFFUSE_HIGH_Q30_BEYOND_MAX 0.00238
#define LOBE_SG_DIFFUSE_HIGH_Q30_OF_OVERHEAD 0.00501
#define LOBE_SG_DIFFUSE_HIGH_Q30_OF_OVERHEAD_RMS 0.00101
#define LOBE_SG_DIFFUSE_INNER_OPS 41
/* inner, f32: max 5.609932e-02 at -1 1, rms 1.190674e-02;
 *   of the light overhead: max 1.696755e-01 at 1 0.000244140625, rms 6.187766e-02 */
#define LOBE_SG_DIFFUSE_INNER_F32_MAX 0.0561
#define LOBE_SG_DIFFUSE_INNER_F32_RMS 0.012
#define LOBE_SG_DIFFUSE_INNER_F32_BEYOND_MAX 0.0694
#define LOBE_SG_DIFFUSE_INNER_F32_OF_OVERHEAD 0.17
#define LOBE_SG_DIFFUSE_INNER_F32_OF_OVERHEAD_RMS 0.0619
