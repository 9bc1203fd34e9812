/* lobefit bounds sphere_light: what ships, measured against the truth, into models/coeffs/sphere_light_bounds.h. */
#ifndef LOBE_SPHERE_LIGHT_BOUNDS_H
#define LOBE_SPHERE_LIGHT_BOUNDS_H
#include "../case.h"

/* A lobe_command_fn. */
int lobe_sphere_bounds(const lobe_case *self, int argc, char **argv);

#endif
