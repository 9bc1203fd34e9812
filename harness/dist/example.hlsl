#define LOBE_HLSL 1
#include "lobe.shader.h"
float4 main(float3 normal : NORMAL, float3 view : TEXCOORD0) : SV_Target
{
    lobe_dfg d = lobe_split_sum_low(0.4, dot(normalize(normal), normalize(view)));
    return float4(float3(1.0, 0.78, 0.34) * d.scale + d.bias, 1.0);
}
