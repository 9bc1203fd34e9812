#include "../lobe.h"
#include "../sg_diffuse.h"

float lobe_sg_diffuse_high_f32(float n_dot_l, float versine) { return lobe_sg_diffuse_high(n_dot_l, versine); }
