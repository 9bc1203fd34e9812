/* The truth over many rows, kept in build/truth between runs: a million rows take half a minute. */
#ifndef LOBE_TRUTH_CACHE_H
#define LOBE_TRUTH_CACHE_H
#include <stddef.h>
#include "../case.h"
#include "sweep.h"

/* Fills out with the truth of c at n rows. A kept file is used where its inputs have the same digest and rows taken
 * from it at random places equal what the truth says now, bit for bit. Where it cannot be kept, it is computed each
 * time. */
void lobe_truth_cached(const lobe_case *c, const double *in, double *out, size_t n, const lobe_sweep_options *options);

#endif
