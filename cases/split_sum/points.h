/* Where the vectors of roughness and NdotV lie: corners and edges of the domain, a jittered lattice and random
 * points, denser toward low roughness and grazing views, where every fit is worst. */
#ifndef LOBE_SPLIT_SUM_POINTS_H
#define LOBE_SPLIT_SUM_POINTS_H
#include <stddef.h>
#include <stdint.h>

/* A lobe_points_fn (cases/fit/vectors.h): 256 rows where room allows. */
size_t lobe_split_sum_points(double domain_lo, int below, uint64_t seed, double *points, size_t room);

#endif
