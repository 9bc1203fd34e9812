/* The tiers of diffuse_sh (tier_rows.h) with the bounds that their generated header states. */
#ifndef LOBE_DIFFUSE_TIERS_H
#define LOBE_DIFFUSE_TIERS_H
#include "../fit/vectors.h"

extern const lobe_vector_set lobe_diffuse_vectors;

#endif
