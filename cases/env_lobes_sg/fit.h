/* `lobefit fit env_lobes_sg`: the coefficients of the outer layer. */
#ifndef LOBE_SG_FIT_H
#define LOBE_SG_FIT_H
#include "../case.h"

int lobe_env_sg_fit(const lobe_case *self, int argc, char **argv);

#endif
