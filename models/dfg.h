/* What a split-sum kernel returns: reflectance is f0 * scale + f90 * bias. */
#ifndef LOBE_DFG_H
#define LOBE_DFG_H
#include "../core/scalar.h"

LOBE_STRUCT(lobe_dfg)
{
    lobe_real scale;
    lobe_real bias;
};

/* From E = scale + bias and the bias, both in [0, 1]. The sum stays in [0, 1]. */
LOBE_FN lobe_dfg lobe_dfg_of_bias(lobe_real e, lobe_real bias)
{
    LOBE_LET scale = e - bias;
    lobe_dfg d;
    d.scale = lobe_saturate(scale);
    d.bias = bias;
    return d;
}

/* From E and x, both in [0, 1], where bias = E x^5: the Fresnel term of one effective angle. */
LOBE_FN lobe_dfg lobe_dfg_of_angle(lobe_real e, lobe_real x)
{
    LOBE_LET x2 = x * x;
    LOBE_LET bias = e * (x2 * x2 * x);
    LOBE_LET scale = e - bias;
    lobe_dfg d;
    d.scale = scale;
    d.bias = bias;
    return d;
}

#endif
