/* The rows of the vectors, and those over which bounds are measured. */
#ifndef LOBE_SG_LIGHT_POINTS_H
#define LOBE_SG_LIGHT_POINTS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { LOBE_SG_VECTORS = 1024, LOBE_SG_JUDGED = 1 << 15 };

/* A lobe_points_fn: at most LOBE_SG_VECTORS rows; first the corners that have gone wrong in other models: view and axis
 * on the normal, the mirror direction, grazing views, axes on and under the horizon. */
size_t lobe_sg_points(double domain_lo, int beyond, uint64_t seed, double *points, size_t room);

/* count rows of a Latin hypercube, each second one near the mirror direction (columns.h). */
void lobe_sg_judged(bool beyond, double *rows, size_t count);

#endif
