/* A spherical Gaussian light as a point sees it: from directions to the numbers that every tier takes. */
#ifndef LOBE_SG_LIGHT_SEEN_H
#define LOBE_SG_LIGHT_SEEN_H
#include "sg_light.h"
#include "sphere_light_seen.h"

/* normal, view and axis are unit vectors; sharpness counts as at least 1. The tangential part of the half sum is found
 * as a vector and then squared, as for a sphere light. 42 operations, of which 22 are clamps. */
LOBE_FN lobe_sg lobe_sg_seen(lobe_vec3 normal, lobe_vec3 view, lobe_vec3 axis, lobe_real sharpness)
{
    lobe_vec3 n = lobe_sphere_bounded(normal, LOBE_R(1.0));
    lobe_vec3 w = lobe_sphere_bounded(view, LOBE_R(1.0));
    lobe_vec3 l = lobe_sphere_bounded(axis, LOBE_R(1.0));
    LOBE_LET nv = lobe_vec3_dot(n, w);
    LOBE_LET nl = lobe_vec3_dot(n, l);
    LOBE_LET up = LOBE_R(0.5) * (nv + nl);
    LOBE_LET tx = LOBE_R(0.5) * (w.x + l.x) - up * n.x;
    LOBE_LET ty = LOBE_R(0.5) * (w.y + l.y) - up * n.y;
    LOBE_LET tz = LOBE_R(0.5) * (w.z + l.z) - up * n.z;
    LOBE_LET tangent2 = lobe_saturate(tx * tx + ty * ty + tz * tz);
    LOBE_LET n_dot_v = lobe_saturate(nv);
    LOBE_LET n_dot_l = lobe_clamp(nl, LOBE_R(-1.0), LOBE_R(1.0));
    LOBE_LET versine = LOBE_R(1.0) / lobe_clamp(sharpness, LOBE_R(1.0), LOBE_R(1e6));
    return lobe_sg_of(n_dot_v, n_dot_l, tangent2, versine);
}

#endif
