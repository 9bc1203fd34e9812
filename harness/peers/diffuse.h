/* Published stand-ins for Burley's diffuse under nine spherical harmonics: the stars on the chart. Neither ships. */
#ifndef LOBE_PEERS_DIFFUSE_H
#define LOBE_PEERS_DIFFUSE_H
#include "../../models/diffuse_sh.h"
#include "../../models/diffuse_zonal.h"

/* Iwanicki and Pesce 2015, "Approximate Models For Physically Based Rendering", with the coefficients as printed.
 *
 * The printed listing divides the product of lobe and lighting by pi once too often. Z0, Z1 and Z2 hold the 1/pi of the
 * BRDF already: Z0 lies around Lambert's band 0, 1 / sqrt(4 pi) = .282, and the furnace is sqrt(4 pi) Z0. Taken
 * literally the furnace returns 1/pi, 68 % too dark; the division is left out here. 48 operations for the nine local
 * coefficients. */
LOBE_FN lobe_zonal_shape peer_seed_shape(lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET x = LOBE_R(1.0) - v;
    LOBE_LET beta = lobe_max(LOBE_R(0.3775) * x + LOBE_R(0.1372) * r - LOBE_R(0.2988), LOBE_R(0.0));
    LOBE_LET m = lobe_max(x, LOBE_R(0.5637));
    LOBE_LET q0 = LOBE_R(0.0913) + LOBE_R(0.3067) * r;
    LOBE_LET q1 = LOBE_R(0.6502) - LOBE_R(1.0803) * r;
    LOBE_LET q2 = LOBE_R(1.0632) * r - LOBE_R(0.5993);
    LOBE_LET z0 = q0 + m * (q1 + m * q2);
    LOBE_LET z1 = z0 * (LOBE_R(1.1635) - LOBE_R(0.0304) * r + LOBE_R(0.0162) * x);
    LOBE_LET z2 = z0 * (LOBE_R(0.5725) - LOBE_R(0.0569) * r + LOBE_R(0.0386) * x);
    return lobe_zonal_shape_of(z0, z1, z2, beta);
}

LOBE_FN lobe_sh9 peer_zonal_2015(lobe_real r, lobe_real v)
{
    return lobe_diffuse_zonal_local(lobe_zonal_lobe_of(peer_seed_shape(r, v), v), v);
}

/* The same from world space to RGB, for counting: as lobe_diffuse_sh_radiance_low. */
LOBE_FN lobe_sh9 peer_zonal_2015_turned(lobe_real r, lobe_vec3 n, lobe_vec3 view, lobe_real v)
{
    lobe_zonal_lobe z = lobe_zonal_lobe_of(peer_seed_shape(r, v), v);
    lobe_vec3 d = lobe_vec3_add(lobe_vec3_scale(n, z.along_n), lobe_vec3_scale(view, z.along_view));
    return lobe_sh9_zonal(z.z0, z.z1, z.z2, d);
}

#endif
