/* The outer layer as the kernel has it (models/env_lobes_sg.h, in double): quantities at a point, and the lobes that
 * follow. A quantity is a sum of LOBE_SG_FEATURES coefficients times features of (roughness, n_dot_v). */
#ifndef LOBE_SG_LAYERS_H
#define LOBE_SG_LAYERS_H
#include "fan.h"

/* In the order of the coefficients: Th, B, Sp, T, G, R, K, F of the kernel. */
enum {
    LOBE_SG_SHIFT,
    LOBE_SG_LEVEL,
    LOBE_SG_SPREAD,
    LOBE_SG_TILT,
    LOBE_SG_LEAN,
    LOBE_SG_RIM,
    LOBE_SG_TAPER,
    LOBE_SG_FLARE,
    LOBE_SG_QUANTITIES
};
enum { LOBE_SG_FEATURES = 12, LOBE_SG_COEFFICIENTS = LOBE_SG_QUANTITIES * LOBE_SG_FEATURES };

/* How many of the quantities a fan of count lobes has: 2, 5 or 8. */
int lobe_sg_quantities(int count);

void lobe_sg_features(double alpha, double n_dot_v, double *features);
/* quantity[lobe_sg_quantities(count)]; the others count as 0. */
void lobe_sg_lobes_of(double alpha, double n_dot_v, const double *quantity, int count, double energy, lobe_sg *lobes);
/* From coefficients c, a row of features a quantity. */
void lobe_sg_lobes_at(double alpha, double n_dot_v, const double *c, int count, double energy, lobe_sg *lobes);

#endif
