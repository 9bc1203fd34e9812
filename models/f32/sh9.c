#include "sh9_entry.h"

lobe_sh9_f32 lobe_sh9_other_sign_f32(lobe_sh9_f32 c) { return lobe_sh9_out(lobe_sh9_other_sign(lobe_sh9_in(&c))); }
