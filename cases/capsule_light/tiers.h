/* The tiers of capsule_light (tier_rows.h) with the bounds that their generated header states. */
#ifndef LOBE_CAPSULE_LIGHT_TIERS_H
#define LOBE_CAPSULE_LIGHT_TIERS_H
#include "../fit/vectors.h"

extern const lobe_vector_set lobe_capsule_vectors;

#endif
