/* lobefit fit env_lobes: the coefficients of every tier, from scratch. */
#ifndef LOBE_ENV_LOBES_FIT_H
#define LOBE_ENV_LOBES_FIT_H
#include "../case.h"

/* A lobe_command_fn. */
int lobe_env_lobes_fit(const lobe_case *self, int argc, char **argv);

#endif
