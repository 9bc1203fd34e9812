#version 450
#extension GL_GOOGLE_include_directive : require
#include "lobe.shader.h"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba32f) uniform writeonly image2D table;
void main()
{
    vec2 at = (vec2(gl_GlobalInvocationID.xy) + 0.5) / vec2(imageSize(table));
    lobe_dfg d = lobe_split_sum_low(at.y, at.x);
    imageStore(table, ivec2(gl_GlobalInvocationID.xy), vec4(d.scale, d.bias, 0.0, 1.0));
}
