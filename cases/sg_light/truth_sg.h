/* Ground truth of sg_light: the reflected radiance of a spherical Gaussian of amplitude 1 about an axis, under GGX with
 * height-correlated Smith and F = 1,
 *
 *   Lo = int over {l.z > 0} of exp(sharpness (l.axis - 1)) D(h) G2(v, l) / (4 v.z) dl.
 *
 * n = z and v = (sin, 0, v_z); l_z is the height of the axis, azimuth its angle from the view's side: pi is the
 * mirror's side. alpha in [2.5e-3, 1], v_z in [1e-3, 1], l_z in [-1, 1], sharpness in [.25, 65536]. tolerance is
 * relative; ask for [1e-8, 1e-3]. At 1e-8 no scene
 * of 8000 had the first off by more, the second one of 4000, by 1e-7.
 *
 * Three integrators: over the directions about the axis; over the normals; and over sphere lights, of which the
 * Gaussian is a sum, exactly: exp(-s u) is the integral over e > u of s exp(-s e), u = 1 - l.axis, and the cone of
 * versine e is a sphere light. The first two share the rule of ../sphere_light/quadrature.h and nothing else: other
 * variables, other region, other horizon, other BRDF text. The third is a cross-check, a hundred times as slow. */
#ifndef LOBE_SG_LIGHT_TRUTH_SG_H
#define LOBE_SG_LIGHT_TRUTH_SG_H
#include <stddef.h>

typedef struct lobe_sg_scene {
    double alpha, v_z, l_z, azimuth, sharpness;
} lobe_sg_scene;

/* Over the directions, in polar coordinates about the axis. */
double lobe_truth_sg_axis(const lobe_sg_scene *s, double tolerance);

/* Over the normals, stretched so that GGX becomes a clamped cosine, in elliptic coordinates about the stretched half
 * vector of view and axis. */
double lobe_truth_sg_stretched(const lobe_sg_scene *s, double tolerance);

/* As a sum of sphere lights. */
double lobe_truth_sg_cones(const lobe_sg_scene *s, double tolerance);

/* A punctual light of the same irradiance at normal incidence: 2 pi / sharpness (1 - exp(-2 sharpness)) D V l.z. */
double lobe_truth_sg_punctual(const lobe_sg_scene *s);

/* Irradiance over pi, int exp(sharpness (l.axis - 1)) max(l.z, 0) / pi dl: the diffuse part of the same light. */
double lobe_truth_sg_irradiance(double l_z, double sharpness, double tolerance);

/* A lobe_truth_fn: rows of roughness, n_dot_v, n_dot_l, azimuth, sharpness; over the directions at 1e-8. */
void lobe_truth_sg_rows(const double *in, double *out, size_t n);

#endif
