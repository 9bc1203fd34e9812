/* A part of lobe.h, which includes it. */
#ifndef LOBE_SG_H
#define LOBE_SG_H
#include "lobe.h"

/* Lights that are spherical Gaussians
 * -----------------------------------
 * What GGX (height-correlated Smith, F = 1) reflects towards the view of a light exp(sharpness (l.axis - 1)) of
 * amplitude 1, clipped at the horizon, in [0, 1]; multiply it with the light's amplitude. Compute the light once a
 * point: every tier takes it.
 *   n_dot_v, n_dot_l   heights of view and of the axis; [0, 1] and [-1, 1]
 *   tangent2           squared length of the part of (view + axis) / 2 along the surface, [0, 1], as for sphere lights
 *   versine            1 / sharpness, (0, 1]: the light's irradiance at normal incidence is 2 pi versine, as that of a
 *                      sphere light of this versine is
 * An input out of its range is clamped to it, NaN counts as the lower end, roughness has at least an alpha of 1e-3 and
 * versine at least 1e-6. The domain is roughness in [.22, 1], n_dot_v in [.05, 1], n_dot_l in [-1, 1], versine in
 * [1/4096, 1/4], sharpness 4 to 4096.
 *   cells        relative L2 error over the axis's positions, of scenes that no fit has seen, root of the mean square;
 *                smooth: where alpha <= .25 and n_dot_v >= .4
 *   max, rms     of the radiance, absolute, with the place as (roughness, n_dot_v, n_dot_l, tangent2, versine)
 *   below        the same where an input is out of the domain: roughness from .05, n_dot_v from .001, versine from
 *                2^-16 to 1
 *   operations   beyond what the punctual light costs
 * As the light shrinks every tier tends to lobe_sphere_light_punctual of the same versine. */
typedef struct lobe_sg_f32 {
    float n_dot_v, n_dot_l, tangent2, versine;
} lobe_sg_f32;
typedef struct lobe_sg_q30 {
    int32_t n_dot_v, n_dot_l, tangent2, versine;
} lobe_sg_q30;

/* The light of an axis. normal, view (towards the eye) and axis (towards the light) are unit vectors, components held
 * at [-1, 1]; sharpness is held at [1, 1e6]; NaN counts as the lower end of each. n.view below 0 counts as 0. View on
 * the normal is no exception, nor is view on the axis. 42 operations, of which 22 are clamps. */
lobe_sg_f32 lobe_sg_seen_f32(lobe_vec3_f32 normal, lobe_vec3_f32 view, lobe_vec3_f32 axis, float sharpness);

/* Powers in place of Gaussians, no exponential. Cells 0.137, smooth 0.101. max 0.408 at (.22, .1074, .00284, 8.3e-6,
 * .0337), rms 0.016; below 0.752. 17 operations. A light that has set, by six widths, gives at most .02. Source:
 * models/sg_light.h. */
float lobe_sg_light_low_f32(float roughness, lobe_sg_f32 light);

/* Light and lobe as Gaussians of half vectors, one width, that of the t that counts. Cells 0.102, smooth 0.0597. max
 * 0.165 at (.3957, .0618, -.0912, 1.3e-6, .1024), rms 0.0119; below 0.59. 40 operations. A light that has set, by six
 * widths, gives at most .02. Source: models/sg_light.h. */
float lobe_sg_light_medium_f32(float roughness, lobe_sg_f32 light);

/* Two widths, and a round corner at the horizon. Cells 0.0647, smooth 0.0431. max 0.144 at (.2676, .05, .1229, 1e-5,
 * .25), rms 0.007; below 0.804. 105 operations. A light that has set, by six widths, gives at most .02. Source:
 * models/sg_light_high.h, derived in cases/sg_light/README.md. */
float lobe_sg_light_high_f32(float roughness, lobe_sg_f32 light);

/* Arrays: the light of element i is {n_dot_v[i], n_dot_l[i], tangent2[i], versine[i]}. */
void lobe_sg_light_low_n_f32(const float *roughness, const float *n_dot_v, const float *n_dot_l, const float *tangent2,
                             const float *versine, float *radiance, size_t n);
void lobe_sg_light_medium_n_f32(const float *roughness, const float *n_dot_v, const float *n_dot_l,
                                const float *tangent2, const float *versine, float *radiance, size_t n);
void lobe_sg_light_high_n_f32(const float *roughness, const float *n_dot_v, const float *n_dot_l, const float *tangent2,
                              const float *versine, float *radiance, size_t n);

/* The same in integers, with a block exponent as for sphere lights. Inputs are held as above. Within 2^-21 of the same
 * formula in double over the domain. */
lobe_scaled_q30 lobe_sg_light_low_q30(int32_t roughness, lobe_sg_q30 light);
lobe_scaled_q30 lobe_sg_light_medium_q30(int32_t roughness, lobe_sg_q30 light);
lobe_scaled_q30 lobe_sg_light_high_q30(int32_t roughness, lobe_sg_q30 light);

/* Diffuse under them
 * ------------------
 * Irradiance over pi of amplitude 1, clipped at the horizon; times the light's amplitude and the base colour it is what
 * Lambert reflects. n_dot_l is the height of the axis, [-1, 1], versine 1 / sharpness, (0, 2]; each is held there,
 * versine at least at 1e-6; NaN counts as the lower end. The domain is n_dot_l in [-1, 1], versine in [1/4096, 1];
 * beyond is versine to 2. max and rms are absolute, in f32; "overhead" is the largest part of what the same light
 * gives overhead, in both formats. */

/* max .00249 at (1, .3856), beyond .00238, rms .000412; overhead .00501. 44 operations. Within 2^-23 of
 * what the light gives overhead of the same formula in double, in q30. Source: models/sg_diffuse.h. */
float lobe_sg_diffuse_high_f32(float n_dot_l, float versine);
lobe_scaled_q30 lobe_sg_diffuse_high_q30(int32_t n_dot_l, int32_t versine);
void lobe_sg_diffuse_high_n_f32(const float *n_dot_l, const float *versine, float *irradiance, size_t n);

/* The same as an inner product with a Gaussian that stands for the cosine, for comparison: max .0561, rms .012;
 * overhead .17, where the light is narrow. 41 operations. */
float lobe_sg_diffuse_inner_f32(float n_dot_l, float versine);

#endif
