/* A capsule light as a point sees it: from directions and positions to the numbers that every tier takes. */
#ifndef LOBE_CAPSULE_LIGHT_SEEN_H
#define LOBE_CAPSULE_LIGHT_SEEN_H
#include "../core/frame.h"
#include "capsule_light.h"
#include "sphere_light_seen.h"

/* normal and view are unit vectors; to_end0 and to_end1 go from the point to the two ends of the segment, in the unit
 * of radius. Where the view stands on the normal any tangent will do: the part of the view along the surface is
 * rounding there, and so is what that turns. */
LOBE_FN lobe_capsule lobe_capsule_seen(lobe_vec3 normal, lobe_vec3 view, lobe_vec3 to_end0, lobe_vec3 to_end1,
                                       lobe_real radius)
{
    lobe_vec3 n = lobe_sphere_bounded(normal, LOBE_R(1.0));
    lobe_vec3 w = lobe_sphere_bounded(view, LOBE_R(1.0));
    lobe_vec3 p = lobe_sphere_bounded(to_end0, LOBE_R(1e15));
    lobe_vec3 q = lobe_sphere_bounded(to_end1, LOBE_R(1e15));
    lobe_frame any = lobe_frame_around(n);
    LOBE_LET nv = lobe_vec3_dot(n, w);
    LOBE_LET sx = w.x - nv * n.x;
    LOBE_LET sy = w.y - nv * n.y;
    LOBE_LET sz = w.z - nv * n.z;
    LOBE_LET s2 = sx * sx + sy * sy + sz * sz;
    LOBE_LET enough = s2 - LOBE_R(1e-12);
    LOBE_LET inverse = LOBE_R(1.0) / lobe_sqrt(lobe_max(s2, LOBE_R(1e-12)));
    LOBE_LET tx = lobe_select(enough, sx * inverse, any.tangent.x);
    LOBE_LET ty = lobe_select(enough, sy * inverse, any.tangent.y);
    LOBE_LET tz = lobe_select(enough, sz * inverse, any.tangent.z);
    lobe_vec3 t = lobe_vec3_of(tx, ty, tz);
    lobe_vec3 b = lobe_vec3_cross(n, t);
    LOBE_LET mx = LOBE_R(0.5) * (p.x + q.x);
    LOBE_LET my = LOBE_R(0.5) * (p.y + q.y);
    LOBE_LET mz = LOBE_R(0.5) * (p.z + q.z);
    LOBE_LET ex = LOBE_R(0.5) * (q.x - p.x);
    LOBE_LET ey = LOBE_R(0.5) * (q.y - p.y);
    LOBE_LET ez = LOBE_R(0.5) * (q.z - p.z);
    lobe_vec3 m = lobe_vec3_of(mx, my, mz);
    lobe_vec3 e = lobe_vec3_of(ex, ey, ez);
    LOBE_LET n_dot_v = lobe_saturate(nv);
    LOBE_LET wide = lobe_clamp(radius, LOBE_R(0.0), LOBE_R(1e15));
    LOBE_LET um = lobe_vec3_dot(t, m);
    LOBE_LET vm = lobe_vec3_dot(b, m);
    LOBE_LET wm = lobe_vec3_dot(n, m);
    LOBE_LET ue = lobe_vec3_dot(t, e);
    LOBE_LET ve = lobe_vec3_dot(b, e);
    LOBE_LET we = lobe_vec3_dot(n, e);
    return lobe_capsule_of(n_dot_v, um, vm, wm, ue, ve, we, wide);
}

#endif
