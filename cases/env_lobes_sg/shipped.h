/* The kernel with the coefficients that ship, in double. */
#ifndef LOBE_SG_SHIPPED_H
#define LOBE_SG_SHIPPED_H
#include "fan.h"

/* count 1, 2, 4 or 8; any number for the others. Returns count. */
int lobe_sg_shipped(int count, double roughness, double n_dot_v, double albedo, lobe_sg *lobes);

#endif
