/* lobefit bounds env_lobes, env_lobes_sg: how far the weights of what ships are from the albedo, and what the kernels
 * cost, into models/coeffs/MODEL_bounds.h. How near taps come to the truth is a matter of radiance: front.csv. */
#ifndef LOBE_ENV_LOBES_BOUNDS_H
#define LOBE_ENV_LOBES_BOUNDS_H
#include "../case.h"

/* A lobe_command_fn of both cases. */
int lobe_env_bounds(const lobe_case *self, int argc, char **argv);

#endif
