/* How far a fan of taps is from the response as a function on the sphere: the relative L2 error, by two integrators
 * that share nothing. Weights of the taps sum to 1: they are
 * held against the response over its albedo. */
#ifndef LOBE_ENV_SHAPE_H
#define LOBE_ENV_SHAPE_H
#include "cell.h"
#include "cubature.h"

/* By adaptive cubature, to a thousandth of itself or better. */
double lobe_shape_error(double alpha, double n_dot_v, const lobe_cell_tap *taps, int count);

/* The same of any lobe, even in y. */
double lobe_shape_error_of(double alpha, double n_dot_v, lobe_sphere_fn *lobe, void *ctx);

/* By multiple importance sampling (balance heuristic) over the visible normals and every tap. */
double lobe_shape_error_sampled(double alpha, double n_dot_v, const lobe_cell_tap *taps, int count, int samples);

#endif
