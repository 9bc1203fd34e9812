#include "../sphere_light_schlick.h"
#include "sphere_light_entry.h"

LOBE_SPHERE_LIGHT_F32(lobe_sphere_light_schlick)
