/* The case sphere_light_schlick: what Schlick's Fresnel makes of a sphere light's radiance. Lo at F0 is
 * Lo(1) (F0 + (1 - F0) s), so s = Lo(0) / Lo(1) says it for every F0. */
#ifndef LOBE_SPHERE_LIGHT_SCHLICK_CASE_H
#define LOBE_SPHERE_LIGHT_SCHLICK_CASE_H
#include "../case.h"

/* Where a light gives less than this, s is of no consequence, and neither bounds nor vectors look at it. */
#define LOBE_SPHERE_SCHLICK_LEAST 0.01

/* A lobe_truth_fn, and what it refuses: a light that is wholly set. */
void lobe_truth_sphere_schlick_rows(const double *in, double *out, size_t n);
const char *lobe_truth_sphere_schlick_refusal(const double *in);

/* Of the columns of columns.h; the second to 2e-6. */
void lobe_truth_sphere_schlick_columns(const double *in, double *out, size_t n);
void lobe_truth_sphere_schlick_columns_fast(const double *in, double *out, size_t n);

extern const lobe_vector_set lobe_sphere_schlick_vectors;

/* lobefit bounds sphere_light_schlick; a lobe_command_fn. */
int lobe_sphere_schlick_bounds(const lobe_case *self, int argc, char **argv);

#endif
