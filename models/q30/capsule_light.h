/* What the q30 tiers of capsule lights share: the formulas of ../capsule_light.h, in their letters and the order of
 * their lines, in numbers with a block exponent (core/q30_scaled.h), none of which can overflow. Middle, arm and radius
 * come as integers of one unit, whatever that is; the first step divides by their length. */
#ifndef LOBE_Q30_CAPSULE_LIGHT_H
#define LOBE_Q30_CAPSULE_LIGHT_H
#include "sphere_light.h"

typedef struct lobe_capsule_scaled {
    int32_t n_dot_v;     /* Q30, in [0, 1) */
    lobe_q_scaled v, vx; /* height and length along the surface of the view */
    lobe_q_scaled m[3], e[3], r;
} lobe_capsule_scaled;

typedef struct lobe_capsule_terms_scaled {
    lobe_q_scaled widen, set, level, reach, turn, near, centre, bend;
} lobe_capsule_terms_scaled;

typedef struct lobe_capsule_strip_scaled {
    lobe_sphere_q30 light;
    lobe_q_scaled across, spheres;
} lobe_capsule_strip_scaled;

typedef struct lobe_capsule_spot_scaled {
    lobe_sphere_q30 light;
    lobe_q_scaled more;
} lobe_capsule_spot_scaled;

static const lobe_q_scaled lobe_qs_one = {LOBE_Q30_ONE / 2, 1};
static const lobe_q_scaled lobe_qs_half = {LOBE_Q30_ONE / 2, 0};
static const lobe_q_scaled lobe_qs_zero = {0, LOBE_QS_ZERO};

/* 2^n */
static inline lobe_q_scaled lobe_qs_two_to(int32_t n) { return lobe_qs_made(LOBE_Q30_ONE / 2, n + 1); }

static inline lobe_q_scaled lobe_qs_max(lobe_q_scaled a, lobe_q_scaled b) { return lobe_qs_less(a, b) ? b : a; }

static inline lobe_q_scaled lobe_qs_min(lobe_q_scaled a, lobe_q_scaled b) { return lobe_qs_less(a, b) ? a : b; }

static inline lobe_q_scaled lobe_qs_clamp(lobe_q_scaled a, lobe_q_scaled lo, lobe_q_scaled hi)
{
    return lobe_qs_min(lobe_qs_max(a, lo), hi);
}

static inline lobe_q_scaled lobe_qs_dot(const lobe_q_scaled a[3], const lobe_q_scaled b[3])
{
    return lobe_qs_add(lobe_qs_add(lobe_qs_mul(a[0], b[0]), lobe_qs_mul(a[1], b[1])), lobe_qs_mul(a[2], b[2]));
}

/* a + b c */
static inline lobe_q_scaled lobe_qs_mad(lobe_q_scaled a, lobe_q_scaled b, lobe_q_scaled c)
{
    return lobe_qs_add(a, lobe_qs_mul(b, c));
}

/* All but INT32_MIN is what lobe_qs_of takes. */
static inline lobe_q_scaled lobe_capsule_component(int32_t x)
{
    return lobe_qs_of(lobe_q_clamp(x, -0x7ffffffe, 0x7ffffffe), 0);
}

static inline lobe_capsule_scaled lobe_capsule_clamped_q30(lobe_capsule_q30 c)
{
    lobe_capsule_scaled y;
    lobe_q_scaled unit;
    int k;
    y.n_dot_v = lobe_q_clamp(c.n_dot_v, 0, LOBE_Q_BELOW_ONE);
    y.v = lobe_qs_of(y.n_dot_v, 0);
    y.vx = lobe_qs_sqrt(lobe_qs_mul(lobe_qs_of(LOBE_Q30_ONE - y.n_dot_v, 0),
                                    lobe_qs_of((int32_t)(((uint32_t)LOBE_Q30_ONE + (uint32_t)y.n_dot_v) >> 1), 1)));
    y.m[0] = lobe_capsule_component(c.middle.x);
    y.m[1] = lobe_capsule_component(c.middle.y);
    y.m[2] = lobe_capsule_component(c.middle.z);
    y.e[0] = lobe_capsule_component(c.arm.x);
    y.e[1] = lobe_capsule_component(c.arm.y);
    y.e[2] = lobe_capsule_component(c.arm.z);
    y.r = lobe_capsule_component(lobe_q_clamp(c.radius, 0, 0x7ffffffe));
    /* a length of 0 counts as a unit in the last place: those components are 0 */
    unit = lobe_qs_max(lobe_qs_sqrt(lobe_qs_add(lobe_qs_dot(y.m, y.m), lobe_qs_dot(y.e, y.e))), lobe_qs_two_to(-30));
    for (k = 0; k < 3; k++) {
        y.m[k] = lobe_qs_div(y.m[k], unit);
        y.e[k] = lobe_qs_div(y.e[k], unit);
    }
    y.r = lobe_qs_min(lobe_qs_div(y.r, unit), lobe_qs_two_to(1));
    return y;
}

static inline lobe_q_scaled lobe_capsule_point(const lobe_capsule_scaled *c, lobe_q_scaled t, int k)
{
    return lobe_qs_mad(c->m[k], t, c->e[k]);
}

/* 10737 is 1e-5, as in sphere_light.h. The strip is measured in the sine that the sphere is given. */
static inline lobe_capsule_strip_scaled lobe_capsule_strip_q30(const lobe_capsule_scaled *c, lobe_q_scaled t)
{
    static const lobe_q_scaled spheres = LOBE_QS_CONSTANT(1.27323954);
    lobe_capsule_strip_scaled y;
    lobe_q_scaled p[3], near, hx, hy, along, ee;
    int k;
    for (k = 0; k < 3; k++)
        p[k] = lobe_capsule_point(c, t, k);
    near = lobe_qs_div(lobe_qs_one, lobe_qs_max(lobe_qs_sqrt(lobe_qs_dot(p, p)), lobe_qs_two_to(-20)));
    hx = lobe_qs_mad(c->vx, p[0], near);
    hy = lobe_qs_mul(p[1], near);
    along = lobe_qs_mul(lobe_qs_dot(p, c->e), near);
    ee = lobe_qs_dot(c->e, c->e);
    y.light.n_dot_v = c->n_dot_v;
    y.light.n_dot_l = lobe_q_clamp(lobe_qs_fixed(lobe_qs_mul(p[2], near), 30), -LOBE_Q30_ONE, LOBE_Q30_ONE);
    y.light.tangent2 = lobe_qs_fixed(lobe_qs_shifted(lobe_qs_mad(lobe_qs_mul(hx, hx), hy, hy), -2), 30);
    y.light.sine = lobe_q_clamp(lobe_qs_fixed(lobe_qs_mul(c->r, near), 30), 10737, LOBE_Q30_ONE);
    y.across = lobe_qs_mul(lobe_qs_sqrt(lobe_qs_sub(ee, lobe_qs_mul(along, along))), near);
    y.spheres = lobe_qs_mul(spheres, lobe_qs_div(y.across, lobe_qs_of(y.light.sine, 0)));
    return y;
}

static inline void lobe_capsule_risen_q30(lobe_capsule_scaled *c, lobe_q_scaled set, lobe_q_scaled level)
{
    const lobe_q_scaled steep = c->e[2].m < 0 ? lobe_qs_negative(c->e[2]) : c->e[2];
    const lobe_q_scaled lying = lobe_qs_div(c->r, lobe_qs_add(lobe_qs_add(c->r, steep), lobe_qs_two_to(-30)));
    const lobe_q_scaled high = lobe_qs_mad(c->m[2], c->r, lobe_qs_mad(set, level, lying));
    const lobe_q_scaled end = lobe_qs_clamp(lobe_qs_div(high, lobe_qs_add(steep, lobe_qs_two_to(-60))),
                                            lobe_qs_negative(lobe_qs_one), lobe_qs_one);
    const lobe_q_scaled length = lobe_qs_mad(lobe_qs_half, lobe_qs_half, end);
    const lobe_q_scaled shift = lobe_qs_sub(lobe_qs_half, lobe_qs_mul(lobe_qs_half, end));
    const lobe_q_scaled move = c->e[2].m > 0 ? shift : lobe_qs_negative(shift);
    int k;
    for (k = 0; k < 3; k++) {
        c->m[k] = lobe_qs_mad(c->m[k], move, c->e[k]);
        c->e[k] = lobe_qs_mul(length, c->e[k]);
    }
}

/* Where the segment is nearest to the mirror direction; least: what slant is at least. */
static inline lobe_q_scaled lobe_capsule_nearest_q30(const lobe_capsule_scaled *c, lobe_q_scaled least)
{
    const lobe_q_scaled mu = lobe_qs_mul(c->v, lobe_qs_mad(lobe_qs_mul(c->v, c->m[0]), c->vx, c->m[2]));
    const lobe_q_scaled eu = lobe_qs_mul(c->v, lobe_qs_mad(lobe_qs_mul(c->v, c->e[0]), c->vx, c->e[2]));
    const lobe_q_scaled slant = lobe_qs_add(lobe_qs_mad(lobe_qs_mul(eu, eu), c->e[1], c->e[1]), least);
    const lobe_q_scaled t = lobe_qs_div(lobe_qs_mad(lobe_qs_mul(mu, eu), c->m[1], c->e[1]), slant);
    return lobe_qs_clamp(lobe_qs_negative(t), lobe_qs_negative(lobe_qs_one), lobe_qs_one);
}

/* alpha, as lobe_sphere_alpha: 33954698 is the root of 1e-3. */
static inline lobe_q_scaled lobe_capsule_alpha_q30(int32_t roughness)
{
    const lobe_q_scaled root = lobe_qs_of(lobe_q_clamp(roughness, 33954698, LOBE_Q30_ONE), 0);
    return lobe_qs_mul(root, root);
}

/* The parabola N over its value at t: (1 + s x)^2 + bow x^2. */
typedef struct lobe_capsule_parabola {
    lobe_q_scaled t, s, bow;
} lobe_capsule_parabola;

static inline lobe_q_scaled lobe_capsule_parabola_at(const lobe_capsule_parabola *f, lobe_q_scaled x)
{
    const lobe_q_scaled i = lobe_qs_mad(lobe_qs_one, f->s, x);
    return lobe_qs_mad(lobe_qs_mul(i, i), f->bow, lobe_qs_mul(x, x));
}

static inline lobe_capsule_parabola lobe_capsule_parabola_of(const lobe_capsule_scaled *c, lobe_q_scaled a,
                                                             const lobe_capsule_terms_scaled *k)
{
    const lobe_q_scaled least = lobe_qs_mad(lobe_qs_two_to(-60), k->centre, lobe_qs_mul(a, a));
    const lobe_q_scaled t = lobe_capsule_nearest_q30(c, least);
    const lobe_q_scaled p[3] = {lobe_capsule_point(c, t, 0), lobe_capsule_point(c, t, 1), lobe_capsule_point(c, t, 2)};
    const lobe_q_scaled r2 = lobe_qs_mul(c->r, c->r);
    const lobe_q_scaled d = lobe_qs_max(lobe_qs_sqrt(lobe_qs_dot(p, p)), lobe_qs_two_to(-20));
    const lobe_q_scaled far = lobe_qs_div(lobe_qs_one, d);
    const lobe_q_scaled away = lobe_qs_mul(lobe_qs_dot(p, c->e), far);
    const lobe_q_scaled across2 = lobe_qs_sub(lobe_qs_dot(c->e, c->e), lobe_qs_mul(away, away));
    const lobe_q_scaled away2 = lobe_qs_mul(lobe_qs_positive(across2), far);
    const lobe_q_scaled hx = lobe_qs_mad(p[0], d, c->vx);
    const lobe_q_scaled hz = lobe_qs_mul(a, lobe_qs_mad(p[2], d, c->v));
    const lobe_q_scaled bx = lobe_qs_mad(c->e[0], away, c->vx);
    const lobe_q_scaled bz = lobe_qs_mul(a, lobe_qs_mad(c->e[2], away, c->v));
    const lobe_q_scaled tangent2 = lobe_qs_mad(lobe_qs_mul(hx, hx), p[1], p[1]);
    const lobe_q_scaled reach =
        lobe_qs_mad(lobe_qs_two_to(-40), lobe_qs_mad(c->r, k->reach, lobe_qs_mul(a, d)), lobe_qs_sqrt(tangent2));
    const lobe_q_scaled left = lobe_qs_positive(lobe_qs_sub(lobe_qs_one, lobe_qs_div(r2, reach)));
    const lobe_q_scaled n0 = lobe_qs_add(lobe_qs_mad(lobe_qs_mul(lobe_qs_mul(left, left), tangent2), hz, hz),
                                         lobe_qs_mad(lobe_qs_two_to(-30), k->widen, r2));
    const lobe_q_scaled n1 = lobe_qs_mad(lobe_qs_mad(lobe_qs_mul(hx, bx), p[1], c->e[1]), hz, bz);
    const lobe_q_scaled n2 =
        lobe_qs_add(lobe_qs_mad(lobe_qs_mad(lobe_qs_mul(bx, bx), c->e[1], c->e[1]), bz, bz),
                    lobe_qs_mul(lobe_qs_mad(lobe_qs_mul(hx, c->vx), a, lobe_qs_mul(hz, c->v)), away2));
    const lobe_q_scaled turned = lobe_qs_mad(lobe_qs_mad(d, p[0], c->vx), p[2], c->v);
    const lobe_q_scaled toward = lobe_qs_div(lobe_qs_one, lobe_qs_max(turned, lobe_qs_shifted(d, -8)));
    const lobe_q_scaled y1 =
        lobe_qs_mul(lobe_qs_add(away, lobe_qs_mad(lobe_qs_mul(c->e[0], c->vx), c->e[2], c->v)), toward);
    const lobe_q_scaled l1 = lobe_qs_mul(away, far);
    const lobe_q_scaled f1 = lobe_qs_sub(lobe_qs_mul(k->near, l1), lobe_qs_mul(k->turn, y1));
    const lobe_q_scaled y2 = lobe_qs_sub(lobe_qs_mul(y1, y1), lobe_qs_mul(toward, away2));
    const lobe_q_scaled l2 = lobe_qs_sub(lobe_qs_mul(l1, l1), lobe_qs_mul(far, away2));
    const lobe_q_scaled twice_f2 = lobe_qs_sub(lobe_qs_mad(lobe_qs_mul(f1, f1), k->turn, y2), lobe_qs_mul(k->near, l2));
    const lobe_q_scaled inverse = lobe_qs_div(lobe_qs_one, n0);
    const lobe_q_scaled slope = lobe_qs_mul(n1, inverse);
    const lobe_q_scaled s = lobe_qs_add(slope, lobe_qs_shifted(f1, -1));
    const lobe_q_scaled s2 = lobe_qs_mul(s, s);
    const lobe_q_scaled curve =
        lobe_qs_mad(lobe_qs_mad(lobe_qs_shifted(twice_f2, -1), n2, inverse), lobe_qs_shifted(slope, 1), f1);
    lobe_capsule_parabola f;
    f.t = t;
    f.s = s;
    f.bow = lobe_qs_max(lobe_qs_sub(curve, s2), lobe_qs_shifted(s2, -13));
    return f;
}

static inline lobe_capsule_spot_scaled lobe_capsule_line_q30(int32_t roughness, lobe_capsule_q30 light,
                                                             const lobe_capsule_terms_scaled *k)
{
    static const lobe_q_scaled three_eighths = LOBE_QS_CONSTANT(0.375), swell = LOBE_QS_CONSTANT(0.518345);
    static const lobe_q_scaled fade = LOBE_QS_CONSTANT(0.946435), two_over_pi = LOBE_QS_CONSTANT(0.636619772);
    lobe_capsule_scaled c = lobe_capsule_clamped_q30(light);
    lobe_capsule_risen_q30(&c, k->set, k->level);
    {
        const lobe_capsule_parabola f = lobe_capsule_parabola_of(&c, lobe_capsule_alpha_q30(roughness), k);
        const lobe_q_scaled x0 = lobe_qs_sub(lobe_qs_negative(lobe_qs_one), f.t), x1 = lobe_qs_sub(lobe_qs_one, f.t);
        const lobe_q_scaled at0 = lobe_capsule_parabola_at(&f, x0), at1 = lobe_capsule_parabola_at(&f, x1);
        const lobe_q_scaled i0 = lobe_qs_mad(lobe_qs_one, f.s, x0), i1 = lobe_qs_mad(lobe_qs_one, f.s, x1);
        const lobe_q_scaled mixed = lobe_qs_mad(lobe_qs_mul(i0, i1), f.bow, lobe_qs_mul(x0, x1));
        const lobe_q_scaled both = lobe_qs_max(lobe_qs_mul(at0, at1), lobe_qs_two_to(-100));
        const lobe_q_scaled root = lobe_qs_sqrt(both);
        const lobe_q_scaled q2 = lobe_qs_shifted(f.bow, 2), q = lobe_qs_sqrt(q2), tiny = lobe_qs_two_to(-66);
        const lobe_q_scaled w =
            mixed.m > 0 ? lobe_qs_add(root, mixed) : lobe_qs_div(q2, lobe_qs_add(lobe_qs_sub(root, mixed), tiny));
        const lobe_q_scaled w2 = lobe_qs_mul(w, w);
        const lobe_q_scaled bulge = lobe_qs_add(
            three_eighths, lobe_qs_div(lobe_qs_mul(swell, q2), lobe_qs_add(lobe_qs_mad(w2, fade, q2), tiny)));
        const lobe_q_scaled bottom =
            lobe_qs_mad(lobe_qs_mul(two_over_pi, lobe_qs_mul(q2, q)), lobe_qs_mul(w2, w), bulge);
        const lobe_q_scaled arc = lobe_qs_div(lobe_qs_one, lobe_qs_add(bottom, tiny));
        const lobe_q_scaled spread = lobe_qs_shifted(lobe_qs_mad(f.bow, f.s, f.s), 2);
        const lobe_q_scaled sum = lobe_qs_mad(lobe_qs_div(lobe_qs_one, both), spread, arc);
        const lobe_q_scaled tilt = lobe_qs_div(lobe_qs_mul(lobe_qs_sub(at1, at0), arc), sum);
        /* u = 2 place - 1 */
        const lobe_q_scaled u = lobe_qs_clamp(lobe_qs_negative(tilt), lobe_qs_negative(lobe_qs_one), lobe_qs_one);
        const lobe_q_scaled here = lobe_capsule_parabola_at(&f, lobe_qs_sub(u, f.t));
        const lobe_capsule_strip_scaled strip = lobe_capsule_strip_q30(&c, u);
        lobe_capsule_spot_scaled spot;
        spot.light = strip.light;
        spot.more = lobe_qs_mul(strip.spheres, lobe_qs_mul(lobe_qs_mul(here, here), sum));
        return spot;
    }
}

static inline lobe_scaled_q30 lobe_capsule_bent_q30(lobe_scaled_q30 radiance, lobe_q_scaled more, lobe_q_scaled bend)
{
    const lobe_q_scaled y = lobe_qs_of(radiance.mantissa, radiance.exponent);
    const lobe_q_scaled line = lobe_qs_mul(y, lobe_qs_positive(more));
    const lobe_q_scaled top = lobe_qs_add(y, line), bottom = lobe_qs_mad(lobe_qs_one, bend, line);
    return lobe_sphere_radiance_q30(lobe_qs_div(top, bottom));
}

#endif
