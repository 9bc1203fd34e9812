#include "../lobe.h"
#include "../sg_diffuse.h"

float lobe_sg_diffuse_inner_f32(float n_dot_l, float versine) { return lobe_sg_diffuse_inner(n_dot_l, versine); }
