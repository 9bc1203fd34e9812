/* What is fitted of Schlick's Fresnel inside a sphere light, and towards what. */
#ifndef LOBE_SPHERE_LIGHT_LIT_TIERS_H
#define LOBE_SPHERE_LIGHT_LIT_TIERS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../models/sphere_light_high.h"

enum { LOBE_SPHERE_LIT_MOST = 20, LOBE_SPHERE_F0S = 5, LOBE_SPHERE_BASES = 2 };

/* The reflectances that fits, bounds and tests look at: 1 .5 .1 .04 .02. */
extern const double lobe_sphere_f0s[LOBE_SPHERE_F0S];

/* Residuals, of every cell of both sets of fit cells (cells.h) and every f0: the squared relative error of
 * radiance (f0 + (1 - f0) schlick), times the weight of f0, over the sum of the weights; the radiance is in parts the
 * kernel's own, the true one, or that of a tier of fit_tiers.h, which is fitted first. */
typedef struct lobe_sphere_lit_tier {
    const char *name, *kernel, *source;
    lobe_sphere_lit (*call)(const double *p, double roughness, lobe_sphere light); /* no radiance where own is 0 */
    size_t count;
    double box[LOBE_SPHERE_LIT_MOST][2]; /* of the global search, a coefficient each */
    double weight[LOBE_SPHERE_F0S];
    double own, true_one;                 /* the parts */
    const char *under[LOBE_SPHERE_BASES]; /* the tiers that share the rest; NULL: none */
    size_t searches;                      /* from the seeds seed, seed + 1, ... */
    size_t generations;                   /* of each, which sees every tenth position */
    uint64_t seed;
} lobe_sphere_lit_tier;

/* The i-th, or NULL past the end. */
const lobe_sphere_lit_tier *lobe_sphere_lit_tier_at(int i);

#endif
