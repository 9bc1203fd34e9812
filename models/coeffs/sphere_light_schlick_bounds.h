/* Generated, not edited: build/lobefit bounds sphere_light_schlick
 * What ships, measured against the truth (GGX, height-correlated Smith, alpha = roughness^2;
 * its own error 1e-6 relative). MAX and RMS are of s, absolute, where the light gives at least 0.01: as
 * in sphere_light_bounds.h over its hypercube, the vectors and a walk uphill; BELOW_MAX outside of the
 * domain. OPS: low from scratch, high beyond its radiance. ADDS: what F0 = .5, .2, .1, .04, .02 adds to
 * the relative L2 error over the held-out cells, in f32, low and medium with the s of low, high with
 * its own; 0 where it takes away. Macros are rounded up. */
#define LOBE_SPHERE_LIGHT_SCHLICK_LOW_OPS 33
/* low, f32, in the domain: max 4.022889e-01 at
 *   0.758526385 0.0800000429 -0.58577913 0.00891888142 0.69020319, rms 2.528209e-02; beyond it 6.088941e-01 */
#define LOBE_SPHERE_LIGHT_SCHLICK_LOW_F32_MAX 0.403
#define LOBE_SPHERE_LIGHT_SCHLICK_LOW_F32_RMS 0.0253
#define LOBE_SPHERE_LIGHT_SCHLICK_LOW_F32_BELOW_MAX 0.609
/* low, q30, in the domain: max 4.022889e-01 at
 *   0.758526385 0.0800000429 -0.58577913 0.00891888142 0.69020319, rms 2.528209e-02; beyond it 6.088942e-01 */
#define LOBE_SPHERE_LIGHT_SCHLICK_LOW_Q30_MAX 0.403
#define LOBE_SPHERE_LIGHT_SCHLICK_LOW_Q30_RMS 0.0253
#define LOBE_SPHERE_LIGHT_SCHLICK_LOW_Q30_BELOW_MAX 0.609
#define LOBE_SPHERE_LIGHT_SCHLICK_HIGH_OPS 43
/* high, f32, in the domain: max 3.655469e-01 at
 *   0.842554271 0.0800001025 -0.577027678 0.00815397501 0.697369337, rms 2.112290e-02; beyond it 7.654653e-01 */
#define LOBE_SPHERE_LIGHT_SCHLICK_HIGH_F32_MAX 0.366
#define LOBE_SPHERE_LIGHT_SCHLICK_HIGH_F32_RMS 0.0212
#define LOBE_SPHERE_LIGHT_SCHLICK_HIGH_F32_BELOW_MAX 0.766
/* high, q30, in the domain: max 3.655470e-01 at
 *   0.842554271 0.0800001025 -0.577027678 0.00815397501 0.697369337, rms 2.112290e-02; beyond it 7.654653e-01 */
#define LOBE_SPHERE_LIGHT_SCHLICK_HIGH_Q30_MAX 0.366
#define LOBE_SPHERE_LIGHT_SCHLICK_HIGH_Q30_RMS 0.0212
#define LOBE_SPHERE_LIGHT_SCHLICK_HIGH_Q30_BELOW_MAX 0.766
/* low, uniform: 0.1202 at F0 = 1, +0.0005 at 0.5, +0.0021 at 0.2, +0.0040 at 0.1, +0.0079 at 0.04, +0.0122 at 0.02 */
/* low, mixed: 0.1214 at F0 = 1, +0.0024 at 0.5, +0.0063 at 0.2, +0.0093 at 0.1, +0.0134 at 0.04, +0.0170 at 0.02 */
#define LOBE_SPHERE_LIGHT_SCHLICK_LOW_F32_ADDS_50 0.00237
#define LOBE_SPHERE_LIGHT_SCHLICK_LOW_F32_ADDS_20 0.00627
#define LOBE_SPHERE_LIGHT_SCHLICK_LOW_F32_ADDS_10 0.00933
#define LOBE_SPHERE_LIGHT_SCHLICK_LOW_F32_ADDS_04 0.0135
#define LOBE_SPHERE_LIGHT_SCHLICK_LOW_F32_ADDS_02 0.0171
/* medium, uniform: 0.0902 at F0 = 1, -0.0008 at 0.5, -0.0003 at 0.2, +0.0024 at 0.1, +0.0099 at 0.04, +0.0188 at 0.02 */
/* medium, mixed: 0.0673 at F0 = 1, -0.0010 at 0.5, -0.0001 at 0.2, +0.0026 at 0.1, +0.0087 at 0.04, +0.0153 at 0.02 */
#define LOBE_SPHERE_LIGHT_SCHLICK_MEDIUM_F32_ADDS_50 0
#define LOBE_SPHERE_LIGHT_SCHLICK_MEDIUM_F32_ADDS_20 0
#define LOBE_SPHERE_LIGHT_SCHLICK_MEDIUM_F32_ADDS_10 0.00265
#define LOBE_SPHERE_LIGHT_SCHLICK_MEDIUM_F32_ADDS_04 0.00987
#define LOBE_SPHERE_LIGHT_SCHLICK_MEDIUM_F32_ADDS_02 0.0189
/* high, uniform: 0.0308 at F0 = 1, -0.0020 at 0.5, -0.0017 at 0.2, +0.0007 at 0.1, +0.0052 at 0.04, +0.0094 at 0.02 */
/* high, mixed: 0.0322 at F0 = 1, -0.0028 at 0.5, -0.0040 at 0.2, -0.0027 at 0.1, +0.0005 at 0.04, +0.0034 at 0.02 */
#define LOBE_SPHERE_LIGHT_SCHLICK_HIGH_F32_ADDS_50 0
#define LOBE_SPHERE_LIGHT_SCHLICK_HIGH_F32_ADDS_20 0
#define LOBE_SPHERE_LIGHT_SCHLICK_HIGH_F32_ADDS_10 0.000744
#define LOBE_SPHERE_LIGHT_SCHLICK_HIGH_F32_ADDS_04 0.00523
#define LOBE_SPHERE_LIGHT_SCHLICK_HIGH_F32_ADDS_02 0.00938
