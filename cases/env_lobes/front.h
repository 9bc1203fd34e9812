/* `lobefit search env_lobes --csv FILE`: every tier and the split sum on environments that no fit has seen. */
#ifndef LOBE_ENV_FRONT_H
#define LOBE_ENV_FRONT_H
#include "../case.h"

/* A lobe_command_fn. */
int lobe_env_lobes_search(const lobe_case *self, int argc, char **argv);

#endif
