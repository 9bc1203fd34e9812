/* A part of lobe.h, which includes it. */
#ifndef LOBE_ENV_H
#define LOBE_ENV_H
#include "lobe.h"

/* Environment specular
 * --------------------
 * What GGX (height-correlated Smith, F = 1) reflects of an environment, as 1, 2, 4 or 8 taps into a prefiltered one:
 * the colour is the sum of weight * prefiltered(direction, width). All taps stand in the plane of view and normal:
 *   angle    from the normal, in radians, positive away from the view, so the direction is
 *            cos(angle) normal - sin(angle) t, with t the unit vector along view - n_dot_v normal; where there is none,
 *            at n_dot_v = 1, every angle is 0. It may pass pi/2: a prefiltered map answers there too
 *   weight   may be negative: a narrow lobe less what spills under the horizon. The weights sum to the albedo
 *            lobe_energy_high, so a white furnace is right by construction: within 6.3e-5 where roughness and
 *            n_dot_v are in [.02, 1], .0018 below. For Fresnel multiply the colour by
 *            (f0 scale + f90 bias) / (scale + bias) of a split sum
 * and of width there are two kinds, by what the environment was prefiltered with:
 *   lobe_env_lobes      the ordinary split-sum prefilter. width is its roughness, [0, 1], by which an engine picks a
 *                       mip; kernel max(0, c) / (1 + k (1 - c))^2, c the cosine to the tap,
 *                       k = (1 / width^4 - 1) / 2
 *   lobe_env_lobes_sg   spherical Gaussians. The kernel is exp(sharpness (c - 1)), normalised over the sphere; under
 *                       roughness .1 the sharpness stays what it is there
 *
 * All are smooth in both inputs. Both inputs are clamped to [0, 1], which is the domain; NaN counts as 0. Operations
 * include 77 for the albedo, which the kernels in models/env_lobes*.h take from whoever has one. How good they are as
 * pictures: cases/env_lobes and cases/env_lobes_sg.
 *
 * q30: angle and width have 30 fractional bits and differ from the same formula in double by at most 2^-16. What is
 * unbounded is Q16.16, and of spherical Gaussians all is: weights, within 2^-15, and 2^-14 the last, which takes the
 * others' rounding so that the sum is exact; a sharpness, which ends at 32768, a kernel of a third of a degree, and is
 * else within 2^-15 of its value and half a unit. */
typedef struct lobe_env_tap_f32 {
    float angle, width, weight;
} lobe_env_tap_f32;
typedef struct lobe_env_tap_q30 {
    int32_t angle, width, weight_q16;
} lobe_env_tap_q30;
typedef struct lobe_env_sg_tap_f32 {
    float angle, sharpness, weight;
} lobe_env_sg_tap_f32;
typedef struct lobe_env_sg_tap_q16 {
    int32_t angle, sharpness, weight;
} lobe_env_sg_tap_q16;

/* 1 tap: 164 operations, 24 coefficients; albedo max 6.22e-05, below .00174. Source: models/env_lobes1.h. */
void lobe_env_lobes1_f32(float roughness, float n_dot_v, lobe_env_tap_f32 taps[1]);
void lobe_env_lobes1_q30(int32_t roughness, int32_t n_dot_v, lobe_env_tap_q30 taps[1]);

/* 2 taps: 220 operations, 60 coefficients; albedo max 6.22e-05, below .00174. Source: models/env_lobes2.h. */
void lobe_env_lobes2_f32(float roughness, float n_dot_v, lobe_env_tap_f32 taps[2]);
void lobe_env_lobes2_q30(int32_t roughness, int32_t n_dot_v, lobe_env_tap_q30 taps[2]);

/* 4 taps: 332 operations, 132 coefficients; albedo max 6.22e-05, below .00174. Source: models/env_lobes4.h. */
void lobe_env_lobes4_f32(float roughness, float n_dot_v, lobe_env_tap_f32 taps[4]);
void lobe_env_lobes4_q30(int32_t roughness, int32_t n_dot_v, lobe_env_tap_q30 taps[4]);

/* 8 taps: 556 operations, 276 coefficients; albedo max 6.22e-05, below .00174. Source: models/env_lobes8.h. */
void lobe_env_lobes8_f32(float roughness, float n_dot_v, lobe_env_tap_f32 taps[8]);
void lobe_env_lobes8_q30(int32_t roughness, int32_t n_dot_v, lobe_env_tap_q30 taps[8]);

/* 1 tap: 163 operations, 24 coefficients; albedo max 6.22e-05, below .00174. Source: models/env_lobes_sg.h. */
void lobe_env_lobes_sg1_f32(float roughness, float n_dot_v, lobe_env_sg_tap_f32 taps[1]);
void lobe_env_lobes_sg1_q30(int32_t roughness, int32_t n_dot_v, lobe_env_sg_tap_q16 taps[1]);

/* 2 taps: 227 operations, 60 coefficients; albedo max 6.22e-05, below .00174. Source: models/env_lobes_sg.h. */
void lobe_env_lobes_sg2_f32(float roughness, float n_dot_v, lobe_env_sg_tap_f32 taps[2]);
void lobe_env_lobes_sg2_q30(int32_t roughness, int32_t n_dot_v, lobe_env_sg_tap_q16 taps[2]);

/* 4 taps: 300 operations, 96 coefficients; albedo max 6.22e-05, below .00174. Source: models/env_lobes_sg.h. */
void lobe_env_lobes_sg4_f32(float roughness, float n_dot_v, lobe_env_sg_tap_f32 taps[4]);
void lobe_env_lobes_sg4_q30(int32_t roughness, int32_t n_dot_v, lobe_env_sg_tap_q16 taps[4]);

/* 8 taps: 364 operations, 96 coefficients; albedo max 6.22e-05, below .00174. Source: models/env_lobes_sg.h. */
void lobe_env_lobes_sg8_f32(float roughness, float n_dot_v, lobe_env_sg_tap_f32 taps[8]);
void lobe_env_lobes_sg8_q30(int32_t roughness, int32_t n_dot_v, lobe_env_sg_tap_q16 taps[8]);

#endif
