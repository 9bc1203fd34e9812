/* lobefit fit sg_light: the constants of every tier, from scratch. */
#ifndef LOBE_SG_LIGHT_FIT_H
#define LOBE_SG_LIGHT_FIT_H
#include "../case.h"

/* A lobe_command_fn. */
int lobe_sg_fit(const lobe_case *self, int argc, char **argv);

#endif
