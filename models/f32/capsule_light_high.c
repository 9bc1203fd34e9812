#include "../capsule_light_high.h"
#include "capsule_light_entry.h"

LOBE_CAPSULE_LIGHT_F32(lobe_capsule_light_high)
