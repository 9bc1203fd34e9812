/* Ground truth of diffuse_sh: BRDF x cosine x basis over the hemisphere, for any BRDF that is one function.
 *
 * Two integrators, neither of which knows the closed form of models/diffuse_sh.h:
 *   about z (the normal): Gauss-Legendre in n.L, trapezoid in azimuth, which is spectral since periodic;
 *   about y (normal x view): Gauss-Legendre in both angles; the hemisphere is the rectangle (0, pi) x (-pi/2, pi/2).
 * Both double their order until it changes nothing, from 12 up to 96. They agree to 2e-14 (cases/test). */
#ifndef LOBE_TRUTH_DIFFUSE_H
#define LOBE_TRUTH_DIFFUSE_H
#include <stddef.h>

enum { LOBE_DIFFUSE_NODES = 96 };

/* n.l, n.v, l.v, roughness -> BRDF, 1/pi included. */
typedef double lobe_diffuse_brdf(double n_dot_l, double n_dot_v, double l_dot_v, double roughness);

/* Burley 2012 as written: with the half vector, not with the polynomial that the closed form starts from. */
double lobe_burley_2012(double n_dot_l, double n_dot_v, double l_dot_v, double roughness);

/* The nine basis functions in the direction x, y, z. */
void lobe_truth_basis(double basis[9], double x, double y, double z);

/* n nodes and weights on [0, 1]. */
void lobe_truth_gauss(int n, double *node, double *weight);

/* Nine coefficients at one order. */
void lobe_diffuse_about_z(lobe_diffuse_brdf *brdf, double roughness, double n_dot_v, int order, double c[9]);
void lobe_diffuse_about_y(lobe_diffuse_brdf *brdf, double roughness, double n_dot_v, int order, double c[9]);

/* One of these two at the order that suffices: from then on no coefficient moves by more than 1e-14. */
typedef void lobe_diffuse_integrator(lobe_diffuse_brdf *brdf, double roughness, double n_dot_v, int order, double c[9]);
void lobe_diffuse_adaptive(lobe_diffuse_integrator *integrate, lobe_diffuse_brdf *brdf, double roughness,
                           double n_dot_v, double c[9]);

/* A lobe_truth_fn: Burley, about z. */
void lobe_truth_diffuse_rows(const double *in, double *out, size_t n);

#endif
