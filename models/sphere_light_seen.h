/* A sphere light as a point sees it: from directions and distances to the numbers that every tier takes. */
#ifndef LOBE_SPHERE_LIGHT_SEEN_H
#define LOBE_SPHERE_LIGHT_SEEN_H
#include "../core/vec3.h"
#include "sphere_light.h"

/* Every component inside [-bound, bound]; NaN gives -bound. */
LOBE_FN lobe_vec3 lobe_sphere_bounded(lobe_vec3 a, lobe_real bound)
{
    LOBE_LET x = lobe_clamp(a.x, -bound, bound);
    LOBE_LET y = lobe_clamp(a.y, -bound, bound);
    LOBE_LET z = lobe_clamp(a.z, -bound, bound);
    return lobe_vec3_of(x, y, z);
}

/* normal and view are unit vectors; to_centre is from the point to the middle of the sphere, in the unit of radius.
 * A point inside the sphere counts as on it (sine 1), a distance below 1e-15 as 1e-15. The tangential part of the half
 * sum is found as a vector and then squared: from the heights it would be a difference of two numbers near 1, whose
 * rounding is as large as a narrow lobe. 69 operations, of which 22 are clamps. */
LOBE_FN lobe_sphere lobe_sphere_seen(lobe_vec3 normal, lobe_vec3 view, lobe_vec3 to_centre, lobe_real radius)
{
    lobe_vec3 n = lobe_sphere_bounded(normal, LOBE_R(1.0));
    lobe_vec3 w = lobe_sphere_bounded(view, LOBE_R(1.0));
    lobe_vec3 c = lobe_sphere_bounded(to_centre, LOBE_R(1e18));
    LOBE_LET distance = lobe_max(lobe_sqrt(lobe_vec3_dot(c, c)), LOBE_R(1e-15));
    LOBE_LET inverse = LOBE_R(1.0) / distance;
    lobe_vec3 l = lobe_vec3_scale(c, inverse);
    LOBE_LET sine = lobe_clamp(radius, LOBE_R(0.0), LOBE_R(1e18)) / distance;
    LOBE_LET nv = lobe_vec3_dot(n, w);
    LOBE_LET nl = lobe_vec3_dot(n, l);
    LOBE_LET up = LOBE_R(0.5) * (nv + nl);
    LOBE_LET tx = LOBE_R(0.5) * (w.x + l.x) - up * n.x;
    LOBE_LET ty = LOBE_R(0.5) * (w.y + l.y) - up * n.y;
    LOBE_LET tz = LOBE_R(0.5) * (w.z + l.z) - up * n.z;
    LOBE_LET tangent2 = lobe_saturate(tx * tx + ty * ty + tz * tz);
    LOBE_LET n_dot_v = lobe_saturate(nv);
    LOBE_LET n_dot_l = lobe_clamp(nl, LOBE_R(-1.0), LOBE_R(1.0));
    return lobe_sphere_of(n_dot_v, n_dot_l, tangent2, sine);
}

#endif
