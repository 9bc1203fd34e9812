#include "../diffuse_sh.h"
#include "sh9_entry.h"

LOBE_SH9_F32(lobe_diffuse_sh_exact)
