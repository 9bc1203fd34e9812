/* Lambert, base colour 1. */
#ifndef LOBE_BRDF_LAMBERT_H
#define LOBE_BRDF_LAMBERT_H
#include "../../../core/scalar.h"

LOBE_FN lobe_real lobe_brdf_lambert(lobe_real n_dot_l, lobe_real n_dot_v, lobe_real l_dot_v, lobe_real roughness)
{
    LOBE_LET unused = lobe_min(lobe_min(n_dot_l, n_dot_v), lobe_min(l_dot_v, roughness));
    LOBE_LET f = LOBE_R(0.31830988618379067) + LOBE_R(0.0) * unused;
    return f;
}

#endif
