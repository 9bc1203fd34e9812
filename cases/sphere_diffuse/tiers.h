/* The tiers of sphere_diffuse (tier_rows.h) with the bounds that their generated header states. */
#ifndef LOBE_SPHERE_DIFFUSE_TIERS_H
#define LOBE_SPHERE_DIFFUSE_TIERS_H
#include "../fit/vectors.h"

extern const lobe_vector_set lobe_sphere_diffuse_vectors;

#endif
