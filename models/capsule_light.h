/* Capsule lights: the points nearer than radius to a segment, of radiance 1, under GGX with height-correlated Smith and
 * F = 1; the reflected radiance. A capsule is a sphere on its segment, where the lobe has its centre of gravity, times
 * how many such spheres the lobe sees of the line. Derived in cases/capsule_light/README.md.
 *
 * lobe_capsule is the light in the frame of the surface: the point at the origin, the normal along z, the view towards
 * (sqrt(1 - n_dot_v^2), 0, n_dot_v). Lengths are in any unit, of which nothing depends.
 *   n_dot_v     height of the view, in [0, 1]
 *   mx, my, mz  middle of the segment
 *   ex, ey, ez  from there to one of its ends; all zero: a sphere
 *   radius      at least 0
 * Each kernel clamps them; NaN counts as the lower end. */
#ifndef LOBE_CAPSULE_LIGHT_H
#define LOBE_CAPSULE_LIGHT_H
#include "sphere_light.h"
#include "coeffs/capsule_light_low.h"
#include "coeffs/capsule_light_medium.h"

LOBE_STRUCT(lobe_capsule)
{
    lobe_real n_dot_v;
    lobe_real mx;
    lobe_real my;
    lobe_real mz;
    lobe_real ex;
    lobe_real ey;
    lobe_real ez;
    lobe_real radius;
};

/* What the tiers differ in, beside the sphere. */
LOBE_STRUCT(lobe_capsule_terms)
{
    lobe_real widen; /* the lobe along the line, by that part of the radius squared */
    lobe_real set;   /* where the line counts as set, in radii below the horizon: this for a line that stands up, */
    lobe_real level; /* and this more for one that lies level */
    lobe_real reach; /* how far the radius moves the line towards the mirror direction: radius^2 / (radius + reach a) */
    lobe_real turn;  /* powers of 1 + v.l and of the distance by which a light counts more, */
    lobe_real near;  /* beside the half vector's */
    lobe_real centre; /* of the line rather than the mirror direction: in a wide lobe, by this part of alpha^2 */
    lobe_real bend;   /* towards the plateau: y b / (1 + bend y (b - 1)) for b spheres of radiance y */
};

LOBE_FN lobe_capsule_terms lobe_capsule_terms_of(lobe_real widen, lobe_real set, lobe_real level, lobe_real reach,
                                                 lobe_real turn, lobe_real near, lobe_real centre, lobe_real bend)
{
    lobe_capsule_terms k;
    k.widen = widen;
    k.set = set;
    k.level = level;
    k.reach = reach;
    k.turn = turn;
    k.near = near;
    k.centre = centre;
    k.bend = bend;
    return k;
}

/* One sphere of the line, and the line in its measure. */
LOBE_STRUCT(lobe_capsule_strip)
{
    lobe_sphere light;
    lobe_real across;
    lobe_real spheres;
};

/* One sphere of the line, and how many more of them the lobe sees. */
LOBE_STRUCT(lobe_capsule_spot)
{
    lobe_sphere light;
    lobe_real more;
};

LOBE_FN lobe_capsule lobe_capsule_of(lobe_real n_dot_v, lobe_real mx, lobe_real my, lobe_real mz, lobe_real ex,
                                     lobe_real ey, lobe_real ez, lobe_real radius)
{
    lobe_capsule c;
    c.n_dot_v = n_dot_v;
    c.mx = mx;
    c.my = my;
    c.mz = mz;
    c.ex = ex;
    c.ey = ey;
    c.ez = ez;
    c.radius = radius;
    return c;
}

/* In the unit in which middle and half the segment have the length 1 together, or are both zero. */
LOBE_FN lobe_capsule lobe_capsule_clamped(lobe_capsule c)
{
    LOBE_LET most = LOBE_R(1e15);
    LOBE_LET mx = lobe_clamp(c.mx, -most, most);
    LOBE_LET my = lobe_clamp(c.my, -most, most);
    LOBE_LET mz = lobe_clamp(c.mz, -most, most);
    LOBE_LET ex = lobe_clamp(c.ex, -most, most);
    LOBE_LET ey = lobe_clamp(c.ey, -most, most);
    LOBE_LET ez = lobe_clamp(c.ez, -most, most);
    LOBE_LET r = lobe_clamp(c.radius, LOBE_R(0.0), most);
    LOBE_LET length2 = mx * mx + my * my + mz * mz + (ex * ex + ey * ey + ez * ez);
    LOBE_LET unit = LOBE_R(1.0) / lobe_max(lobe_sqrt(length2), LOBE_R(1e-15));
    lobe_capsule y;
    y.n_dot_v = lobe_saturate(c.n_dot_v);
    LOBE_LET ux = mx * unit;
    LOBE_LET uy = my * unit;
    LOBE_LET uz = mz * unit;
    LOBE_LET wx = ex * unit;
    LOBE_LET wy = ey * unit;
    LOBE_LET wz = ez * unit;
    LOBE_LET wide = lobe_min(r * unit, LOBE_R(2.0));
    y.mx = ux;
    y.my = uy;
    y.mz = uz;
    y.ex = wx;
    y.ey = wy;
    y.ez = wz;
    y.radius = wide;
    return y;
}

/* The sphere at t of the segment, half the length of the segment across the line of sight, as an angle, and how many
 * spheres cover as much as that strip: 4 / pi for each radius. */
LOBE_FN lobe_capsule_strip lobe_capsule_strip_at(lobe_capsule c, lobe_real vx, lobe_real t)
{
    LOBE_LET x = c.mx + t * c.ex;
    LOBE_LET y = c.my + t * c.ey;
    LOBE_LET z = c.mz + t * c.ez;
    LOBE_LET near = LOBE_R(1.0) / lobe_max(lobe_sqrt(x * x + y * y + z * z), LOBE_R(9.53674316e-7));
    LOBE_LET sine = lobe_clamp(c.radius * near, LOBE_R(1e-5), LOBE_R(1.0));
    LOBE_LET hx = vx + x * near;
    LOBE_LET hy = y * near;
    LOBE_LET hz = z * near;
    LOBE_LET tangent2 = LOBE_R(0.25) * (hx * hx + hy * hy);
    LOBE_LET along = (x * c.ex + y * c.ey + z * c.ez) * near;
    LOBE_LET ee = c.ex * c.ex + c.ey * c.ey + c.ez * c.ez;
    LOBE_LET across = lobe_sqrt(ee - along * along) * near;
    LOBE_LET spheres = LOBE_R(1.27323954) * (across / sine);
    lobe_sphere light = lobe_sphere_of(c.n_dot_v, hz, tangent2, sine);
    lobe_capsule_strip strip;
    strip.light = light;
    strip.across = across;
    strip.spheres = spheres;
    return strip;
}

/* The part of the segment that stands above the horizon, as far as terms say. */
LOBE_FN lobe_capsule lobe_capsule_risen(lobe_capsule c, lobe_capsule_terms k)
{
    LOBE_LET steep = lobe_max(c.ez, -c.ez);
    LOBE_LET level = c.radius / (c.radius + steep + LOBE_R(9.31322575e-10));
    LOBE_LET high = c.mz + c.radius * (k.set + k.level * level);
    LOBE_LET end = lobe_clamp(high / (steep + LOBE_R(8.67361738e-19)), LOBE_R(-1.0), LOBE_R(1.0));
    LOBE_LET half_length = LOBE_R(0.5) + LOBE_R(0.5) * end;
    LOBE_LET shift = LOBE_R(0.5) - LOBE_R(0.5) * end;
    LOBE_LET move = lobe_select(c.ez, shift, -shift);
    LOBE_LET mx = c.mx + move * c.ex;
    LOBE_LET my = c.my + move * c.ey;
    LOBE_LET mz = c.mz + move * c.ez;
    LOBE_LET ex = half_length * c.ex;
    LOBE_LET ey = half_length * c.ey;
    LOBE_LET ez = half_length * c.ez;
    return lobe_capsule_of(c.n_dot_v, mx, my, mz, ex, ey, ez, c.radius);
}

/* The line's GGX is 1 / N(t)^2 along the segment, t in [-1, 1], where N is a parabola; integral and centre of gravity
 * of that are known. h = p + |p| v is the half vector of the point p at t, in the unit of its distance; N is its length
 * after the lobe's stretch. */
LOBE_FN lobe_capsule_spot lobe_capsule_line(lobe_real roughness, lobe_capsule light, lobe_capsule_terms k)
{
    lobe_capsule whole = lobe_capsule_clamped(light);
    lobe_capsule c = lobe_capsule_risen(whole, k);
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET v = c.n_dot_v;
    LOBE_LET vx = lobe_sqrt((LOBE_R(1.0) - v) * (LOBE_R(1.0) + v));
    LOBE_LET r2 = c.radius * c.radius;
    LOBE_LET ee = c.ex * c.ex + c.ey * c.ey + c.ez * c.ez;
    /* t: nearest to the mirror direction in the lobe, which is v times as wide across as along; or rather the middle */
    LOBE_LET mu = v * (v * c.mx + vx * c.mz);
    LOBE_LET eu = v * (v * c.ex + vx * c.ez);
    LOBE_LET slant = eu * eu + c.ey * c.ey + k.centre * (a * a) + LOBE_R(8.67361738e-19);
    LOBE_LET t = lobe_clamp(-(mu * eu + c.my * c.ey) / slant, LOBE_R(-1.0), LOBE_R(1.0));
    LOBE_LET px = c.mx + t * c.ex;
    LOBE_LET py = c.my + t * c.ey;
    LOBE_LET pz = c.mz + t * c.ez;
    LOBE_LET d = lobe_max(lobe_sqrt(px * px + py * py + pz * pz), LOBE_R(9.53674316e-7));
    LOBE_LET far = LOBE_R(1.0) / d;
    /* N there, its slope and its curvature; away: those of the distance */
    LOBE_LET away = (px * c.ex + py * c.ey + pz * c.ez) * far;
    LOBE_LET away2 = lobe_max(ee - away * away, LOBE_R(0.0)) * far;
    LOBE_LET hx = px + d * vx;
    LOBE_LET hz = a * (pz + d * v);
    LOBE_LET bx = c.ex + away * vx;
    LOBE_LET bz = a * (c.ez + away * v);
    LOBE_LET tangent2 = hx * hx + py * py;
    LOBE_LET reach = (c.radius + k.reach * (a * d)) * lobe_sqrt(tangent2) + LOBE_R(9.09494702e-13);
    LOBE_LET left = lobe_saturate(LOBE_R(1.0) - r2 / reach);
    LOBE_LET n0 = left * left * tangent2 + hz * hz + k.widen * r2 + LOBE_R(9.31322575e-10);
    LOBE_LET n1 = hx * bx + py * c.ey + hz * bz;
    LOBE_LET n2 = bx * bx + c.ey * c.ey + bz * bz + (hx * vx + a * (hz * v)) * away2;
    /* what else varies along the line, as the first terms of its series: powers of |p| + p.v and of |p| */
    LOBE_LET toward = LOBE_R(1.0) / lobe_max(d + px * vx + pz * v, LOBE_R(0.00390625) * d);
    LOBE_LET y1 = (away + (c.ex * vx + c.ez * v)) * toward;
    LOBE_LET l1 = away * far;
    LOBE_LET f1 = k.near * l1 - k.turn * y1;
    LOBE_LET f2 = LOBE_R(0.5) * (f1 * f1 + k.turn * (y1 * y1 - toward * away2) - k.near * (l1 * l1 - far * away2));
    LOBE_LET inverse = LOBE_R(1.0) / n0;
    LOBE_LET slope = n1 * inverse;
    LOBE_LET s = slope + LOBE_R(0.5) * f1;
    LOBE_LET bow = lobe_max(n2 * inverse + (slope + slope) * f1 + f2 - s * s, LOBE_R(0.0001220703125) * (s * s));
    /* N over n0 is (1 + s x)^2 + bow x^2, x from t: at the ends, mixed, and its discriminant */
    LOBE_LET x0 = LOBE_R(-1.0) - t;
    LOBE_LET x1 = LOBE_R(1.0) - t;
    LOBE_LET i0 = LOBE_R(1.0) + s * x0;
    LOBE_LET i1 = LOBE_R(1.0) + s * x1;
    LOBE_LET at0 = i0 * i0 + bow * (x0 * x0);
    LOBE_LET at1 = i1 * i1 + bow * (x1 * x1);
    LOBE_LET mixed = i0 * i1 + bow * (x0 * x1);
    LOBE_LET both = lobe_max(at0 * at1, LOBE_R(7.88860905e-31));
    LOBE_LET root = lobe_sqrt(both);
    LOBE_LET q2 = LOBE_R(4.0) * bow;
    LOBE_LET q = lobe_sqrt(q2);
    /* the integral: 1 / both, and an arc of the angle whose cotangent is mixed / q; w / q is the cotangent of half */
    LOBE_LET w = lobe_select(mixed, root + mixed, q2 / (root + lobe_max(-mixed, LOBE_R(0.0)) + LOBE_R(1.35525272e-20)));
    LOBE_LET w2 = w * w;
    LOBE_LET bulge = LOBE_R(0.375) + LOBE_R(0.518345) * q2 / (w2 + LOBE_R(0.946435) * q2 + LOBE_R(1.35525272e-20));
    LOBE_LET arc = LOBE_R(1.0) / (LOBE_R(0.636619772) * (q2 * q) + w2 * w * bulge + LOBE_R(1.35525272e-20));
    LOBE_LET sum = LOBE_R(1.0) / both + LOBE_R(4.0) * (s * s + bow) * arc;
    LOBE_LET place = lobe_saturate(LOBE_R(0.5) - LOBE_R(0.5) * (at1 - at0) * arc / sum);
    /* the sphere at the centre of gravity */
    LOBE_LET u = place + place - LOBE_R(1.0);
    LOBE_LET x = u - t;
    LOBE_LET i = LOBE_R(1.0) + s * x;
    LOBE_LET here = i * i + bow * (x * x);
    lobe_capsule_strip strip = lobe_capsule_strip_at(c, vx, u);
    LOBE_LET more = strip.spheres * (here * here * sum);
    lobe_capsule_spot spot;
    spot.light = strip.light;
    spot.more = more;
    return spot;
}

/* From the radiance y of the one sphere. */
LOBE_FN lobe_real lobe_capsule_bent(lobe_real y, lobe_real more, lobe_real bend)
{
    LOBE_LET m = lobe_clamp(more, LOBE_R(0.0), LOBE_R(1e15));
    LOBE_LET top = y + y * m;
    LOBE_LET all = lobe_saturate(top / (LOBE_R(1.0) + bend * (y * m)));
    return all;
}

/* The sphere stands where the segment is nearest to the mirror direction, but only as far from its middle as the line
 * is longer than the lobe is wide; of the line the lobe takes the part seen / (seen + length), as angles. */
LOBE_FN lobe_real lobe_capsule_light_low(LOBE_COEFFS lobe_real roughness, lobe_capsule light)
{
    LOBE_LET none = LOBE_R(0.0);
    LOBE_LET level = LOBE_R(1.0);
    lobe_capsule_terms k = lobe_capsule_terms_of(none, none, level, none, none, none, none, none);
    lobe_capsule whole = lobe_capsule_clamped(light);
    lobe_capsule c = lobe_capsule_risen(whole, k);
    LOBE_LET a = lobe_sphere_alpha(roughness);
    LOBE_LET v = c.n_dot_v;
    LOBE_LET vx = lobe_sqrt((LOBE_R(1.0) - v) * (LOBE_R(1.0) + v));
    LOBE_LET mu = v * (v * c.mx + vx * c.mz);
    LOBE_LET eu = v * (v * c.ex + vx * c.ez);
    LOBE_LET ee = c.ex * c.ex + c.ey * c.ey + c.ez * c.ez;
    LOBE_LET slant = eu * eu + c.ey * c.ey + (LOBE_R(9.53674316e-7) * ee + LOBE_R(8.67361738e-19));
    LOBE_LET nearest = lobe_clamp(-(mu * eu + c.my * c.ey) / slant, LOBE_R(-1.0), LOBE_R(1.0));
    LOBE_LET extent = lobe_sqrt(ee);
    LOBE_LET t = nearest * extent / (extent + LOBE_CAPSULE_LIGHT_LOW_C0 * a);
    LOBE_LET seen = a * (LOBE_CAPSULE_LIGHT_LOW_C1 + LOBE_CAPSULE_LIGHT_LOW_C2 * v);
    lobe_capsule_strip strip = lobe_capsule_strip_at(c, vx, t);
    LOBE_LET part = seen / (seen + strip.across);
    LOBE_LET more = strip.spheres * part;
    LOBE_LET y = lobe_sphere_light_low(roughness, strip.light);
    LOBE_LET bend = LOBE_CAPSULE_LIGHT_LOW_C3;
    return lobe_capsule_bent(y, more, bend);
}

LOBE_FN lobe_real lobe_capsule_light_medium(LOBE_COEFFS lobe_real roughness, lobe_capsule light)
{
    lobe_capsule_terms k =
        lobe_capsule_terms_of(LOBE_CAPSULE_LIGHT_MEDIUM_C0, LOBE_CAPSULE_LIGHT_MEDIUM_C1, LOBE_CAPSULE_LIGHT_MEDIUM_C2,
                              LOBE_CAPSULE_LIGHT_MEDIUM_C3, LOBE_CAPSULE_LIGHT_MEDIUM_C4, LOBE_CAPSULE_LIGHT_MEDIUM_C5,
                              LOBE_CAPSULE_LIGHT_MEDIUM_C6, LOBE_CAPSULE_LIGHT_MEDIUM_C7);
    lobe_capsule_spot spot = lobe_capsule_line(roughness, light, k);
    LOBE_LET y = lobe_sphere_light_medium(roughness, spot.light);
    return lobe_capsule_bent(y, spot.more, k.bend);
}

#endif
