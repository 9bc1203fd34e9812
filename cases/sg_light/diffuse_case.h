/* The case sg_diffuse: irradiance over pi of a spherical Gaussian, which models/sg_diffuse.h stands for. Rows are
 * n_dot_l and versine, 1 / sharpness. */
#ifndef LOBE_SG_LIGHT_DIFFUSE_CASE_H
#define LOBE_SG_LIGHT_DIFFUSE_CASE_H
#include "../case.h"

/* The domain's versines. */
#define LOBE_SG_DIFFUSE_VERSINE_LO 0.000244140625
#define LOBE_SG_DIFFUSE_VERSINE_HI 1

/* A lobe_truth_fn, within 1e-9 of what the light gives overhead. */
void lobe_truth_sg_diffuse_rows(const double *in, double *out, size_t n);

extern const lobe_vector_set lobe_sg_diffuse_vectors;

/* lobefit bounds sg_diffuse; a lobe_command_fn. */
int lobe_sg_diffuse_bounds(const lobe_case *self, int argc, char **argv);

#endif
