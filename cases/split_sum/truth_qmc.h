/* The third opinion: randomised quasi-Monte Carlo, sampling visible normals. Good to four digits or five; it shares
 * neither domain nor rule with the integrators, so it catches a mistake that both could make in the integrand. */
#ifndef LOBE_TRUTH_QMC_H
#define LOBE_TRUTH_QMC_H
#include <stddef.h>
#include <stdint.h>

typedef enum lobe_qmc_sequence { LOBE_QMC_HAMMERSLEY, LOBE_QMC_HALTON } lobe_qmc_sequence;

typedef struct lobe_qmc_options {
    lobe_qmc_sequence sequence;
    size_t samples; /* of one shift */
    int shifts;     /* random shifts of the whole point set, at least 2: their spread is the error */
    uint64_t seed;
} lobe_qmc_options;

/* Hammersley, 65,536 samples, 16 shifts, seed 1. */
lobe_qmc_options lobe_qmc_options_default(void);

/* out[0] scale, out[1] bias; error holds the standard error of each. smith as in truth_kernel.h. */
void lobe_truth_qmc(int smith, double alpha, double n_dot_v, const lobe_qmc_options *options, double *out,
                    double *error);

#endif
