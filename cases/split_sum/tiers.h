/* The tiers of the split sum and of energy, with the bounds that their generated headers state. */
#ifndef LOBE_SPLIT_SUM_TIERS_H
#define LOBE_SPLIT_SUM_TIERS_H
#include "../fit/vectors.h"

extern const lobe_vector_set lobe_split_sum_vectors;
extern const lobe_vector_set lobe_split_sum_sep_vectors;
extern const lobe_vector_set lobe_energy_vectors;

#endif
