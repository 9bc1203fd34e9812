#include "../diffuse_sh.h"
#include "sh9_entry.h"

lobe_sh9_f32 lobe_diffuse_sh_lambert_f32(void) { return lobe_sh9_out(lobe_diffuse_sh_lambert()); }
