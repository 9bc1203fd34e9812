/* Fits the tiers of energy; their forms stand in models/energy.h. */
#ifndef LOBE_ENERGY_FIT_H
#define LOBE_ENERGY_FIT_H
#include "../case.h"

/* A lobe_command_fn. */
int lobe_energy_fit(const lobe_case *self, int argc, char **argv);

#endif
