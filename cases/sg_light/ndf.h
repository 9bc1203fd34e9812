/* A distribution of normals as a sum of 1 to 5 spherical Gaussians, which is where the published methods start: D(h) =
 * sum of amplitude_i exp(sharpness_i (n.h - 1)). Fitted to GGX and to Beckmann for each alpha by itself; measured is
 * the relative L2 error over the hemisphere with the weight (n.h), by which a distribution counts, and what the sum of
 * D (n.h), which should be 1, is instead. */
#ifndef LOBE_SG_LIGHT_NDF_H
#define LOBE_SG_LIGHT_NDF_H
#include <stdbool.h>
#include <stdio.h>

enum { LOBE_NDF_MOST = 5, LOBE_NDF_ALPHAS = 12 };

typedef enum lobe_ndf { LOBE_NDF_GGX, LOBE_NDF_BECKMANN } lobe_ndf;

typedef struct lobe_ndf_fit {
    double sharpness[LOBE_NDF_MOST], amplitude[LOBE_NDF_MOST]; /* over 1 / alpha^2 and 1 / (pi alpha^2) */
    double error, sum;
} lobe_ndf_fit;

/* The alphas of the table, .05 to 1. */
double lobe_ndf_alpha(int i);

double lobe_ndf_value(lobe_ndf kind, double alpha, double cosine);

/* count Gaussians at every alpha of the table; false: a fit did not converge. */
bool lobe_ndf_fit_all(lobe_ndf kind, int count, lobe_ndf_fit fits[LOBE_NDF_ALPHAS]);

/* Judges numbers that are known. */
void lobe_ndf_judge(lobe_ndf kind, int count, double alpha, lobe_ndf_fit *fit);

/* The whole table as CSV; false after a line on stderr. */
bool lobe_ndf_write(FILE *out);

#endif
