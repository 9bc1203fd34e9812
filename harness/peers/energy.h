/* Published formulas for E, the directional albedo of height-correlated GGX at f0 = 1. None of them ships. */
#ifndef LOBE_PEERS_ENERGY_H
#define LOBE_PEERS_ENERGY_H
#include "../../core/sqrt.h"
#include "../../core/scalar.h"

/* Kulla and Conty 2017, "Revisiting Physically Based Shading at Imageworks". 33 operations. */
LOBE_FN lobe_real peer_kulla_conty(lobe_real r, lobe_real v)
{
    LOBE_LET root = lobe_sqrt(v);
    LOBE_LET s = LOBE_R(-0.170718) * root +
                 r * (LOBE_R(4.07985) + r * (LOBE_R(-11.5295) + r * (LOBE_R(18.4961) - LOBE_R(9.23618) * r)));
    LOBE_LET t = LOBE_R(0.0632331) * v +
                 r * (LOBE_R(3.1434) + r * (LOBE_R(-7.47567) + r * (LOBE_R(13.0482) - LOBE_R(7.0401) * r)));
    LOBE_LET s2 = s * s;
    LOBE_LET t2 = t * t;
    LOBE_LET e = LOBE_R(1.0) - s2 * s2 * s2 * (root * lobe_sqrt(root)) / (t2 * t2 * t2 + v * v);
    return e;
}

#endif
