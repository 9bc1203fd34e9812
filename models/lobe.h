/* Lobe: physically based shading at a known cost and a known error.
 *
 * Conventions
 *   roughness   perceptual, in [0, 1]; alpha = roughness * roughness is the GGX width.
 *   n_dot_v     cosine between normal and view, in [0, 1].
 *   f0, f90     reflectance at normal and at grazing incidence (Schlick, exponent 5).
 *   _f32        IEEE single precision; identical bits on every target (build with -ffp-contract=off).
 *   _q30        32-bit fixed point, 30 fractional bits, [-2, 2): 1.0 is 1 << 30. Integers only.
 *   _n          the same function over arrays; results have the same bits as one call an element.
 *               Arrays have n elements and must not overlap.
 * An input out of its domain, infinities included, is clamped to it; a NaN counts as 0. Nothing here
 * allocates, keeps state, sets errno, or traps.
 * Lights of a size are in lobe_lights.h, spherical Gaussian lights in lobe_sg.h, environments in lobe_env.h; this
 * header includes them. */
#ifndef LOBE_H
#define LOBE_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define LOBE_VERSION "0.1.0"
#define LOBE_ONE_Q30 ((int32_t)1 << 30)

/* A fixed-point number with a block exponent: the value is mantissa * 2^(exponent - 30), the mantissa 0 or in
 * [2^29, 2^30], so that the light of a hundredth of a degree keeps its relative precision. lobe_scaled_to_q30 rounds to
 * plain Q30, saturating. */
typedef struct lobe_scaled_q30 {
    int32_t mantissa, exponent;
} lobe_scaled_q30;
int32_t lobe_scaled_to_q30(lobe_scaled_q30 value);

/* Split sum
 * ---------
 * Reflectance of GGX under constant light is f0 * scale + f90 * bias; lobe_reflectance_f32 computes it. Both terms and
 * their sum E, the directional albedo at f0 = f90 = 1, are in [0, 1] for every input. Errors are absolute, the largest
 * of scale, bias and E, measured in f32 over [.02, 1] in both inputs with the place where it occurs as (roughness,
 * n_dot_v); below is the largest where an input is in [.001, .02). q30 differs from the same formula in double by the
 * figure in the head of models/q30/MODEL_TIER.c, measured, at most 2^-22; no overflow is proved. Its errors are f32's. */
typedef struct lobe_dfg_f32 {
    float scale, bias;
} lobe_dfg_f32;
typedef struct lobe_dfg_q30 {
    int32_t scale, bias;
} lobe_dfg_q30;

/* Height-correlated Smith, what engines ship today: low.
 * max 0.0244, of bias at (0.2316, 0.2307), rms 0.00978; below 0.107. 20 operations; no table. Source:
 * models/split_sum.h. */
lobe_dfg_f32 lobe_split_sum_low_f32(float roughness, float n_dot_v);
lobe_dfg_q30 lobe_split_sum_low_q30(int32_t roughness, int32_t n_dot_v);
void lobe_split_sum_low_n_f32(const float *roughness, const float *n_dot_v, float *scale, float *bias, size_t n);
void lobe_split_sum_low_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *scale, int32_t *bias,
                              size_t n);

/* Height-correlated Smith, what engines ship today: medium.
 * max 0.0052, of E at (0.9559, 0.7496), rms 0.00262; below 0.0386. 40 operations; no table. Source: models/split_sum.h.
 */
lobe_dfg_f32 lobe_split_sum_medium_f32(float roughness, float n_dot_v);
lobe_dfg_q30 lobe_split_sum_medium_q30(int32_t roughness, int32_t n_dot_v);
void lobe_split_sum_medium_n_f32(const float *roughness, const float *n_dot_v, float *scale, float *bias, size_t n);
void lobe_split_sum_medium_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *scale, int32_t *bias,
                                 size_t n);

/* Height-correlated Smith, what engines ship today: high.
 * max 0.000165, of bias at (0.9090, 0.0200), rms 8.56e-05; below 0.00718. 80 operations; no table. Source:
 * models/split_sum.h. */
lobe_dfg_f32 lobe_split_sum_high_f32(float roughness, float n_dot_v);
lobe_dfg_q30 lobe_split_sum_high_q30(int32_t roughness, int32_t n_dot_v);
void lobe_split_sum_high_n_f32(const float *roughness, const float *n_dot_v, float *scale, float *bias, size_t n);
void lobe_split_sum_high_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *scale, int32_t *bias,
                               size_t n);

/* Separable Smith, GGX as of 2014 and before: low.
 * max 0.0237, of E at (0.4181, 0.9998), rms 0.0111; below 0.121. 19 operations; no table. Source:
 * models/split_sum_sep.h. */
lobe_dfg_f32 lobe_split_sum_sep_low_f32(float roughness, float n_dot_v);
lobe_dfg_q30 lobe_split_sum_sep_low_q30(int32_t roughness, int32_t n_dot_v);
void lobe_split_sum_sep_low_n_f32(const float *roughness, const float *n_dot_v, float *scale, float *bias, size_t n);
void lobe_split_sum_sep_low_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *scale, int32_t *bias,
                                  size_t n);

/* Separable Smith, GGX as of 2014 and before: medium.
 * max 0.00249, of E at (0.8648, 0.3134), rms 0.00143; below 0.0238. 39 operations; no table. Source:
 * models/split_sum_sep.h. */
lobe_dfg_f32 lobe_split_sum_sep_medium_f32(float roughness, float n_dot_v);
lobe_dfg_q30 lobe_split_sum_sep_medium_q30(int32_t roughness, int32_t n_dot_v);
void lobe_split_sum_sep_medium_n_f32(const float *roughness, const float *n_dot_v, float *scale, float *bias, size_t n);
void lobe_split_sum_sep_medium_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *scale, int32_t *bias,
                                     size_t n);

/* Separable Smith, GGX as of 2014 and before: high.
 * max 0.000135, of E at (0.0714, 0.0200), rms 6.97e-05; below 0.00706. 77 operations; no table. Source:
 * models/split_sum_sep.h. */
lobe_dfg_f32 lobe_split_sum_sep_high_f32(float roughness, float n_dot_v);
lobe_dfg_q30 lobe_split_sum_sep_high_q30(int32_t roughness, int32_t n_dot_v);
void lobe_split_sum_sep_high_n_f32(const float *roughness, const float *n_dot_v, float *scale, float *bias, size_t n);
void lobe_split_sum_sep_high_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *scale, int32_t *bias,
                                   size_t n);

/* Bilinear tables
 * ---------------
 * Of scale and bias, with fitted texels; n_dot_v runs along a row, roughness over the rows. The texels are public, to
 * upload as a texture: 2 * N * N values, scale and bias in turn; u16 is unsigned normalised, and what q30 reads. How to
 * address them: models/split_sum_table.h. A table is linked only where it is named.
 *   side   bytes f32, u16   max over [.02, 1]: correlated, separable
 *   32     8192, 4096       0.00315 at (0.1117, 0.0210); 0.00315 at (0.1117, 0.0210)
 *   64     32768, 16384     0.000684 at (0.0705, 0.0224); 0.000703 at (0.0706, 0.0224)
 *   128    131072, 65536    0.000179 at (0.0617, 0.0213); 0.000182 at (0.0617, 0.0213)
 * 26 operations and 4 reads of a pair. Source: cases/split_sum/table_fit.c. */
lobe_dfg_f32 lobe_split_sum_table32_f32(float roughness, float n_dot_v);
lobe_dfg_q30 lobe_split_sum_table32_q30(int32_t roughness, int32_t n_dot_v);
void lobe_split_sum_table32_n_f32(const float *roughness, const float *n_dot_v, float *scale, float *bias, size_t n);
void lobe_split_sum_table32_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *scale, int32_t *bias,
                                  size_t n);
lobe_dfg_f32 lobe_split_sum_table64_f32(float roughness, float n_dot_v);
lobe_dfg_q30 lobe_split_sum_table64_q30(int32_t roughness, int32_t n_dot_v);
void lobe_split_sum_table64_n_f32(const float *roughness, const float *n_dot_v, float *scale, float *bias, size_t n);
void lobe_split_sum_table64_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *scale, int32_t *bias,
                                  size_t n);
lobe_dfg_f32 lobe_split_sum_table128_f32(float roughness, float n_dot_v);
lobe_dfg_q30 lobe_split_sum_table128_q30(int32_t roughness, int32_t n_dot_v);
void lobe_split_sum_table128_n_f32(const float *roughness, const float *n_dot_v, float *scale, float *bias, size_t n);
void lobe_split_sum_table128_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *scale, int32_t *bias,
                                   size_t n);
lobe_dfg_f32 lobe_split_sum_sep_table32_f32(float roughness, float n_dot_v);
lobe_dfg_q30 lobe_split_sum_sep_table32_q30(int32_t roughness, int32_t n_dot_v);
void lobe_split_sum_sep_table32_n_f32(const float *roughness, const float *n_dot_v, float *scale, float *bias,
                                      size_t n);
void lobe_split_sum_sep_table32_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *scale, int32_t *bias,
                                      size_t n);
lobe_dfg_f32 lobe_split_sum_sep_table64_f32(float roughness, float n_dot_v);
lobe_dfg_q30 lobe_split_sum_sep_table64_q30(int32_t roughness, int32_t n_dot_v);
void lobe_split_sum_sep_table64_n_f32(const float *roughness, const float *n_dot_v, float *scale, float *bias,
                                      size_t n);
void lobe_split_sum_sep_table64_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *scale, int32_t *bias,
                                      size_t n);
lobe_dfg_f32 lobe_split_sum_sep_table128_f32(float roughness, float n_dot_v);
lobe_dfg_q30 lobe_split_sum_sep_table128_q30(int32_t roughness, int32_t n_dot_v);
void lobe_split_sum_sep_table128_n_f32(const float *roughness, const float *n_dot_v, float *scale, float *bias,
                                       size_t n);
void lobe_split_sum_sep_table128_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *scale, int32_t *bias,
                                       size_t n);
extern const float lobe_split_sum_table32_texels_f32[2 * 32 * 32];
extern const uint16_t lobe_split_sum_table32_texels_u16[2 * 32 * 32];
extern const float lobe_split_sum_table64_texels_f32[2 * 64 * 64];
extern const uint16_t lobe_split_sum_table64_texels_u16[2 * 64 * 64];
extern const float lobe_split_sum_table128_texels_f32[2 * 128 * 128];
extern const uint16_t lobe_split_sum_table128_texels_u16[2 * 128 * 128];
extern const float lobe_split_sum_sep_table32_texels_f32[2 * 32 * 32];
extern const uint16_t lobe_split_sum_sep_table32_texels_u16[2 * 32 * 32];
extern const float lobe_split_sum_sep_table64_texels_f32[2 * 64 * 64];
extern const uint16_t lobe_split_sum_sep_table64_texels_u16[2 * 64 * 64];
extern const float lobe_split_sum_sep_table128_texels_f32[2 * 128 * 128];
extern const uint16_t lobe_split_sum_sep_table128_texels_u16[2 * 128 * 128];

/* Energy
 * ------
 * E is the directional albedo of GGX at f0 = f90 = 1 (height-correlated Smith): what one bounce returns of a white
 * environment, in [0, 1]. 1/E, in [1, 3.3], is what a single-scattering lobe is multiplied with to pass the white
 * furnace; lobe_compensation_f32 makes the factor for another f0 of it. Measured over [.02, 1] in both inputs;
 * furnace is the larger of |E_true f - 1|, f the tier's 1/E, and |E_true / E - 1|; below is its maximum where an input
 * is in [.001, .02). At n_dot_v = 0, and at roughness = 0 where n_dot_v is above 1e-12, the results are exactly 1. */

/* E: max 0.00829 at (0.2135, 0.2089), rms 0.00392; furnace: max 0.00872 at (0.8494, 0.0200), rms 0.00477; below: E
 * 0.00832, furnace 0.00873.
 * E 20 operations, 1/E 16; no table. Source: cases/energy. */
float lobe_energy_low_f32(float roughness, float n_dot_v);
float lobe_energy_inverse_low_f32(float roughness, float n_dot_v);
void lobe_energy_low_n_f32(const float *roughness, const float *n_dot_v, float *e, size_t n);
void lobe_energy_inverse_low_n_f32(const float *roughness, const float *n_dot_v, float *inverse_e, size_t n);

/* E: max 0.000766 at (0.0210, 0.0222), rms 0.000359; furnace: max 0.000775 at (0.0823, 0.0200), rms 0.000421;
 * below: E 0.00333, furnace 0.0034.
 * E 40 operations, 1/E 36; no table. Source: cases/energy. */
float lobe_energy_medium_f32(float roughness, float n_dot_v);
float lobe_energy_inverse_medium_f32(float roughness, float n_dot_v);
void lobe_energy_medium_n_f32(const float *roughness, const float *n_dot_v, float *e, size_t n);
void lobe_energy_inverse_medium_n_f32(const float *roughness, const float *n_dot_v, float *inverse_e, size_t n);

/* E: max 5.22e-05 at (0.0361, 0.0200), rms 2.49e-05; furnace: max 5.45e-05 at (0.1812, 0.0200), rms 3.02e-05;
 * below: E 0.00173, furnace 0.00176.
 * E 77 operations, 1/E 73; no table. Source: cases/energy. */
float lobe_energy_high_f32(float roughness, float n_dot_v);
float lobe_energy_inverse_high_f32(float roughness, float n_dot_v);
void lobe_energy_high_n_f32(const float *roughness, const float *n_dot_v, float *e, size_t n);
void lobe_energy_inverse_high_n_f32(const float *roughness, const float *n_dot_v, float *inverse_e, size_t n);

/* The same in 32-bit integers: inputs Q30, E Q30, and 1/E, which reaches 3.3, Q2.29 (1.0 is 1 << 29). E is within
 * 2e-8 of the f32 formula in exact arithmetic; 1/E is the reciprocal of that E, at least 1, within 2.3e-7 of it. */
int32_t lobe_energy_low_q30(int32_t roughness, int32_t n_dot_v);
int32_t lobe_energy_inverse_low_q29(int32_t roughness, int32_t n_dot_v);
void lobe_energy_low_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *e, size_t n);
int32_t lobe_energy_medium_q30(int32_t roughness, int32_t n_dot_v);
int32_t lobe_energy_inverse_medium_q29(int32_t roughness, int32_t n_dot_v);
void lobe_energy_medium_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *e, size_t n);
int32_t lobe_energy_high_q30(int32_t roughness, int32_t n_dot_v);
int32_t lobe_energy_inverse_high_q29(int32_t roughness, int32_t n_dot_v);
void lobe_energy_high_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *e, size_t n);

/* Reflectance
 * -----------
 * What a renderer does with the terms of the split sum. */

/* Directional albedo of one colour channel, f0 * scale + f90 * bias. f0, f90 in [0, 1]; result in [0, 1].
 * Adds at most 1.8e-7 to the error of the terms (q30: 1 unit of 2^-30). 3 operations. Source: Schlick 1994, with the
 * exponent 5 that the terms were integrated with. */
float lobe_reflectance_f32(lobe_dfg_f32 terms, float f0, float f90);
int32_t lobe_reflectance_q30(lobe_dfg_q30 terms, int32_t f0, int32_t f90);

/* The 2 % rule: f90 = min(1, 50 f0). No real dielectric reflects less than 2 % at normal incidence, so a lower f0 is
 * an artist's occlusion and fades the grazing reflectance too; feed it the largest channel of f0. Error at most half
 * an ulp (q30: exact). 1 operation. Source: Hoffman 2012; Lagarde and de Rousiers 2014. */
float lobe_f90_of_f0_f32(float f0);
int32_t lobe_f90_of_f0_q30(int32_t f0);

/* Compensation
 * ------------
 * The factor on a single-scattering lobe that gives back the energy of the bounces it left out. _q29 is Q2.29,
 * [-4, 4): 1.0 is 1 << 29. */

/* 1 + f0 (1/E - 1): 1/E for f0 = 1, 1 for f0 = 0. inverse_e from lobe_energy_inverse_*, clamped to [1, 4]; result in
 * [1, 4] (q29: under 4). Error at most 3e-7 (q29: half a unit). 3 operations. Source: Turquin 2019, equation 16. */
float lobe_compensation_f32(float f0, float inverse_e);
int32_t lobe_compensation_q29(int32_t f0_q30, int32_t inverse_e_q29);

/* Published stand-ins for 1/E, for comparison: 1 + 2 alpha^2 n_dot_v in [1, 3], and 1 + alpha^2 in [1, 2]. Their error
 * against 1/E is in the chart; lobe_energy_inverse_low_f32 costs 16 operations. 4 and 3 operations. */
float lobe_inverse_energy_alpha2_view_f32(float roughness, float n_dot_v);
float lobe_inverse_energy_alpha2_f32(float roughness);
int32_t lobe_inverse_energy_alpha2_view_q29(int32_t roughness, int32_t n_dot_v);
int32_t lobe_inverse_energy_alpha2_q29(int32_t roughness);

/* Diffuse under spherical harmonics
 * ---------------------------------
 * Burley's diffuse (Disney 2012) times the cosine, l / pi (1 + (f - 1)(1 - l)^5)(1 + (f - 1)(1 - v)^5) with
 * f = .5 + 2 roughness (L.H)^2, l = n.L > 0, as nine real spherical harmonics: what it reflects of an environment is
 * their product with the environment's nine. Base colour 1 (multiply the result with yours), 1/pi included.
 *   index       l^2 + l + m; every basis polynomial has a positive sign: .282095; .488603 y, z, x; 1.092548 x y, y z,
 *               .315392 (3 z^2 - 1), 1.092548 x z, .546274 (x^2 - y^2).
 *   frame       of the local coefficients: z = normal, x towards the view; c[1], c[4] and c[5] are 0, the others >= 0.
 * Both inputs in [0, 1]; at 0, at 1 and where view = normal they are finite, continuous and within the bounds. max and
 * rms: of all nine coefficients in f32 (c3 at (.88, 0): of c[3], at roughness .88 and n_dot_v 0); light: relative rms
 * of the radiance over random lighting; furnace: relative, rms and max. q30: within 2e-8 of the same. */
typedef struct lobe_sh9_f32 {
    float c[9];
} lobe_sh9_f32;
typedef struct lobe_sh9_q30 {
    int32_t c[9];
} lobe_sh9_q30;

/* The projection itself, a closed form. max 1.12e-07 (c2 at (.966, .00015)), rms 7.4e-9: rounding; q30 1.9e-9. light
 * 5e-8, furnace 5e-8 and 1.4e-7. 47 operations. Source: cases/diffuse_sh, after Burley 2012. */
lobe_sh9_f32 lobe_diffuse_sh_exact_f32(float roughness, float n_dot_v);
lobe_sh9_q30 lobe_diffuse_sh_exact_q30(int32_t roughness, int32_t n_dot_v);

/* The same with fewer terms. max .00552 (c8 at (1, 0)), rms 3.5e-4; light .25 %, furnace .1 % and .35 %.
 * 27 operations. Source: cases/diffuse_sh. */
lobe_sh9_f32 lobe_diffuse_sh_medium_f32(float roughness, float n_dot_v);
lobe_sh9_q30 lobe_diffuse_sh_medium_q30(int32_t roughness, int32_t n_dot_v);

/* max .0191 (c2 at (1, 0)), rms 1.6e-3; light 1.2 %, furnace .8 % and 2.7 %. 20 operations. Source:
 * cases/diffuse_sh. */
lobe_sh9_f32 lobe_diffuse_sh_low_f32(float roughness, float n_dot_v);
lobe_sh9_q30 lobe_diffuse_sh_low_q30(int32_t roughness, int32_t n_dot_v);

/* One zonal lobe, turned: for what takes one direction. max .0214 (c3 at (.88, 0)), rms 1.8e-3; light 1.3 %, furnace
 * .21 % and 1.65 %; zonal_low max .0643 (c3 at (1, 0)), rms 3.4e-3; light 2.4 %, furnace 1.1 % and 3.9 %. 48 and 42
 * operations: medium costs less. Source: cases/diffuse_sh, after Iwanicki and Pesce 2015. */
lobe_sh9_f32 lobe_diffuse_sh_zonal_f32(float roughness, float n_dot_v);
lobe_sh9_f32 lobe_diffuse_sh_zonal_low_f32(float roughness, float n_dot_v);
lobe_sh9_q30 lobe_diffuse_sh_zonal_q30(int32_t roughness, int32_t n_dot_v);
lobe_sh9_q30 lobe_diffuse_sh_zonal_low_q30(int32_t roughness, int32_t n_dot_v);

/* Lambert's three constants; against Burley max .17 (c2 at (1, 0)), light 13.6 %, furnace 12.5 % and 105 %. */
lobe_sh9_f32 lobe_diffuse_sh_lambert_f32(void);
lobe_sh9_q30 lobe_diffuse_sh_lambert_q30(void);

/* Arrays: c[k] has n elements, the coefficients k. */
void lobe_diffuse_sh_exact_n_f32(const float *roughness, const float *n_dot_v, float *const c[9], size_t n);
void lobe_diffuse_sh_medium_n_f32(const float *roughness, const float *n_dot_v, float *const c[9], size_t n);
void lobe_diffuse_sh_low_n_f32(const float *roughness, const float *n_dot_v, float *const c[9], size_t n);
void lobe_diffuse_sh_zonal_n_f32(const float *roughness, const float *n_dot_v, float *const c[9], size_t n);
void lobe_diffuse_sh_zonal_low_n_f32(const float *roughness, const float *n_dot_v, float *const c[9], size_t n);
void lobe_diffuse_sh_exact_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *const c[9], size_t n);
void lobe_diffuse_sh_medium_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *const c[9], size_t n);
void lobe_diffuse_sh_low_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *const c[9], size_t n);
void lobe_diffuse_sh_zonal_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *const c[9], size_t n);
void lobe_diffuse_sh_zonal_low_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *const c[9], size_t n);

/* The zonal lobe itself: coefficients z0, z1, z2 (indices 0, 2, 6) around the unit direction along_normal * normal +
 * along_view * view, which is where to fetch an irradiance map. Errors as above. 31 and 25 operations. */
typedef struct lobe_zonal_f32 {
    float z0, z1, z2, along_normal, along_view;
} lobe_zonal_f32;
typedef struct lobe_zonal_q30 {
    int32_t z0, z1, z2, along_normal, along_view;
} lobe_zonal_q30;
lobe_zonal_f32 lobe_diffuse_zonal_f32(float roughness, float n_dot_v);
lobe_zonal_f32 lobe_diffuse_zonal_low_f32(float roughness, float n_dot_v);
lobe_zonal_q30 lobe_diffuse_zonal_q30(int32_t roughness, int32_t n_dot_v);
lobe_zonal_q30 lobe_diffuse_zonal_low_q30(int32_t roughness, int32_t n_dot_v);

/* Coefficients in the other convention in use, with the Condon-Shortley phase: 1, 3, 5 and 7 change sign. Its own
 * inverse; exact (q30: -2 becomes 2 - 2^-30). 4 operations. */
lobe_sh9_f32 lobe_sh9_other_sign_f32(lobe_sh9_f32 c);
lobe_sh9_q30 lobe_sh9_other_sign_q30(lobe_sh9_q30 c);

/* Directions and colours, and what lights a point: nine coefficients of radiance a channel, in the convention above.
 * q16 is Q16.16, [-32768, 32768): 1.0 is 1 << 16. */
typedef struct lobe_vec3_f32 {
    float x, y, z;
} lobe_vec3_f32;
typedef struct lobe_lighting_f32 {
    lobe_sh9_f32 red, green, blue;
} lobe_lighting_f32;
typedef struct lobe_vec3_q30 {
    int32_t x, y, z;
} lobe_vec3_q30;
typedef struct lobe_vec3_q16 {
    int32_t x, y, z;
} lobe_vec3_q16;
typedef struct lobe_sh9_q16 {
    int32_t c[9];
} lobe_sh9_q16;
typedef struct lobe_lighting_q16 {
    lobe_sh9_q16 red, green, blue;
} lobe_lighting_q16;

/* Reflected radiance, red, green and blue in x, y and z. normal and view (towards the eye) are unit vectors in the
 * lighting's world, components held at [-1, 1], NaN counts as -1; n.view below 0 counts as 0. A negative result, which
 * ringing lighting can cause, and NaN are 0; the largest is 3.4e38. Relative errors as above: light, furnace. The sums
 * add at most 2e-6 of the lighting's largest coefficient. exact 126 operations, medium 91, low 84, of which 18 are
 * clamps; no root, no normalisation. Source: cases/diffuse_sh. */
lobe_vec3_f32 lobe_diffuse_sh_radiance_exact_f32(float roughness, lobe_vec3_f32 normal, lobe_vec3_f32 view,
                                                 const lobe_lighting_f32 *lighting);
lobe_vec3_f32 lobe_diffuse_sh_radiance_medium_f32(float roughness, lobe_vec3_f32 normal, lobe_vec3_f32 view,
                                                  const lobe_lighting_f32 *lighting);
lobe_vec3_f32 lobe_diffuse_sh_radiance_low_f32(float roughness, lobe_vec3_f32 normal, lobe_vec3_f32 view,
                                               const lobe_lighting_f32 *lighting);

/* The same in integers: roughness and directions Q30, lighting and result Q16.16, the result held at [0, 32768). Adds
 * at most 5 units of 2^-16, and 2e-8 of the lighting's largest coefficient. */
lobe_vec3_q16 lobe_diffuse_sh_radiance_exact_q30(int32_t roughness, lobe_vec3_q30 normal, lobe_vec3_q30 view,
                                                 const lobe_lighting_q16 *lighting);
lobe_vec3_q16 lobe_diffuse_sh_radiance_medium_q30(int32_t roughness, lobe_vec3_q30 normal, lobe_vec3_q30 view,
                                                  const lobe_lighting_q16 *lighting);
lobe_vec3_q16 lobe_diffuse_sh_radiance_low_q30(int32_t roughness, lobe_vec3_q30 normal, lobe_vec3_q30 view,
                                               const lobe_lighting_q16 *lighting);

#include "lobe_lights.h"
#include "lobe_sg.h"
#include "lobe_env.h"

/* Roughness
 * ---------
 * Every engine has its own convention, and most wrong pictures come from a silent mix-up. These give or take the
 * perceptual roughness that every function here expects. Inputs and results in [0, 1] unless said otherwise. Relative
 * error at most 2^-22; q30: 1 unit of 2^-30 (Phong as stated). */
float lobe_alpha_of_roughness_f32(float roughness);       /* roughness^2: Unreal, Unity, Filament, glTF. 1 op */
float lobe_roughness_of_alpha_f32(float alpha);           /* its inverse: pbrt, Mitsuba, MaterialX give alpha. 4 ops */
float lobe_roughness_of_smoothness_f32(float smoothness); /* 1 - smoothness (Unity, glossiness), its own inverse. 1 */
float lobe_roughness_of_gloss_f32(float gloss);           /* (1 - gloss)^2, so alpha = (1 - gloss)^4. 2 ops */
float lobe_gloss_of_roughness_f32(float roughness);       /* its inverse, 1 - sqrt(roughness). 5 ops */
int32_t lobe_alpha_of_roughness_q30(int32_t roughness);
int32_t lobe_roughness_of_alpha_q30(int32_t alpha);
int32_t lobe_roughness_of_smoothness_q30(int32_t smoothness);
int32_t lobe_roughness_of_gloss_q30(int32_t gloss);
int32_t lobe_gloss_of_roughness_q30(int32_t roughness);

/* Blinn-Phong exponent n, alpha = sqrt(2 / (n + 2)) (Walter et al. 2007). f32: n in [0, 1e9], which ends at the
 * roughness .0067. _q16 numbers are Q16.16: n in [0, 32765], roughness at least .0884 on the way there; on the way
 * back below that the exponent stays at 32767.99. Error: roughness 2^-22, n at most 2^-12 of n + 2. 13 and 8 ops. */
float lobe_roughness_of_phong_f32(float exponent);
float lobe_phong_of_roughness_f32(float roughness);
int32_t lobe_roughness_of_phong_q30(int32_t exponent_q16);
int32_t lobe_phong_of_roughness_q16(int32_t roughness_q30);

#ifdef __cplusplus
}
#endif
#endif
