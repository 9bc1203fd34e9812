/* What the q30 tiers of sphere_diffuse share.
 *
 * All terms are of the third degree in n_dot_l and sine together, but for factors that tend to constants as the light
 * shrinks. So both are shifted left by one count, e, until the sine is in [1/2, 1], the formula is worked out there in
 * Q30, and e is left to the exponent of the result: 3 e, or 2 e where the whole light is up and only sine^2 is small.
 * No precision is lost on a light of a hundredth of a degree. */
#ifndef LOBE_Q30_SPHERE_DIFFUSE_H
#define LOBE_Q30_SPHERE_DIFFUSE_H
#include "../lobe.h"
#include "../../core/q30_sqrt.h"

/* A coefficient of models/coeffs, folded when this is compiled. */
#define LOBE_SPHERE_DIFFUSE_Q(x) ((int32_t)((double)(x)*1073741824.0 + ((double)(x) < 0.0 ? -0.5 : 0.5)))

/* The light where the horizon cuts it, -s < c < s; c and s are shifted left by e. cosine is that of the half angle. */
typedef struct lobe_sphere_cut {
    int32_t c, s, s2, k, cosine;
    int e;
} lobe_sphere_cut;

/* m / 2^30 * 2^exponent for m in [0, 2^30 + a few]: normalised. */
static inline lobe_scaled_q30 lobe_sphere_diffuse_scaled(int32_t m, int exponent)
{
    lobe_scaled_q30 y = {0, 0};
    const int32_t held = lobe_q_saturate(m);
    if (held > 0) {
        const int z = held == LOBE_Q30_ONE ? 0 : lobe_q_headroom(held) - 1;
        y.mantissa = (int32_t)((uint32_t)held << z);
        y.exponent = exponent - z;
    }
    return y;
}

/* A root with the relative precision of its argument: value / 2^(30 + shift). */
typedef struct lobe_sphere_root {
    int32_t value;
    int shift;
} lobe_sphere_root;

/* sqrt(2 h t) for h, t in [0, 1] with 2 h t <= 1. */
static inline lobe_sphere_root lobe_sphere_diffuse_fine_root(int32_t h, int32_t t)
{
    lobe_sphere_root y = {0, 16};
    int z;
    if (h <= 0)
        return y;
    z = lobe_q_headroom(h) - 1;
    if (z < 1) {
        y.value = lobe_q_sqrt(lobe_q_mul(h, t, 29));
        y.shift = 0;
    } else {
        z = (z - 1) | 1; /* odd, so that 2 h t 2^(z - 1) has an even shift */
        y.value = lobe_q_sqrt(lobe_q_mul((int32_t)((uint32_t)h << z), t, 30));
        y.shift = (z - 1) / 2;
    }
    return y;
}

static inline int32_t lobe_sphere_diffuse_root(int32_t h, int32_t t)
{
    const lobe_sphere_root y = lobe_sphere_diffuse_fine_root(h, t);
    return lobe_q_shift_right(y.value, y.shift);
}

/* sqrt(1 - x^2) = sqrt((1 - x)(1 + x)) for x in [0, 1]. */
static inline lobe_sphere_root lobe_sphere_diffuse_fine_across(int32_t x)
{
    const int32_t h = LOBE_Q30_ONE - x;
    return lobe_sphere_diffuse_fine_root(h, LOBE_Q30_ONE - (h >> 1));
}

static inline int32_t lobe_sphere_diffuse_across(int32_t x)
{
    const int32_t h = LOBE_Q30_ONE - x;
    return lobe_sphere_diffuse_root(h, LOBE_Q30_ONE - (h >> 1));
}

static inline int32_t lobe_sphere_diffuse_magnitude(int32_t c) { return c < 0 ? -c : c; }

/* 1, and cut is filled, where the horizon cuts the light; else 0, and y is the result. */
static inline int lobe_sphere_diffuse_cut(int32_t n_dot_l, int32_t sine, lobe_sphere_cut *cut, lobe_scaled_q30 *y)
{
    const int32_t c = lobe_q_clamp(n_dot_l, -LOBE_Q30_ONE, LOBE_Q30_ONE), s = lobe_q_saturate(sine);
    int32_t h;
    *y = lobe_sphere_diffuse_scaled(0, 0);
    if (s == 0 || c <= -s)
        return 0;
    cut->e = s == LOBE_Q30_ONE ? 0 : lobe_q_headroom(s) - 1;
    cut->s = (int32_t)((uint32_t)s << cut->e);
    cut->s2 = lobe_q_mul(cut->s, cut->s, 30);
    if (c >= s) {
        const int up = c == LOBE_Q30_ONE ? 0 : lobe_q_headroom(c) - 1;
        *y = lobe_sphere_diffuse_scaled(lobe_q_mul(cut->s2, (int32_t)((uint32_t)c << up), 30), -2 * cut->e - up);
        return 0;
    }
    cut->c = (int32_t)((uint32_t)c << cut->e);
    h = cut->s - lobe_sphere_diffuse_magnitude(cut->c);
    cut->k = lobe_q_mul(h, cut->s - (h >> 1), 29);
    cut->cosine = lobe_sphere_diffuse_across(s);
    return 1;
}

#endif
