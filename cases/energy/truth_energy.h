/* E alone, whose azimuth integral is elementary: a check of the split sum that costs 84 evaluations a point, not
 * 2352. lobefit serves the split sum's own scale + bias, so that all three models rest on one integrator. */
#ifndef LOBE_TRUTH_ENERGY_H
#define LOBE_TRUTH_ENERGY_H
#include <stddef.h>

/* E at alpha and NdotV in (0, 1] with at most 3 order evaluations of the integrand, whose number is stored in
 * *evaluations; smith as in truth_kernel.h. Order 28 gives 1e-9 (README.md). */
double lobe_truth_energy(int smith, double alpha, double n_dot_v, int order, size_t *evaluations);

#endif
