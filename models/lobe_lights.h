/* A part of lobe.h, which includes it. */
#ifndef LOBE_LIGHTS_H
#define LOBE_LIGHTS_H
#include "lobe.h"

/* Sphere lights
 * -------------
 * What GGX (height-correlated Smith, F = 1) reflects towards the view of a sphere of radiance 1, clipped at the
 * horizon, in [0, 1]; multiply it with the light's radiance. Compute the light once a point: every tier takes it.
 *   n_dot_v, n_dot_l   heights of view and of the direction to the centre; [0, 1] and [-1, 1]
 *   tangent2           squared length of the part of (view + to_light) / 2 along the surface, [0, 1]: what tells a
 *                      narrow lobe from a mirror. From the two heights it is lost to rounding
 *   sine, versine      sin and 1 - cos of the half angle, [0, 1]; the sphere of radius r at distance d has sine r / d
 * An input out of its range is clamped to it, NaN counts as the lower end, roughness has at least an alpha of 1e-3 and
 * the sine at least 1e-5. The domain is roughness in [.22, 1], n_dot_v in [.08, 1], n_dot_l in [-1, 1], sine in
 * (0, .7072], half angles to 45 degrees.
 *   cells        relative L2 error over the light's positions, of scenes that no fit has seen, root of the mean square
 *   max, rms     of the radiance, absolute, with the place as (roughness, n_dot_v, n_dot_l, tangent2, sine). The
 *                largest are of wide lights at or through the horizon, at grazing views of the smoothest surfaces
 *   below        the same where an input is out of the domain: roughness from .05, n_dot_v from .001, sine up to 1
 *   operations   beyond what the punctual light costs
 * Rounding adds 2e-5, below a degree 2e-5 of the result. At a hundredth of a degree a light above the horizon is within
 * 1e-3 of the punctual one for views to 85 degrees. */
typedef struct lobe_sphere_f32 {
    float n_dot_v, n_dot_l, tangent2, sine, versine;
} lobe_sphere_f32;
typedef struct lobe_sphere_q30 {
    int32_t n_dot_v, n_dot_l, tangent2, sine;
} lobe_sphere_q30;

/* The light of a sphere. normal and view (towards the eye) are unit vectors, components held at [-1, 1]; to_centre goes
 * from the point to the middle of the sphere, components held at [-1e18, 1e18], in the same unit as radius, held at
 * [0, 1e18]; NaN counts as the lower end of each. n.view below 0 counts as 0. A point inside the sphere counts as on
 * it, half angle 90 degrees, and a distance below 1e-15 as 1e-15: a zero vector has heights 0. Error of sine and
 * versine 2^-22 relative, of the heights 3e-7, of tangent2 6e-7 times its root and 1e-13. 69 operations, of which 22
 * are clamps. */
lobe_sphere_f32 lobe_sphere_seen_f32(lobe_vec3_f32 normal, lobe_vec3_f32 view, lobe_vec3_f32 to_centre, float radius);

/* The light of numbers that are known already: versine is sine^2 / (1 + sqrt(1 - sine^2)), which keeps its digits where
 * 1 - cos has none. sine is held at [0, 1], the others go through. Relative error of versine 2^-22. 11 operations. */
lobe_sphere_f32 lobe_sphere_of_f32(float n_dot_v, float n_dot_l, float tangent2, float sine);

/* The point moves by a ratio of two sums. Cells 0.122, views to 60 degrees 0.0758, from 75 on 0.182; energy of the
 * worst cell 0.241, over 200 uniform positions 0.405; where sine < alpha / 2 at most 0.000915 worse than a punctual
 * light. max 0.805 at (0.22, 0.148, 0.1289, 0.134, 0.7072), rms 0.0251; below 1. 19 operations. A light that has set
 * gives exactly 0. Source: models/sphere_light.h. */
float lobe_sphere_light_low_f32(float roughness, lobe_sphere_f32 light);

/* The point moves, and the lobe bends to a plateau. Cells 0.0903, views to 60 degrees 0.0611, from 75 on 0.131;
 * energy of the worst cell 0.146, over 200 uniform positions 0.273; where sine < alpha / 2 at most 0.00381 worse than a
 * punctual light. max 0.749 at (0.22, 0.1245, -0.4948, 0.003795, 0.7072), rms 0.0193; below 1. 40 operations. A light
 * that has set gives exactly 0. Source: models/sphere_light.h. */
float lobe_sphere_light_medium_f32(float roughness, lobe_sphere_f32 light);

/* The stretched light in closed form. Cells 0.0323, views to 60 degrees 0.011, from 75 on 0.0544; energy of the worst
 * cell 0.127; never worse than a punctual light where sine < alpha / 2. max 0.201 at (0.3624, 0.08, 0.1468,
 * 1.478e-05, 0.7072), rms 0.0117; below 0.973. 97 operations. A light that has set gives at most .02; beyond the
 * domain, at grazing views of a large one, up to .95. Source: cases/sphere_light/README.md. */
float lobe_sphere_light_high_f32(float roughness, lobe_sphere_f32 light);

/* Under Schlick's Fresnel of reflectance f0 at normal incidence the light is
 *   radiance * (f0 + (1 - f0) * schlick),
 * where schlick, in [0, 1], is (1 - v.h)^5 in the mean over what is reflected: one number for every f0, so that a
 * coloured one costs a multiply and an add a channel. That of the light's centre instead would add 22 to 29 points to
 * the error over the cells at f0 = .02. Errors of schlick are absolute, where the light gives at least .01: it matters
 * little beside an f0, and is least exact where a light has all but set. */
typedef struct lobe_sphere_lit_f32 {
    float radiance, schlick;
} lobe_sphere_lit_f32;

/* high, to the last bit, and its schlick, fitted together. Over the cells the error rises by at most 0.0, 0.1, 0.5
 * and 0.9 points for f0 = .5, .1, .04 and .02: never by more than one. schlick: max 0.366 at (0.8426, 0.08, -0.577,
 * 0.008154, 0.6974), rms 0.0212; below 0.766. 43 operations beyond high. Source: cases/sphere_light/README.md. */
lobe_sphere_lit_f32 lobe_sphere_light_high_lit_f32(float roughness, lobe_sphere_f32 light);

/* The schlick for low and medium, which does not need their radiance. Over the cells low's error rises by at most
 * 0.2, 0.9, 1.4 and 1.7 points for f0 = .5, .1, .04 and .02, medium's by 0.0, 0.3, 1.0 and 1.9 points. max 0.403 at
 * (0.7585, 0.08, -0.5858, 0.008919, 0.6902), rms 0.0253; below 0.609. 33 operations, some 20 more than for the
 * light's centre. Source: models/sphere_light_schlick.h. */
float lobe_sphere_light_schlick_f32(float roughness, lobe_sphere_f32 light);

/* A punctual light of the same irradiance at normal incidence, pi sine^2 for a small one (2 pi versine): what every
 * tier tends to as the light shrinks, and the unit of cost. At least 0, and finite: a mirror in the sun exceeds 1.
 * Rounding 1e-6 of the result. */
float lobe_sphere_light_punctual_f32(float roughness, lobe_sphere_f32 light);

/* Arrays: the light of element i is lobe_sphere_of_f32(n_dot_v[i], n_dot_l[i], tangent2[i], sine[i]). */
void lobe_sphere_light_low_n_f32(const float *roughness, const float *n_dot_v, const float *n_dot_l,
                                 const float *tangent2, const float *sine, float *radiance, size_t n);
void lobe_sphere_light_medium_n_f32(const float *roughness, const float *n_dot_v, const float *n_dot_l,
                                    const float *tangent2, const float *sine, float *radiance, size_t n);
void lobe_sphere_light_high_n_f32(const float *roughness, const float *n_dot_v, const float *n_dot_l,
                                  const float *tangent2, const float *sine, float *radiance, size_t n);
void lobe_sphere_light_high_lit_n_f32(const float *roughness, const float *n_dot_v, const float *n_dot_l,
                                      const float *tangent2, const float *sine, float *radiance, float *schlick,
                                      size_t n);
void lobe_sphere_light_schlick_n_f32(const float *roughness, const float *n_dot_v, const float *n_dot_l,
                                     const float *tangent2, const float *sine, float *schlick, size_t n);
void lobe_sphere_light_punctual_n_f32(const float *roughness, const float *n_dot_v, const float *n_dot_l,
                                      const float *tangent2, const float *sine, float *radiance, size_t n);

/* The same in integers, with a block exponent (lobe_scaled_q30). Inputs are held as above.
 * Within 2^-20 of the peak of the same formula in double, over the domain and to half angles of 90 degrees, the peak
 * being the largest result over the light's positions; down to roughness .05 and n_dot_v .02 within 2^-16. The tiers
 * are at most 1; punctual is unbounded. */
lobe_scaled_q30 lobe_sphere_light_low_q30(int32_t roughness, lobe_sphere_q30 light);
lobe_scaled_q30 lobe_sphere_light_medium_q30(int32_t roughness, lobe_sphere_q30 light);
lobe_scaled_q30 lobe_sphere_light_high_q30(int32_t roughness, lobe_sphere_q30 light);
lobe_scaled_q30 lobe_sphere_light_punctual_q30(int32_t roughness, lobe_sphere_q30 light);

/* schlick is Q30, within 2^-20 of the formula in double; radiance is that of lobe_sphere_light_high_q30. */
typedef struct lobe_sphere_lit_q30 {
    lobe_scaled_q30 radiance;
    int32_t schlick;
} lobe_sphere_lit_q30;
lobe_sphere_lit_q30 lobe_sphere_light_high_lit_q30(int32_t roughness, lobe_sphere_q30 light);
int32_t lobe_sphere_light_schlick_q30(int32_t roughness, lobe_sphere_q30 light);

/* Capsule lights
 * --------------
 * The same of a capsule, the points nearer than radius to a segment: a tube with round ends, of radiance 1. Compute the
 * light once a point: every tier takes it. It stands in the frame of the surface, the point at the origin, z along the
 * normal, x along the part of the view in the surface; lengths are in any unit.
 *   middle, arm   the middle of the segment, and from there to one of its ends; an arm of zero is a sphere
 *   radius        at least 0
 * Components are held at [-1e15, 1e15]; NaN counts as the lower end of each input. Radiance is in [0, 1] for every
 * input, also of a point inside the capsule. The domain is roughness in [.22, 1], n_dot_v in [.08, 1], a middle at the
 * distance 1, an arm to 1 whose line passes no nearer than .2 and 1.5 radii, a radius to .5.
 *   cells        as of sphere lights; a representative point as published is 0.812 wrong there
 *   max, rms     of the radiance, absolute, with the place as (roughness, n_dot_v, middle, arm, radius). The largest
 * are of lights that half cover the mirror direction of the smoothest surfaces below        the same where an input is
 * out of the domain: roughness from .05, n_dot_v from .001, radius to .9 operations   beyond what a punctual light
 * costs; the published one takes 115 Rounding adds 2e-5. Without a length each is the sphere of its tier. */
typedef struct lobe_capsule_f32 {
    float n_dot_v;
    lobe_vec3_f32 middle, arm;
    float radius;
} lobe_capsule_f32;

/* The light of a capsule. normal and view (towards the eye) are unit vectors, components held at [-1, 1]; to_end0 and
 * to_end1 go from the point to the ends of the segment, in the unit of radius. Error of the components 5e-7 of the
 * longer of the two where the view leans from the normal by .01 or more; the frame turns by up to 3e-7 over that lean.
 */
lobe_capsule_f32 lobe_capsule_seen_f32(lobe_vec3_f32 normal, lobe_vec3_f32 view, lobe_vec3_f32 to_end0,
                                       lobe_vec3_f32 to_end1, float radius);

/* The sphere nearest to the mirror direction, times a part of the line. Cells 0.242, views to 60 degrees 0.166, from 75
 * on 0.324; energy of the worst cell 0.364. max 0.954 at (0.22, 0.2672, (-0.9345, -0.3365, -0.1164), (-0.4641, 0.0713,
 * -0.5183), 0.4937), rms 0.0381; below 0.999. 193 operations. Source: models/capsule_light.h. */
float lobe_capsule_light_low_f32(float roughness, lobe_capsule_f32 light);

/* The lobe's integral along the line, at its centre of gravity. Cells 0.11, views to 60 degrees 0.0656, from 75 on
 * 0.153; energy of the worst cell 0.128. max 0.905 at (0.22, 0.1614, (-0.7001, 0.3458, 0.6248), (-0.8721, 0.0664,
 * -0.4846), 0.5), rms 0.0249; below 0.994. 363 operations. Source: cases/capsule_light/README.md. */
float lobe_capsule_light_medium_f32(float roughness, lobe_capsule_f32 light);

/* The same on the sphere's closed form. Cells 0.087, views to 60 degrees 0.0507, from 75 on 0.123; energy of the worst
 * cell 0.138. max 0.945 at (0.2201, 0.2361, (-0.836, 0.3309, 0.4377), (0.9134, -0.1463, 0.3796), 0.5), rms 0.0204;
 * below 0.999. 420 operations. Source: cases/capsule_light/README.md. */
float lobe_capsule_light_high_f32(float roughness, lobe_capsule_f32 light);

/* The same in integers with a block exponent. roughness and n_dot_v are Q30; middle, arm and radius are integers of any
 * one unit, Q16.16 metres as well as Q30, since nothing depends on it: only their last place is lost. */
typedef struct lobe_capsule_q30 {
    int32_t n_dot_v;
    lobe_vec3_q30 middle, arm;
    int32_t radius;
} lobe_capsule_q30;
lobe_scaled_q30 lobe_capsule_light_low_q30(int32_t roughness, lobe_capsule_q30 light);
lobe_scaled_q30 lobe_capsule_light_medium_q30(int32_t roughness, lobe_capsule_q30 light);
lobe_scaled_q30 lobe_capsule_light_high_q30(int32_t roughness, lobe_capsule_q30 light);

/* Diffuse under sphere lights
 * ---------------------------
 * Irradiance over pi of a sphere of radiance 1, clipped at the horizon, in [0, 1]: times the light's radiance and the
 * base colour it is what Lambert reflects. It takes the place of a punctual light's sine^2 saturate(n_dot_l), which
 * every tier gives exactly where the whole light is up, n_dot_l >= sine; where all of it is down it is 0.
 *   n_dot_l   cosine between normal and the direction to the centre, [-1, 1]; NaN counts as -1
 *   sine      radius / distance, the sine of the half angle, [0, 1]; NaN counts as 0
 * No result falls while n_dot_l rises, but for rounding. max and rms are absolute, in f32; "of sine^2" is the largest
 * part of what the light gives overhead, in both formats. */

/* max 0.00765 at (.8849, .9899), rms 0.00202; of sine^2 .00781. 20 operations: one root, no division. Source:
 * cases/sphere_diffuse. */
float lobe_sphere_diffuse_low_f32(float n_dot_l, float sine);

/* max 0.000544 at (.8145, .9973), rms 0.000187; of sine^2 .00055. 40 operations: no arc function. Source:
 * cases/sphere_diffuse. */
float lobe_sphere_diffuse_medium_f32(float n_dot_l, float sine);

/* The closed form. max 1.54e-07 at (.9649, .9887), rms 1.66e-08; of sine^2 1.71e-7, at every size. 87 operations.
 * Source: Snyder 1996; cases/sphere_diffuse. */
float lobe_sphere_diffuse_exact_f32(float n_dot_l, float sine);

void lobe_sphere_diffuse_low_n_f32(const float *n_dot_l, const float *sine, float *irradiance, size_t n);
void lobe_sphere_diffuse_medium_n_f32(const float *n_dot_l, const float *sine, float *irradiance, size_t n);
void lobe_sphere_diffuse_exact_n_f32(const float *n_dot_l, const float *sine, float *irradiance, size_t n);

/* The same in integers with a block exponent, inputs Q30: within 2^-26 of sine^2 of the same formula, however small the
 * light. */
lobe_scaled_q30 lobe_sphere_diffuse_low_q30(int32_t n_dot_l, int32_t sine);
lobe_scaled_q30 lobe_sphere_diffuse_medium_q30(int32_t n_dot_l, int32_t sine);
lobe_scaled_q30 lobe_sphere_diffuse_exact_q30(int32_t n_dot_l, int32_t sine);

/* A sphere of radiance 1 as nine coefficients of lighting, in the convention of diffuse_sh. direction is the unit
 * vector from the point to the centre, components held at [-1, 1], NaN counts as -1. Coefficient 0 is at most 1.78, the
 * others 1.54. Error at most 4e-7 pi sine^2; q30: 6e-9. 38 operations, of which 6 are clamps. */
lobe_sh9_f32 lobe_sphere_sh_f32(float sine, lobe_vec3_f32 direction);
lobe_sh9_q30 lobe_sphere_sh_q30(int32_t sine, lobe_vec3_q30 direction);

/* Adds a sphere of that radiance, red, green and blue in x, y and z, to the lighting: lobe_diffuse_sh_radiance_* then
 * gives Burley's diffuse under any number of lights. Order 3 blurs: relative rms 8.7 % for a light of half angle 1
 * degree, 3.6 % at 30, 1.1 % at 45 and less above; for one light below 28 degrees pi times lobe_sphere_diffuse times
 * the BRDF at its centre is better (cases/sphere_diffuse). Radiance below 0 and NaN count as 0; the lighting is held at
 * +-3.4e38, where a NaN becomes the lower end. 38 operations and 29 a channel, of which 20 are clamps. q16: radiance
 * and lighting are Q16.16, held at the ends; error at most 1 unit and 6e-9 of the radiance. */
void lobe_lighting_add_sphere_f32(lobe_lighting_f32 *lighting, lobe_vec3_f32 radiance, float sine,
                                  lobe_vec3_f32 direction);
void lobe_lighting_add_sphere_q16(lobe_lighting_q16 *lighting, lobe_vec3_q16 radiance, int32_t sine_q30,
                                  lobe_vec3_q30 direction);

#endif
