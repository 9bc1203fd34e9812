/* lobefit fit sphere_light: the constants of every tier, from scratch. */
#ifndef LOBE_SPHERE_LIGHT_FIT_H
#define LOBE_SPHERE_LIGHT_FIT_H
#include "../case.h"

/* A lobe_command_fn. */
int lobe_sphere_fit(const lobe_case *self, int argc, char **argv);

#endif
