/* Generated, not edited: build/lobefit bounds sphere_diffuse
 * What ships, measured against the closed form in double, which is within 2e-15 sine^2 of the truth, on
 * n_dot_l in [-1, 1] and sine in [0, 1]: 1024 half angles by 1025 heights, twice, 2^22 random points, and a
 * walk uphill from each maximum. MAX is absolute, of q30 rounded to plain Q30; RMS over the half angles and
 * uniform heights; OF_SINE2 the largest part of sine^2, the overhead light, for sine from 2^-10, of q30 with
 * its block exponent. Witnesses are n_dot_l and sine. Macros are rounded up. */
#define LOBE_SPHERE_DIFFUSE_LOW_OPS 20
/* low, f32: max 7.645307e-03 at 0.884904206 0.98993814, rms 2.019143e-03;
 *   of sine^2: 7.806628e-03 at -0.884052575 0.989259005 */
#define LOBE_SPHERE_DIFFUSE_LOW_F32_MAX 0.00765
#define LOBE_SPHERE_DIFFUSE_LOW_F32_RMS 0.00202
#define LOBE_SPHERE_DIFFUSE_LOW_F32_OF_SINE2 0.00781
/* low, q30: max 7.645205e-03 at 0.884879216 0.989915493, rms 2.019144e-03;
 *   of sine^2: 7.806621e-03 at 0.884190876 0.989282476 */
#define LOBE_SPHERE_DIFFUSE_LOW_Q30_MAX 0.00765
#define LOBE_SPHERE_DIFFUSE_LOW_Q30_RMS 0.00202
#define LOBE_SPHERE_DIFFUSE_LOW_Q30_OF_SINE2 0.00781
#define LOBE_SPHERE_DIFFUSE_MEDIUM_OPS 40
/* medium, f32: max 5.430448e-04 at 0.814458847 0.997290432, rms 1.863847e-04;
 *   of sine^2: 5.490669e-04 at 0.544203043 0.909805715 */
#define LOBE_SPHERE_DIFFUSE_MEDIUM_F32_MAX 0.000544
#define LOBE_SPHERE_DIFFUSE_MEDIUM_F32_RMS 0.000187
#define LOBE_SPHERE_DIFFUSE_MEDIUM_F32_OF_SINE2 0.00055
/* medium, q30: max 5.429881e-04 at -0.814525391 0.997333745, rms 1.863842e-04;
 *   of sine^2: 5.489729e-04 at 0.542494304 0.909584276 */
#define LOBE_SPHERE_DIFFUSE_MEDIUM_Q30_MAX 0.000543
#define LOBE_SPHERE_DIFFUSE_MEDIUM_Q30_RMS 0.000187
#define LOBE_SPHERE_DIFFUSE_MEDIUM_Q30_OF_SINE2 0.000549
#define LOBE_SPHERE_DIFFUSE_EXACT_OPS 87
/* exact, f32: max 1.533744e-07 at 0.964891732 0.988730073, rms 1.656984e-08;
 *   of sine^2: 1.705139e-07 at 0.84326005 0.926210225 */
#define LOBE_SPHERE_DIFFUSE_EXACT_F32_MAX 1.54e-07
#define LOBE_SPHERE_DIFFUSE_EXACT_F32_RMS 1.66e-08
#define LOBE_SPHERE_DIFFUSE_EXACT_F32_OF_SINE2 1.71e-07
/* exact, q30: max 5.882578e-09 at 0.99795187 0.99896556, rms 8.054677e-10;
 *   of sine^2: 1.125196e-08 at 0.0195653886 0.709539977 */
#define LOBE_SPHERE_DIFFUSE_EXACT_Q30_MAX 5.89e-09
#define LOBE_SPHERE_DIFFUSE_EXACT_Q30_RMS 8.06e-10
#define LOBE_SPHERE_DIFFUSE_EXACT_Q30_OF_SINE2 1.13e-08
