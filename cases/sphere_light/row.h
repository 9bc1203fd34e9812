/* The rows of this case as the runtime's input. A row is roughness, n_dot_v, n_dot_l, azimuth, half angle, as lobefit
 * truth takes it; a column row, of the vectors, is roughness, n_dot_v, n_dot_l, tangent2, sine. For a file that has
 * LOBE_DOUBLE defined. */
#ifndef LOBE_SPHERE_LIGHT_ROW_H
#define LOBE_SPHERE_LIGHT_ROW_H
#include <math.h>
#include "../../models/sphere_light.h"

static inline lobe_sphere lobe_sphere_of_row(const double row[5])
{
    const double v = row[1], l = row[2], sv = sqrt(1 - v * v), sl = sqrt(1 - l * l), half = sin(.5 * row[4]);
    const double cross = sin(.5 * (3.14159265358979323846 - row[3])), apart = sv - sl;
    lobe_sphere s;
    s.n_dot_v = v;
    s.n_dot_l = l;
    s.tangent2 = .25 * apart * apart + sv * sl * cross * cross; /* (sv^2 + sl^2 + 2 sv sl cos(azimuth)) / 4 */
    s.sine = sin(row[4]);
    s.versine = 2 * half * half;
    return s;
}

static inline lobe_sphere lobe_sphere_of_columns(const double row[5])
{
    return lobe_sphere_of(row[1], row[2], row[3], row[4]);
}

#endif
