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
 * allocates, keeps state, sets errno, or traps. */
#ifndef LOBE_H
#define LOBE_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define LOBE_VERSION "0.1.0"
#define LOBE_ONE_Q30 ((int32_t)1 << 30)

/* Split sum
 * ---------
 * Reflectance of GGX under constant light is f0 * scale + f90 * bias. */
typedef struct lobe_dfg_f32 {
    float scale, bias;
} lobe_dfg_f32;
typedef struct lobe_dfg_q30 {
    int32_t scale, bias;
} lobe_dfg_q30;

/* Height-correlated Smith: what engines ship today. */
lobe_dfg_f32 lobe_split_sum_low_f32(float roughness, float n_dot_v);
lobe_dfg_f32 lobe_split_sum_medium_f32(float roughness, float n_dot_v);
lobe_dfg_f32 lobe_split_sum_high_f32(float roughness, float n_dot_v);
lobe_dfg_f32 lobe_split_sum_table32_f32(float roughness, float n_dot_v);
lobe_dfg_f32 lobe_split_sum_table64_f32(float roughness, float n_dot_v);
lobe_dfg_f32 lobe_split_sum_table128_f32(float roughness, float n_dot_v);
lobe_dfg_q30 lobe_split_sum_low_q30(int32_t roughness, int32_t n_dot_v);
lobe_dfg_q30 lobe_split_sum_medium_q30(int32_t roughness, int32_t n_dot_v);
lobe_dfg_q30 lobe_split_sum_high_q30(int32_t roughness, int32_t n_dot_v);
lobe_dfg_q30 lobe_split_sum_table32_q30(int32_t roughness, int32_t n_dot_v);
lobe_dfg_q30 lobe_split_sum_table64_q30(int32_t roughness, int32_t n_dot_v);
lobe_dfg_q30 lobe_split_sum_table128_q30(int32_t roughness, int32_t n_dot_v);

/* Separable Smith: GGX as of 2014 and before. */
lobe_dfg_f32 lobe_split_sum_sep_low_f32(float roughness, float n_dot_v);
lobe_dfg_f32 lobe_split_sum_sep_medium_f32(float roughness, float n_dot_v);
lobe_dfg_f32 lobe_split_sum_sep_high_f32(float roughness, float n_dot_v);
lobe_dfg_f32 lobe_split_sum_sep_table32_f32(float roughness, float n_dot_v);
lobe_dfg_f32 lobe_split_sum_sep_table64_f32(float roughness, float n_dot_v);
lobe_dfg_f32 lobe_split_sum_sep_table128_f32(float roughness, float n_dot_v);
lobe_dfg_q30 lobe_split_sum_sep_low_q30(int32_t roughness, int32_t n_dot_v);
lobe_dfg_q30 lobe_split_sum_sep_medium_q30(int32_t roughness, int32_t n_dot_v);
lobe_dfg_q30 lobe_split_sum_sep_high_q30(int32_t roughness, int32_t n_dot_v);
lobe_dfg_q30 lobe_split_sum_sep_table32_q30(int32_t roughness, int32_t n_dot_v);
lobe_dfg_q30 lobe_split_sum_sep_table64_q30(int32_t roughness, int32_t n_dot_v);
lobe_dfg_q30 lobe_split_sum_sep_table128_q30(int32_t roughness, int32_t n_dot_v);

/* Arrays */
void lobe_split_sum_low_n_f32(const float *roughness, const float *n_dot_v, float *scale, float *bias, size_t n);
void lobe_split_sum_medium_n_f32(const float *roughness, const float *n_dot_v, float *scale, float *bias, size_t n);
void lobe_split_sum_high_n_f32(const float *roughness, const float *n_dot_v, float *scale, float *bias, size_t n);
void lobe_split_sum_table32_n_f32(const float *roughness, const float *n_dot_v, float *scale, float *bias, size_t n);
void lobe_split_sum_table64_n_f32(const float *roughness, const float *n_dot_v, float *scale, float *bias, size_t n);
void lobe_split_sum_table128_n_f32(const float *roughness, const float *n_dot_v, float *scale, float *bias, size_t n);
void lobe_split_sum_low_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *scale, int32_t *bias, size_t n);
void lobe_split_sum_medium_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *scale, int32_t *bias,
                                 size_t n);
void lobe_split_sum_high_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *scale, int32_t *bias,
                               size_t n);
void lobe_split_sum_sep_low_n_f32(const float *roughness, const float *n_dot_v, float *scale, float *bias, size_t n);
void lobe_split_sum_sep_medium_n_f32(const float *roughness, const float *n_dot_v, float *scale, float *bias, size_t n);
void lobe_split_sum_sep_high_n_f32(const float *roughness, const float *n_dot_v, float *scale, float *bias, size_t n);
void lobe_split_sum_sep_low_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *scale, int32_t *bias,
                                  size_t n);
void lobe_split_sum_sep_medium_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *scale, int32_t *bias,
                                     size_t n);
void lobe_split_sum_sep_high_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *scale, int32_t *bias,
                                   size_t n);

/* Energy
 * ------
 * E is the directional albedo at f0 = f90 = 1 (height-correlated Smith), in [0, 1]; 1/E is what a
 * single-scattering lobe must be multiplied with to pass the white furnace. */
float lobe_energy_low_f32(float roughness, float n_dot_v);
float lobe_energy_medium_f32(float roughness, float n_dot_v);
float lobe_energy_high_f32(float roughness, float n_dot_v);
int32_t lobe_energy_low_q30(int32_t roughness, int32_t n_dot_v);
int32_t lobe_energy_medium_q30(int32_t roughness, int32_t n_dot_v);
int32_t lobe_energy_high_q30(int32_t roughness, int32_t n_dot_v);

#ifdef __cplusplus
}
#endif
#endif
