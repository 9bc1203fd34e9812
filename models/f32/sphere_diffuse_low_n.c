#define LOBE_ARRAYS 1
#include "sphere_diffuse_entry.h"

LOBE_SPHERE_DIFFUSE_N_F32(lobe_sphere_diffuse_low)
