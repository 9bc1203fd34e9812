/* Random numbers of the fitter: xoshiro256++ (Blackman and Vigna 2019), seeded through splitmix64.
 * The state lives with its owner; equal seed and stream give equal numbers on every target. */
#ifndef LOBE_RANDOM_H
#define LOBE_RANDOM_H

#include <stddef.h>
#include <stdint.h>

typedef struct lobe_random {
    uint64_t s[4];
} lobe_random;

/* Streams of one seed are independent of each other. */
void lobe_random_seed(lobe_random *random, uint64_t seed, uint64_t stream);
uint64_t lobe_random_bits(lobe_random *random);
/* Uniform in [0, 1), a multiple of 2^-53. */
double lobe_random_unit(lobe_random *random);
/* Uniform in 0 .. n - 1, for 1 <= n < 2^32. */
size_t lobe_random_below(lobe_random *random, size_t n);
/* Latin hypercube: count points in the box, one in each of count slices of every axis. out: count x dim. */
void lobe_random_latin(lobe_random *random, const double *lower, const double *upper, size_t dim, size_t count,
                       double *out);

#endif
