/* `lobefit search env_lobes_sg --csv FILE`: what ships, the seed paper's model fitted alike, and the split sum, in all
 * orientations of environments that no fit has seen. */
#ifndef LOBE_SG_FRONT_H
#define LOBE_SG_FRONT_H
#include "../case.h"

/* A lobe_command_fn. */
int lobe_env_sg_search(const lobe_case *self, int argc, char **argv);

#endif
