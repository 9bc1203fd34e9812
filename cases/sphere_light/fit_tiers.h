/* What is fitted of low and medium, and towards what. All that one would change about a fit is in fit_tiers.c; high is
 * fitted with its Fresnel, in lit_tiers.c. */
#ifndef LOBE_SPHERE_LIGHT_FIT_TIERS_H
#define LOBE_SPHERE_LIGHT_FIT_TIERS_H
#include <stddef.h>
#include <stdint.h>
#include "../../models/sphere_light.h"

enum { LOBE_SPHERE_MOST = 16 };

/* Residuals, of every cell of each set of fit cells (uniform and mixed positions, cells.h), times the set's weight:
 *   - a position: error over the cell's length of the truth, over the root of the number of cells, so that the sum of
 *     squares is the mean over cells of the squared relative error;
 *   - energy_weight max(0, |energy error of the cell| - energy_cap);
 *   - excess_weight max(0, error of the cell - error of a punctual light there - excess_cap), where the sine is less
 *     than .505 alpha. A weight of 0 leaves a term out. */
typedef struct lobe_sphere_tier {
    const char *name, *kernel, *source;
    double (*call)(const double *p, double roughness, lobe_sphere light);
    size_t count;
    double box[LOBE_SPHERE_MOST][2]; /* of the global search, a coefficient each */
    double set_weight[2];            /* uniform, mixed */
    double energy_weight, energy_cap;
    double excess_weight, excess_cap;
    size_t searches;    /* from the seeds seed, seed + 1, ... */
    size_t generations; /* of each, which sees every tenth position */
    uint64_t seed;
} lobe_sphere_tier;

/* The i-th, or NULL past the end. */
const lobe_sphere_tier *lobe_sphere_tier_at(int i);
const lobe_sphere_tier *lobe_sphere_tier_named(const char *name);

#endif
