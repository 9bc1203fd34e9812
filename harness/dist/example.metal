#include <metal_stdlib>
#include "lobe.shader.h"
kernel void reflectance(device const float *roughness [[buffer(0)]], device const float *n_dot_v [[buffer(1)]],
                        device float *result [[buffer(2)]], uint i [[thread_position_in_grid]])
{
    const lobe_dfg d = lobe_split_sum_low(roughness[i], n_dot_v[i]);
    result[i] = 0.04f * d.scale + d.bias;
}
