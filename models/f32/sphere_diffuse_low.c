#include "sphere_diffuse_entry.h"

LOBE_SPHERE_DIFFUSE_F32(lobe_sphere_diffuse_low)
