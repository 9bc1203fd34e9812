/* What is measured of a sphere light, over the columns of columns.h. */
#ifndef LOBE_SPHERE_LIGHT_MEASURE_H
#define LOBE_SPHERE_LIGHT_MEASURE_H
#include "../fit/measure.h"

extern const lobe_quantity lobe_sphere_radiance;

/* A lobe_step_fn: directions are of roughness, view, light, azimuth, sine. A step over the domain's edge ends on it. */
bool lobe_sphere_step(const double *row, const double *direction, double step, bool beyond, double *next);

#endif
