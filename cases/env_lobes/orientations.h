/* Training environments at sampled orientations: the radiance through prefilter kernels of every width at every angle
 * in each sample's plane of incidence, and through the response. All are of environments without detail below a degree,
 * so that both are exact: a kernel scales the bands of spherical harmonics. */
#ifndef LOBE_ENV_ORIENTATIONS_H
#define LOBE_ENV_ORIENTATIONS_H
#include <stdbool.h>
#include "blurred_cubes.h"

enum { LOBE_ORIENTATION_ANGLES = 248, LOBE_ORIENTATION_WIDTHS = 44 };

/* Widths as ln t (kernels.h), angles from the normal in radians, both evenly. */
#define LOBE_ORIENTATION_T_LO 0.008
#define LOBE_ORIENTATION_T_HI 60.0
#define LOBE_ORIENTATION_ANGLE_LO (-1.3)
#define LOBE_ORIENTATION_ANGLE_HI 2.6

typedef struct lobe_orientations {
    int count; /* samples: environments times their orientations */
    int environments;
    double (*axes)[9];         /* of each: normal, towards the mirror direction in the plane, across */
    float *tap;                /* spline coefficients [angle + 1][width + 1][sample] */
    lobe_blurred_cubes *cubes; /* of each environment */
} lobe_orientations;

/* seed chooses the orientations. NULL where there is no memory. */
lobe_orientations *lobe_orientations_new(const lobe_environment *maps, int map_count, int each, unsigned seed,
                                         int threads);
void lobe_orientations_free(lobe_orientations *o);

/* sum weight radiance over nodes x y z weight level, y of both signs alike (level: blurred_cubes.h): out[sample]. */
void lobe_orientations_integrate(const lobe_orientations *o, const double *nodes, int count, double *out);

/* Radiance through a tap of weight 1 in every sample, and by angle and by ln t unless those are NULL. */
void lobe_orientations_tap(const lobe_orientations *o, double angle, double t, double *out, double *by_angle,
                           double *by_log_t);

#endif
