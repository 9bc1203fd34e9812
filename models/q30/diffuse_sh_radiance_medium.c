#include "diffuse_sh_radiance.h"

LOBE_DIFFUSE_SH_RADIANCE_Q30(medium)
