/* The tiers of sphere_light (tier_rows.h) with the bounds that their generated header states, and its columns. */
#ifndef LOBE_SPHERE_LIGHT_TIERS_H
#define LOBE_SPHERE_LIGHT_TIERS_H
#include "../case.h"

extern const lobe_vector_set lobe_sphere_vectors;

/* The case in the columns of its vectors (columns.h): what bounds and vectors ask for the truth. */
extern const lobe_case lobe_sphere_columns_case;

#endif
