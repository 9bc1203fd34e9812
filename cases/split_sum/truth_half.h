/* The second integrator: over the half vector, by tanh-sinh in both directions. It shares no formula, no variable, no
 * nodes and no text with truth_kernel.h; it is slow, and is there to agree. */
#ifndef LOBE_TRUTH_HALF_H
#define LOBE_TRUTH_HALF_H
#include <stddef.h>

/* out[0] scale, out[1] bias at alpha and NdotV in (0, 1]; smith as in truth_kernel.h; step of tanh-sinh, at least
 * 1/64; 1/32 gives all digits. Returns the evaluations of the integrand that it took. */
size_t lobe_truth_half(int smith, double alpha, double n_dot_v, double step, double *out);

#endif
