/* lobefit bounds sg_light: what ships, measured against the truth, into models/coeffs/sg_light_bounds.h. */
#ifndef LOBE_SG_LIGHT_BOUNDS_H
#define LOBE_SG_LIGHT_BOUNDS_H
#include "../case.h"

/* A lobe_command_fn. */
int lobe_sg_bounds(const lobe_case *self, int argc, char **argv);

#endif
