/* The commands of lobefit for sphere_diffuse. */
#ifndef LOBE_SPHERE_DIFFUSE_FIT_H
#define LOBE_SPHERE_DIFFUSE_FIT_H
#include "../case.h"

/* lobe_command_fn's. */
int lobe_sphere_diffuse_fit(const lobe_case *self, int argc, char **argv);
int lobe_sphere_diffuse_bounds(const lobe_case *self, int argc, char **argv);

#endif
