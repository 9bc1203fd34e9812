/* What each tier loses under an environment: relative rms of the reflected radiance over random orientations (normal
 * over the sphere, view over its hemisphere, roughness over [0, 1], all uniform, a Latin hypercube) against full
 * integration: sqrt(sum |tier - truth|^2 / sum |truth|^2) over orientations and channels. */
#ifndef LOBE_ENVIRONMENT_METRIC_H
#define LOBE_ENVIRONMENT_METRIC_H
#include "environment.h"
#include "lobes.h"
#include <stdint.h>

typedef struct lobe_environment_metric_options {
    int orientations;
    uint64_t seed;
    double hanning; /* width of the window over the lighting; 0: none */
    int width;      /* full integration sums over a map of at least this width, where the map is a multiple of it */
} lobe_environment_metric_options;

lobe_environment_metric_options lobe_environment_metric_default(void); /* 600, 1, none, 256 */

/* error[tier], 0.01 being one per cent. 0 where there is no memory. */
int lobe_environment_metric(const lobe_environment *map, const lobe_environment_metric_options *options,
                            double error[LOBE_DIFFUSE_TIERS]);

#endif
