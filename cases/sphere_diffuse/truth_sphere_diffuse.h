/* Ground truth of sphere_diffuse: irradiance over pi of a light of radiance 1 that fills the cone of half angle
 * asin(sine) about a direction of height n_dot_l, clipped at the horizon:
 *
 *   E / pi = (1 / pi) int over {l in the cone, l.z > 0} of l.z dl.
 *
 * n_dot_l in [-1, 1], sine in [0, 1]. Two ways that share nothing: a closed form, and quadrature over the heights. */
#ifndef LOBE_TRUTH_SPHERE_DIFFUSE_H
#define LOBE_TRUTH_SPHERE_DIFFUSE_H
#include <stddef.h>

/* After Snyder 1996; within 2e-15 sine^2 of the integral. */
double lobe_truth_sphere_diffuse(double n_dot_l, double sine);

/* By quadrature, to this part of sine^2; sine at least 1e-4. tolerance in [1e-13, 1e-3]. */
double lobe_truth_sphere_diffuse_heights(double n_dot_l, double sine, double tolerance);

/* A lobe_truth_fn: rows of n_dot_l and sine, the closed form. */
void lobe_truth_sphere_diffuse_rows(const double *in, double *out, size_t n);

#endif
