/* Integrals over the sphere of functions that are even in y. */
#ifndef LOBE_ENV_CUBATURE_H
#define LOBE_ENV_CUBATURE_H

typedef double lobe_sphere_fn(void *ctx, const double d[3]);

/* Over cos(polar angle) and azimuth by boxes of 6 x 6 Gauss points, each halved both ways until that changes its part
 * by less than tolerance / 24 times the root of its share of the area, which suits edges along curves; from 24 x 24
 * boxes with an edge at the horizon. It knows nothing of lobes. */
double lobe_cubature(lobe_sphere_fn *f, void *ctx, double tolerance);

/* Importance sampled by the visible normals of (alpha, n_dot_v): the integral of lobe_response times f, with order^2
 * nodes of visible_normals.h. */
double lobe_visible_integral(double alpha, double n_dot_v, int order, lobe_sphere_fn *f, void *ctx);

#endif
