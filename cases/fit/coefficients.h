/* Writes the generated headers of models/coeffs: coefficients as literals for what ships, as p[i] for the fitter. */
#ifndef LOBE_COEFFICIENTS_H
#define LOBE_COEFFICIENTS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct lobe_coefficients {
    const char *model, *tier;
    const char *brdf;
    const char *domain; /* of the fit, as text: "roughness, n_dot_v in [.02, 1]" */
    const char *grid;   /* its points */
    const char *metric; /* what was made small */
    double max, rms;    /* of that metric on that grid, in double with the coefficients as written */
    double at[2];       /* where the maximum is */
    const char *error;  /* the figures as text instead, where there are others; NULL: max, at and rms */
    uint64_t seed;
    const char *kernel; /* the function in source whose text is digested */
    const char *source;
    const double *values;
    size_t count;
} lobe_coefficients;

/* Rounds to the nine digits that are written, and those to float: what ships is what a fit should judge. */
double lobe_coefficient_rounded(double x);

/* Writes folder/MODEL_TIER.h, whole or not at all. False after a line on stderr. */
bool lobe_coefficients_write(const lobe_coefficients *c, const char *folder);

/* Digest of one function's text, comments and white space aside. False after a line on stderr where there is none. */
bool lobe_kernel_digest(const char *source, const char *function, uint64_t *digest);

/* Writes text upper-cased, for the names of macros. */
void lobe_put_upper(FILE *out, const char *text);

#ifdef __cplusplus
}
#endif
#endif
