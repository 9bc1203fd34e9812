/* What is fitted of sg_light, and towards what. All that one would change about a fit is in fit_tiers.c. Residuals are
 * of every position of both sets of fit cells (uniform and mixed, cells.h): the error over the cell's length of the
 * truth, over the root of the number of cells and sets, so that the sum of squares is the mean over cells of the
 * squared relative error. */
#ifndef LOBE_SG_LIGHT_FIT_TIERS_H
#define LOBE_SG_LIGHT_FIT_TIERS_H
#include <stddef.h>
#include <stdint.h>
#include "../../models/sg_light.h"

enum { LOBE_SG_MOST = 16 };

typedef struct lobe_sg_tier {
    const char *name, *kernel, *source;
    double (*call)(const double *p, double roughness, lobe_sg light);
    size_t count;
    double box[LOBE_SG_MOST][2]; /* of the global search, a coefficient each */
    size_t searches;             /* from the seeds seed, seed + 1, ... */
    size_t generations;          /* of each, which sees every tenth position */
    uint64_t seed;
} lobe_sg_tier;

/* The i-th, or NULL past the end. */
const lobe_sg_tier *lobe_sg_tier_at(int i);

#endif
