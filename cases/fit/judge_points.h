/* Where bounds are measured: inside the domain [.02, 1]^2 a uniform grid of 1024^2 points, 2^17 random ones, denser
 * toward low roughness and grazing views, and the case's own vectors; below it, down to .001, a lattice that is
 * uniform in the logarithm, and the vectors. All are multiples of 2^-24, exact in every format. */
#ifndef LOBE_JUDGE_POINTS_H
#define LOBE_JUDGE_POINTS_H
#include <stddef.h>
#include "../case.h"

#define LOBE_JUDGE_LO 0.02
#define LOBE_JUDGE_LEAST 0.001 /* of the truth */

typedef struct lobe_judge_points {
    double *at; /* rows of roughness and NdotV */
    size_t count;
    size_t uniform; /* the first so many are the grid, over which an rms is taken */
} lobe_judge_points;

/* The nearest multiple of 2^-24. */
double lobe_judge_exact(double x);

/* at is NULL without memory; free it. */
lobe_judge_points lobe_judge_inside(const lobe_case *c);
lobe_judge_points lobe_judge_below(const lobe_case *c);

#endif
