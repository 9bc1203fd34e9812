/* Where the vectors of diffuse_sh lie: corners and edges of [0, 1]^2, a jittered lattice denser toward grazing views,
 * and random points. */
#ifndef LOBE_DIFFUSE_POINTS_H
#define LOBE_DIFFUSE_POINTS_H
#include <stddef.h>
#include <stdint.h>

/* A lobe_points_fn (cases/fit/vectors.h): 256 rows where room allows; none below the domain, which starts at 0. */
size_t lobe_diffuse_points(double domain_lo, int below, uint64_t seed, double *points, size_t room);

#endif
