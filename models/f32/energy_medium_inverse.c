#include "../energy.h"
#include "energy_entry.h"

LOBE_ENERGY_F32(lobe_energy_inverse_medium)
