/* A part of lobe.h, which includes it. */
#ifndef LOBE_ENV_H
#define LOBE_ENV_H
#include "lobe.h"

/* Environment specular
 * --------------------
 * What GGX (height-correlated Smith, F = 1) reflects of an environment, as 1 to 8 taps into a prefiltered one:
 * the colour is the sum of weight * prefiltered(direction, width). All taps stand in the plane of view and normal:
 *   angle    from the normal, in radians, positive away from the view, so the direction is
 *            cos(angle) normal - sin(angle) t, with t the unit vector along view - n_dot_v normal; where there is none,
 *            at n_dot_v = 1, every angle is 0. It may pass pi/2: a prefiltered map answers there too
 *   weight   may be negative: a narrow lobe less what spills under the horizon. The weights sum to the albedo
 *            lobe_energy_high, so a white furnace is right by construction: within 7.6e-5 where roughness and
 *            n_dot_v are in [.02, 1], .0018 below. Fresnel: lobe_env_fresnel_f32
 * and of width there are two kinds, by what the environment was prefiltered with:
 *   lobe_env_lobes      the ordinary split-sum prefilter. width is its roughness, [0, 1], by which an engine picks a
 *                       mip; kernel max(0, c) / (1 + k (1 - c))^2, c the cosine to the tap,
 *                       k = (1 / width^4 - 1) / 2
 *   lobe_env_lobes_sg   spherical Gaussians. The kernel is exp(sharpness (c - 1)), normalised over the sphere; under
 *                       roughness .1 the sharpness stays what it is there
 *
 * All are smooth in both inputs. Both inputs are clamped to [0, 1], which is the domain; NaN counts as 0. Operations
 * include 77 for the albedo, which the kernels in models/env_lobes*.h take from whoever has one.
 *
 * How good they are as pictures: errors of radiance and, in brackets, as a part of the error of the split sum, which is
 * one tap in the mirror direction, in the same run. Over alpha .04 to 1 and n_dot_v .05 to 1, under nine environments
 * that no fit has seen; then the worst of those. relative: |model - truth| / truth, rms; rms: rms error over rms truth
 * over all orientations. Source: cases/env_lobes/front.csv.
 *                   relative    worst          part, worst         rms         worst          part, worst
 *   split sum       1.199       2.49 sky 101                       .393        .566 sky 101
 *   lobes  1 tap    .228 (.19)  .360 lamps 102 (.71) checker 101   .258 (.66)  .383 sky.hdr   (1.00) checker 101
 *          2 taps   .158 (.13)  .255 sky 101   (.45) checker 101   .168 (.43)  .271 sky.hdr   (.82) checker 101
 *          4 taps   .095 (.08)  .150 sky 101   (.33) checker 101   .117 (.30)  .201 sky.hdr   (.78) checker 101
 *          8 taps   .061 (.05)  .110 sky 101   (.16) checker 101   .067 (.17)  .119 sky.hdr   (.74) checker 101
 *          adaptive .118 (.10)  .183 lamps 102 (.43) checker 101   .157 (.40)  .243 sky.hdr   (.82) checker 101
 *   sg     1 tap    .388 (.32)  .686 sky 101   (.68) checker 101   .235 (.60)  .363 sky.hdr   (.67) sky.hdr
 *          2 taps   .228 (.19)  .409 sky 101   (.46) checker 101   .161 (.41)  .269 sky.hdr   (.50) sky.hdr
 *          4 taps   .236 (.20)  .451 sky 101   (.24) lamps 102    .096 (.25)  .170 sky.hdr   (.31) sky.hdr
 *          8 taps   .206 (.17)  .402 sky 101   (.22) workshop.hdr  .081 (.21)  .131 sky.hdr   (.24) sky.hdr
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

/* 1 tap: 164 operations, 24 coefficients; albedo max 5.22e-05, below .00173. Source: models/env_lobes1.h. */
void lobe_env_lobes1_f32(float roughness, float n_dot_v, lobe_env_tap_f32 taps[1]);
void lobe_env_lobes1_q30(int32_t roughness, int32_t n_dot_v, lobe_env_tap_q30 taps[1]);

/* 2 taps: 220 operations, 60 coefficients; albedo max 5.22e-05, below .00173. Source: models/env_lobes2.h. */
void lobe_env_lobes2_f32(float roughness, float n_dot_v, lobe_env_tap_f32 taps[2]);
void lobe_env_lobes2_q30(int32_t roughness, int32_t n_dot_v, lobe_env_tap_q30 taps[2]);

/* 4 taps: 332 operations, 132 coefficients; albedo max 5.23e-05, below .00173. Source: models/env_lobes4.h. */
void lobe_env_lobes4_f32(float roughness, float n_dot_v, lobe_env_tap_f32 taps[4]);
void lobe_env_lobes4_q30(int32_t roughness, int32_t n_dot_v, lobe_env_tap_q30 taps[4]);

/* 8 taps: 556 operations, 276 coefficients; albedo max 5.22e-05, below .00173. Source: models/env_lobes8.h. */
void lobe_env_lobes8_f32(float roughness, float n_dot_v, lobe_env_tap_f32 taps[8]);
void lobe_env_lobes8_q30(int32_t roughness, int32_t n_dot_v, lobe_env_tap_q30 taps[8]);

/* The same fans from bilinear tables of 16 x 16 nodes, fitted for themselves: fewer operations, and with 4 and 8 taps
 * nearer to the truth; continuous, with kinks along the nodes. f32 and q30 read the same integers; as textures:
 * models/env_lobes_table.h. A table is linked only where it is named.
 *   taps  bytes   operations  numbers read  radiance error, of the split sum's; closed form
 *   1     1024    134         4 x 2         .191; .190
 *   2     2560    151         4 x 5         .131; .132
 *   4     5632    183         4 x 11        .076; .079
 *   8     11776   247         4 x 23        .045; .051
 * Albedo max 5.22e-05, below .00173. f32 differs from the same lookup in double by at most 1e-4 in an angle and 4e-5
 * in width and weight; q30 as above. Source: cases/env_lobes/table_fit.c. */
enum { LOBE_ENV_TABLE16_SIDE = 16 };
void lobe_env_lobes1_table16_f32(float roughness, float n_dot_v, lobe_env_tap_f32 taps[1]);
void lobe_env_lobes1_table16_q30(int32_t roughness, int32_t n_dot_v, lobe_env_tap_q30 taps[1]);
void lobe_env_lobes2_table16_f32(float roughness, float n_dot_v, lobe_env_tap_f32 taps[2]);
void lobe_env_lobes2_table16_q30(int32_t roughness, int32_t n_dot_v, lobe_env_tap_q30 taps[2]);
void lobe_env_lobes4_table16_f32(float roughness, float n_dot_v, lobe_env_tap_f32 taps[4]);
void lobe_env_lobes4_table16_q30(int32_t roughness, int32_t n_dot_v, lobe_env_tap_q30 taps[4]);
void lobe_env_lobes8_table16_f32(float roughness, float n_dot_v, lobe_env_tap_f32 taps[8]);
void lobe_env_lobes8_table16_q30(int32_t roughness, int32_t n_dot_v, lobe_env_tap_q30 taps[8]);
extern const int16_t lobe_env_lobes1_table16_i16[2 * LOBE_ENV_TABLE16_SIDE * LOBE_ENV_TABLE16_SIDE];
extern const int16_t lobe_env_lobes2_table16_i16[5 * LOBE_ENV_TABLE16_SIDE * LOBE_ENV_TABLE16_SIDE];
extern const int16_t lobe_env_lobes4_table16_i16[11 * LOBE_ENV_TABLE16_SIDE * LOBE_ENV_TABLE16_SIDE];
extern const int16_t lobe_env_lobes8_table16_i16[23 * LOBE_ENV_TABLE16_SIDE * LOBE_ENV_TABLE16_SIDE];

/* 1 to 6 taps, as many as the point needs: returns how many to read, 2.2 in the mean over a uniform square of roughness
 * and n_dot_v. A tap comes in with weight 0, so the colour is continuous; those that are not read have weight 0 and the
 * first's angle and width. Radiance error .089 of the split sum's, where 4 taps have .079; in q30 a weight is within
 * 2^-14. 572 operations, 304 coefficients; albedo max 5.22e-05, below .00173. Source: models/env_lobes_adaptive.h. */
int lobe_env_lobes_adaptive_f32(float roughness, float n_dot_v, lobe_env_tap_f32 taps[6]);
int lobe_env_lobes_adaptive_q30(int32_t roughness, int32_t n_dot_v, lobe_env_tap_q30 taps[6]);

/* 1 tap: 163 operations, 24 coefficients; albedo max 5.22e-05, below .00173. Source: models/env_lobes_sg.h. */
void lobe_env_lobes_sg1_f32(float roughness, float n_dot_v, lobe_env_sg_tap_f32 taps[1]);
void lobe_env_lobes_sg1_q30(int32_t roughness, int32_t n_dot_v, lobe_env_sg_tap_q16 taps[1]);

/* 2 taps: 227 operations, 60 coefficients; albedo max 5.22e-05, below .00173. Source: models/env_lobes_sg.h. */
void lobe_env_lobes_sg2_f32(float roughness, float n_dot_v, lobe_env_sg_tap_f32 taps[2]);
void lobe_env_lobes_sg2_q30(int32_t roughness, int32_t n_dot_v, lobe_env_sg_tap_q16 taps[2]);

/* 4 taps: 300 operations, 96 coefficients; albedo max 5.21e-05, below .00173. Source: models/env_lobes_sg.h. */
void lobe_env_lobes_sg4_f32(float roughness, float n_dot_v, lobe_env_sg_tap_f32 taps[4]);
void lobe_env_lobes_sg4_q30(int32_t roughness, int32_t n_dot_v, lobe_env_sg_tap_q16 taps[4]);

/* 8 taps: 364 operations, 96 coefficients; albedo max 5.22e-05, below .00173. Source: models/env_lobes_sg.h. */
void lobe_env_lobes_sg8_f32(float roughness, float n_dot_v, lobe_env_sg_tap_f32 taps[8]);
void lobe_env_lobes_sg8_q30(int32_t roughness, int32_t n_dot_v, lobe_env_sg_tap_q16 taps[8]);

/* Schlick's Fresnel for taps of env_lobes, as those functions return them: which part of every tap is f90's. The rest
 * is f0's, so a colour is the sum of (f0 (weight - tap_bias) + f90 tap_bias) prefiltered(direction, width), held at 0
 * from below.
 *   v_dot_tap   cosine between view and tap, held at [-1, 1], NaN counts as -1: cos(acos(n_dot_v) + angle)
 *   bias        of a split sum at the same point, held at [0, 1]; tap_bias sums to it
 *   tap_bias    n numbers, Q16.16 in q30, as weights are. They differ from the formula in double by at most 4e-5 in f32
 *               and 2^-14 in q30; under n_dot_v .02, where view and tap are opposite, by .004 and 2^-9. Their sum is
 *               the bias within 4e-6 in f32, exactly in q30
 * 23 operations a tap and 7. Source: models/env_fresnel.h. At f0 .04 the radiance error of 2, 4 and 8 taps is .187,
 * .147 and .142 (at F = 1 .158, .095 and .061); with the one factor (f0 scale + f90 bias) / (scale + bias) on
 * all taps it is .304, .293 and .266. 1 tap has nothing but that factor, .300, and env_lobes_sg is not judged here. */
void lobe_env_fresnel_f32(const lobe_env_tap_f32 *taps, const float *v_dot_tap, size_t n, float bias, float *tap_bias);
void lobe_env_fresnel_q30(const lobe_env_tap_q30 *taps, const int32_t *v_dot_tap, size_t n, int32_t bias,
                          int32_t *tap_bias_q16);

#endif
