/* Round kernels over the sphere that integrate to 1, by the cosine c to their axis.
 *   prefilter  max(0, c) / (1 + k (1 - c))^2, k = (1 / alpha^2 - 1) / 2: what an ordinary split-sum prefilter holds
 *   sg         exp(sharpness (c - 1)) */
#ifndef LOBE_ENV_KERNELS_H
#define LOBE_ENV_KERNELS_H

/* t = alpha / sqrt(1 - alpha^2), so that k = 1 / (2 t^2): unbounded, its logarithm is what a fit moves. */
double lobe_prefilter_t_of_alpha(double alpha);
double lobe_prefilter_alpha_of_t(double t);

/* 1 / the integral of the kernel without its factor. */
double lobe_prefilter_factor(double t);
double lobe_prefilter_kernel(double t, double c);
double lobe_sg_kernel(double sharpness, double c);

/* The factors by which the kernel damps bands 0 .. bands - 1: the integral of kernel times P_l. */
void lobe_prefilter_bands(double t, int bands, double *factor);

#endif
