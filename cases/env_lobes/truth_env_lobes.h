/* `lobefit truth env_lobes`: rows of roughness, n_dot_v, n_dot_l and the azimuth between view and light (0: light from
 * where the viewer is, pi: mirror side) -> D G2 / (4 n.v), the BRDF times n.l at F = 1, and the same times Schlick's
 * (1 - v.h)^5. It is a formula: its error is that of double. */
#ifndef LOBE_TRUTH_ENV_LOBES_H
#define LOBE_TRUTH_ENV_LOBES_H
#include <stddef.h>

/* A lobe_truth_fn. */
void lobe_truth_env_lobes_rows(const double *in, double *out, size_t n);

#endif
