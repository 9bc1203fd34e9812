/* A clear sky without its disc, for scenes that must not depend on a file. 0 where there is no memory. */
#ifndef LOBE_ENVIRONMENT_SKY_H
#define LOBE_ENVIRONMENT_SKY_H
#include "environment.h"

int lobe_environment_sky(lobe_environment *map, int width, int height, unsigned seed);

#endif
