#define LOBE_ARRAYS 1
#include "../energy.h"
#include "energy_entry.h"

LOBE_ENERGY_N_F32(lobe_energy_inverse_low)
