/* PROVISIONAL forms, replaced when the fit is in. */
#ifndef LOBE_SPLIT_SUM_H
#define LOBE_SPLIT_SUM_H
#include "dfg.h"
#include "coeffs/split_sum_low.h"

LOBE_FN lobe_dfg lobe_split_sum_low(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET a = r * r;
    LOBE_LET w = lobe_max(v + LOBE_SPLIT_SUM_LOW_C0 * a, LOBE_R(1e-6));
    LOBE_LET s = v / w;
    LOBE_LET e = lobe_saturate(LOBE_R(1.0) - s * (LOBE_R(1.0) - s) * (LOBE_SPLIT_SUM_LOW_C1 + LOBE_SPLIT_SUM_LOW_C2 * a));
    LOBE_LET x = lobe_saturate(LOBE_R(1.0) - w * (LOBE_SPLIT_SUM_LOW_C3 + LOBE_SPLIT_SUM_LOW_C4 * r));
    LOBE_LET x2 = x * x;
    lobe_dfg d;
    d.bias = e * (x2 * x2 * x);
    d.scale = e - d.bias;
    return d;
}

#endif
