/* The order-3 projection of a map that is constant on each texel, exact to rounding: sh[channel][index], index
 * l^2 + l + m, every basis polynomial with positive sign. 0 where there is no memory for a row's table. */
#ifndef LOBE_ENVIRONMENT_PROJECT_H
#define LOBE_ENVIRONMENT_PROJECT_H
#include "environment.h"

int lobe_environment_project(const lobe_environment *map, double sh[3][9]);

/* The same function in a world with y up: the middle column looks along -z, columns to the right turn towards +x. */
void lobe_sh9_y_up(double c[9]);

#endif
