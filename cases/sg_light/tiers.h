/* The tiers of sg_light (tier_rows.h) with the bounds that their generated header states, and its columns. */
#ifndef LOBE_SG_LIGHT_TIERS_H
#define LOBE_SG_LIGHT_TIERS_H
#include "../case.h"

extern const lobe_vector_set lobe_sg_vectors;

/* The case in the columns of its vectors (columns.h): what bounds and vectors ask for the truth. */
extern const lobe_case lobe_sg_columns_case;

#endif
