/* Ground truth of sphere_light: the reflected radiance of a light of radiance 1 that fills the cone of half angle
 * sigma, under GGX with height-correlated Smith and Schlick's Fresnel with F90 = 1,
 *
 *   Lo = int over {l in the cone, l.z > 0} of D(h) G2(v, l) F(v.h) / (4 v.z) dl.
 *
 * n = z and v = (sin, 0, v_z); l_z is the height of the light's centre, azimuth its angle from the view's side: pi is
 * the mirror's side. alpha in [2.5e-3, 1], v_z in [1e-3, 1], l_z in [-1, 1], sigma in [1e-4, pi / 2]. tolerance is
 * relative; ask for [1e-8, 1e-3]: below that a rounding error is refined for minutes.
 *
 * Two integrators: over the directions of the cone, and over the normals. They share the rule of quadrature.h and
 * nothing else: other variables, other region, other horizon, other BRDF text. */
#ifndef LOBE_SPHERE_LIGHT_TRUTH_SPHERE_H
#define LOBE_SPHERE_LIGHT_TRUTH_SPHERE_H
#include <stddef.h>

typedef struct lobe_sphere_scene {
    double alpha, v_z, l_z, azimuth, sigma, f0;
} lobe_sphere_scene;

/* Over the directions, in polar coordinates about the light's axis. */
double lobe_truth_sphere_cone(const lobe_sphere_scene *s, double tolerance);

/* Over the normals, stretched so that GGX becomes a clamped cosine; the light is an elliptic cone there. */
double lobe_truth_sphere_stretched(const lobe_sphere_scene *s, double tolerance);

/* A punctual light of the same irradiance at normal incidence: 2 pi (1 - cos sigma) D V l.z. F0 counts as 1. */
double lobe_truth_sphere_punctual(const lobe_sphere_scene *s);

/* Irradiance over pi of the cone, clipped at the horizon: the diffuse part of the same light. */
double lobe_truth_sphere_irradiance(double l_z, double sigma, double tolerance);

/* D V F l.z, 0 below the horizon. */
double lobe_truth_sphere_brdf(double alpha, const double v[3], const double l[3], double f0);

/* A lobe_truth_fn: rows of roughness, n_dot_v, n_dot_l, azimuth, half angle; F0 = 1; stretched at 1e-8. */
void lobe_truth_sphere_rows(const double *in, double *out, size_t n);

/* The same through OpenCL, with the same bits; a lobe_truth_opencl_fn. */
int lobe_truth_sphere_opencl(const double *in, double *out, size_t n, char *error, size_t error_size);

#endif
