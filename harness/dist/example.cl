#include "lobe.shader.h"
__kernel void reflectance(__global const float *roughness, __global const float *n_dot_v, __global float *result)
{
    const size_t i = get_global_id(0);
    const lobe_dfg d = lobe_split_sum_low(roughness[i], n_dot_v[i]);
    result[i] = 0.04f * d.scale + d.bias;
}
