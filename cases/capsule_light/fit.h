/* lobefit fit capsule_light: the constants of every tier, from scratch. */
#ifndef LOBE_CAPSULE_LIGHT_FIT_H
#define LOBE_CAPSULE_LIGHT_FIT_H
#include "../case.h"

/* A lobe_command_fn. */
int lobe_capsule_fit(const lobe_case *self, int argc, char **argv);

#endif
