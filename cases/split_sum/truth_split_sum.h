/* The production integrator: truth at many points, in plain C or through OpenCL, by the text of truth_kernel.h. */
#ifndef LOBE_TRUTH_SPLIT_SUM_H
#define LOBE_TRUTH_SPLIT_SUM_H
#include <stddef.h>

/* Nodes a direction: 3 * 28^2 = 2352 evaluations a point. */
#define LOBE_TRUTH_ORDER 28

/* Reads n rows of roughness and NdotV, both in [.001, 1], and writes n rows of scale and bias; reentrant.
 * _sep is separable Smith, _kibl Schlick-Smith with k = alpha / 2, energy one column: scale + bias. */
void lobe_truth_split_sum_rows(const double *in, double *out, size_t n);
void lobe_truth_split_sum_sep_rows(const double *in, double *out, size_t n);
void lobe_truth_split_sum_kibl_rows(const double *in, double *out, size_t n);
void lobe_truth_energy_rows(const double *in, double *out, size_t n);

/* One point with any number of nodes a direction, for questions of convergence; smith as in truth_kernel.h,
 * out[0] scale, out[1] bias. Returns the evaluations of the integrand that it took. */
size_t lobe_truth_split_sum_order(int smith, double alpha, double n_dot_v, int order, double *out);

/* The same through OpenCL. 0, or 2 with the reason in error. */
int lobe_truth_split_sum_opencl(const double *in, double *out, size_t n, char *error, size_t error_size);
int lobe_truth_split_sum_sep_opencl(const double *in, double *out, size_t n, char *error, size_t error_size);
int lobe_truth_split_sum_kibl_opencl(const double *in, double *out, size_t n, char *error, size_t error_size);
int lobe_truth_energy_opencl(const double *in, double *out, size_t n, char *error, size_t error_size);

#endif
