/* The difference of a lobe and a fan of taps under two norms over the sphere, as values whose squares add up: under
 * environments known by their power spectra, at all orientations alike, and as a shape.
 *
 * The first is the square integral of the difference after a blur by the spectrum's square root (spectrum.h). Blurred
 * kernels are round, so a spline over (angle to the axis, width) holds them; the blurred response is taken at the
 * points of one quadrature. Several spectra are one: each is divided by the energy of the response under it, then they
 * are averaged, so that the sum of squares is the mean of relative square errors. */
#ifndef LOBE_ENV_SPHERE_NORM_H
#define LOBE_ENV_SPHERE_NORM_H
#include "spectrum.h"

enum { LOBE_SPHERE_RADII = 22, LOBE_SPHERE_TURNS = 12, LOBE_SPHERE_POINTS = LOBE_SPHERE_RADII * LOBE_SPHERE_TURNS };
enum { LOBE_SPHERE_VALUES = 2 * LOBE_SPHERE_POINTS, LOBE_SPECTRA_MOST = 16 };

typedef struct lobe_sphere_norm lobe_sphere_norm;

/* The damping of every band by kernels of all widths: shared. NULL where there is no memory. */
typedef struct lobe_sphere_kernels lobe_sphere_kernels;
lobe_sphere_kernels *lobe_sphere_kernels_new(void);
void lobe_sphere_kernels_free(lobe_sphere_kernels *kernels);

/* For the response at (alpha, n_dot_v) over its albedo; at most LOBE_SPECTRA_MOST spectra. NULL where there is no
 * memory. */
lobe_sphere_norm *lobe_sphere_norm_new(double alpha, double n_dot_v, const lobe_sphere_kernels *kernels,
                                       const lobe_env_spectrum *spectra, int spectrum_count);
void lobe_sphere_norm_free(lobe_sphere_norm *norm);

/* LOBE_SPHERE_VALUES of the response: under the spectra, then of its shape, whose squares add up to about 1 each. */
const double *lobe_sphere_norm_target(const lobe_sphere_norm *norm);

/* The same of one tap of weight 1; derivatives by its angle and by ln t (kernels.h) unless NULL. */
void lobe_sphere_norm_tap(const lobe_sphere_norm *norm, double angle, double t, double *out, double *by_angle,
                          double *by_log_t);

/* LOBE_SPHERE_POINTS of any lobe under the spectra, by a quadrature of it: rows as of lobe_visible_nodes. */
void lobe_sphere_norm_nodes(const lobe_sphere_norm *norm, const double *nodes, int count, double *out);

#endif
