/* Fits the tiers of diffuse_sh, writes the constants of its exact tier, and measures what ships. */
#ifndef LOBE_DIFFUSE_FIT_H
#define LOBE_DIFFUSE_FIT_H
#include <stdbool.h>
#include "../case.h"
#include "../fit/fit_command.h"

/* lobe_command_fn's. */
int lobe_diffuse_fit(const lobe_case *self, int argc, char **argv);
int lobe_diffuse_bounds(const lobe_case *self, int argc, char **argv);

/* A lobe_fit_tier_fn: models/coeffs/diffuse_sh_exact.h, from the rationals of README.md. */
bool lobe_diffuse_constants(const lobe_case *self, const lobe_fit_request *request);

#endif
