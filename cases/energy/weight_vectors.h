/* Vectors of env_lobes and env_lobes_sg. Taps into an environment are a fit and have no truth of their own; what has
 * one is the sum of their weights, the albedo. So a row is roughness and n_dot_v, and E by the integrators of the
 * energy case. */
#ifndef LOBE_WEIGHT_VECTORS_H
#define LOBE_WEIGHT_VECTORS_H
#include "../case.h"

extern const lobe_vector_set lobe_env_lobes_vectors, lobe_env_lobes_sg_vectors;

#endif
