/* Burley 2012 (Disney diffuse), base colour 1: (1/pi)(1 + (f - 1)(1 - l)^5)(1 + (f - 1)(1 - v)^5),
 * f = .5 + 2 roughness (L.H)^2, where (L.H)^2 = (1 + L.V) / 2. */
#ifndef LOBE_BRDF_BURLEY_H
#define LOBE_BRDF_BURLEY_H
#include "../../../core/scalar.h"

LOBE_FN lobe_real lobe_brdf_burley(lobe_real n_dot_l, lobe_real n_dot_v, lobe_real l_dot_v, lobe_real roughness)
{
    LOBE_LET f1 = roughness * (LOBE_R(1.0) + l_dot_v) - LOBE_R(0.5);
    LOBE_LET x = LOBE_R(1.0) - n_dot_l;
    LOBE_LET y = LOBE_R(1.0) - n_dot_v;
    LOBE_LET x2 = x * x;
    LOBE_LET y2 = y * y;
    LOBE_LET a = LOBE_R(1.0) + f1 * (x2 * x2 * x);
    LOBE_LET b = LOBE_R(1.0) + f1 * (y2 * y2 * y);
    LOBE_LET f = LOBE_R(0.31830988618379067) * a * b;
    return f;
}

#endif
