/* The rows of the vectors, and those over which bounds are measured. */
#ifndef LOBE_SPHERE_LIGHT_POINTS_H
#define LOBE_SPHERE_LIGHT_POINTS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { LOBE_SPHERE_VECTORS = 1024, LOBE_SPHERE_JUDGED = 1 << 17 };

/* A lobe_points_fn: at most LOBE_SPHERE_VECTORS rows; first the corners that have gone wrong in other models: a half
 * angle of .01 degree, of 45, the mirror direction, grazing views, lights through the horizon and wholly set. */
size_t lobe_sphere_points(double domain_lo, int beyond, uint64_t seed, double *points, size_t room);

/* count rows of a Latin hypercube, each second one near the mirror direction (columns.h). */
void lobe_sphere_judged(bool beyond, double *rows, size_t count);

#endif
