/* Where the vectors of sphere_diffuse lie: the ends of both inputs, the limbs on the horizon, lights through it from a
 * degree to half the sky, and any. */
#ifndef LOBE_SPHERE_DIFFUSE_POINTS_H
#define LOBE_SPHERE_DIFFUSE_POINTS_H
#include <stddef.h>
#include <stdint.h>

/* A lobe_points_fn (cases/fit/vectors.h): 256 rows where room allows; none below the domain. */
size_t lobe_sphere_diffuse_points(double domain_lo, int below, uint64_t seed, double *points, size_t room);

#endif
