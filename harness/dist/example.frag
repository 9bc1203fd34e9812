#version 310 es
#extension GL_GOOGLE_include_directive : require
precision highp float;
#include "lobe.shader.h"
layout(location = 0) in vec3 normal;
layout(location = 1) in vec3 view;
layout(location = 0) out vec4 colour;
void main()
{
    lobe_dfg d = lobe_split_sum_low(0.4, dot(normalize(normal), normalize(view)));
    colour = vec4(vec3(1.0, 0.78, 0.34) * d.scale + d.bias, 1.0);
}
