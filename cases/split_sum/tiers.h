/* The tiers of the split sum and of energy (tier_rows.h), with the bounds that their generated headers state. */
#ifndef LOBE_SPLIT_SUM_TIERS_H
#define LOBE_SPLIT_SUM_TIERS_H
#include "../fit/vectors.h"

/* Of split_sum, split_sum_sep and energy: their inputs are the same two. */
extern const lobe_vector_set lobe_split_sum_vectors;

#endif
