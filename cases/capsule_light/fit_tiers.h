/* What is fitted of capsule_light, and towards what. All that one would change about a fit is in fit_tiers.c. */
#ifndef LOBE_CAPSULE_LIGHT_FIT_TIERS_H
#define LOBE_CAPSULE_LIGHT_FIT_TIERS_H
#include <stddef.h>
#include <stdint.h>

enum { LOBE_CAPSULE_MOST = 8 };

/* The residual of a position is its error over the cell's length of the truth and the root of the number of cells: the
 * sum of squares is the mean over cells of the squared relative error. The sphere beneath is the one that ships: fit
 * the capsule again when that has changed. */
typedef struct lobe_capsule_tier {
    const char *name, *kernel, *source;
    double (*call)(const double *p, const double *row);
    size_t count;
    double box[LOBE_CAPSULE_MOST][2]; /* of the global search, a coefficient each */
    size_t searches;                  /* from the seeds seed, seed + 1, ... */
    size_t generations;               /* of each, which sees every sixth position */
    uint64_t seed;
} lobe_capsule_tier;

/* The i-th, or NULL past the end. */
const lobe_capsule_tier *lobe_capsule_tier_at(int i);

#endif
