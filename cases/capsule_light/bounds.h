/* lobefit bounds capsule_light: what ships, measured against the truth, into models/coeffs/capsule_light_bounds.h. */
#ifndef LOBE_CAPSULE_LIGHT_BOUNDS_H
#define LOBE_CAPSULE_LIGHT_BOUNDS_H
#include "../case.h"

/* A lobe_command_fn. */
int lobe_capsule_bounds(const lobe_case *self, int argc, char **argv);

#endif
