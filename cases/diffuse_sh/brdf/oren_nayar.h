/* Oren and Nayar's qualitative model (SIGGRAPH 1994), base colour 1; roughness is their sigma in radians.
 * (1/pi)(A + B max(0, s) / max(l, v)), s = L.V - l v: sin(alpha) tan(beta) cos(phi) without angles. It loses energy. */
#ifndef LOBE_BRDF_OREN_NAYAR_H
#define LOBE_BRDF_OREN_NAYAR_H
#include "../../../core/scalar.h"

LOBE_FN lobe_real lobe_brdf_oren_nayar(lobe_real n_dot_l, lobe_real n_dot_v, lobe_real l_dot_v, lobe_real roughness)
{
    LOBE_LET q = roughness * roughness;
    LOBE_LET a = LOBE_R(1.0) - LOBE_R(0.5) * q / (q + LOBE_R(0.33));
    LOBE_LET b = LOBE_R(0.45) * q / (q + LOBE_R(0.09));
    LOBE_LET s = lobe_max(l_dot_v - n_dot_l * n_dot_v, LOBE_R(0.0));
    LOBE_LET t = lobe_max(lobe_max(n_dot_l, n_dot_v), LOBE_R(1e-12));
    LOBE_LET f = LOBE_R(0.31830988618379067) * (a + b * s / t);
    return f;
}

#endif
