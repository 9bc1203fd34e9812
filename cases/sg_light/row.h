/* The rows of this case as the runtime's input. A row is roughness, n_dot_v, n_dot_l, azimuth, sharpness, as lobefit
 * truth takes it; a column row, of the vectors, is roughness, n_dot_v, n_dot_l, tangent2, versine. For a file that has
 * LOBE_DOUBLE defined. */
#ifndef LOBE_SG_LIGHT_ROW_H
#define LOBE_SG_LIGHT_ROW_H
#include <math.h>
#include "../../models/sg_light.h"

static inline lobe_sg lobe_sg_of_row(const double row[5])
{
    const double v = row[1], l = row[2], sv = sqrt(1 - v * v), sl = sqrt(1 - l * l), apart = sv - sl;
    const double cross = cos(.5 * row[3]);
    return lobe_sg_of(v, l, .25 * apart * apart + sv * sl * cross * cross, 1 / row[4]);
}

static inline lobe_sg lobe_sg_of_columns(const double row[5]) { return lobe_sg_of(row[1], row[2], row[3], row[4]); }

/* The punctual light of the same irradiance at normal incidence, but for exp(-2 sharpness). */
static inline double lobe_sg_punctual(double roughness, lobe_sg s)
{
    const lobe_sphere light = {s.n_dot_v, s.n_dot_l, s.tangent2, 0, s.versine};
    return lobe_sphere_light_punctual(roughness, light);
}

#endif
