/* The constants of models/sg_diffuse.h, by least squares of the error over what the light gives overhead: a grid of 27
 * sharpnesses from .5 to 4096 and 41 heights of the axis. */
#ifndef LOBE_SG_LIGHT_FIT_DIFFUSE_H
#define LOBE_SG_LIGHT_FIT_DIFFUSE_H
#include "../case.h"

/* lobefit fit sg_diffuse; a lobe_command_fn. */
int lobe_sg_diffuse_fit(const lobe_case *self, int argc, char **argv);

#endif
