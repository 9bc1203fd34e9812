/* The constants of models/sg_diffuse.h, by least squares of the error over what the light gives overhead: a grid of 27
 * sharpnesses from .5 to 4096 and 41 heights of the axis. */
#ifndef LOBE_SG_LIGHT_FIT_DIFFUSE_H
#define LOBE_SG_LIGHT_FIT_DIFFUSE_H
#include <stdbool.h>
#include "../case.h"
#include "../fit/fit_command.h"

/* A lobe_fit_tier_fn. */
bool lobe_sg_fit_diffuse(const lobe_case *self, const lobe_fit_request *request);

#endif
