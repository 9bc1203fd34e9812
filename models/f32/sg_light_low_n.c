#define LOBE_ARRAYS 1
#include "../sg_light.h"
#include "sg_light_entry.h"

LOBE_SG_LIGHT_N_F32(lobe_sg_light_low)
