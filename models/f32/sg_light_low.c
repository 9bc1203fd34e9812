#include "../sg_light.h"
#include "sg_light_entry.h"

LOBE_SG_LIGHT_F32(lobe_sg_light_low)
