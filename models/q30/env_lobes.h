/* What the q30 tiers of environment lobes share: the formulas of ../env_lobes.h, with its letters.
 *
 * The twelve products and their sums are fixed point, Q30 and Q20: no sum leaves 32 bits (env_lobes_rows.h). What spans
 * more, a, a s and the widths, has a block exponent and cannot overflow; results are held at the ends of Q30. The
 * albedo is lobe_energy_high_q30. */
#ifndef LOBE_Q30_ENV_LOBES_H
#define LOBE_Q30_ENV_LOBES_H
#include "../lobe.h"
#include "../../core/q30_arc.h"
#include "../../core/q30_exp2.h"
#include "env_lobes_rows.h"

typedef struct lobe_env_fixed {
    lobe_q_scaled a, reach;
    int32_t theta, e;
    int32_t f[LOBE_ENV_COLUMNS]; /* Q30, in [0, 1]; the first is 1 */
} lobe_env_fixed;

/* 562949953 / 2^49 is 1e-6, 1686629713 / 2^29 is pi. */
static inline lobe_env_fixed lobe_env_fixed_of(int32_t roughness, int32_t n_dot_v)
{
    const int32_t r = lobe_q_saturate(roughness), v = lobe_q_saturate(n_dot_v), u = LOBE_Q30_ONE - v;
    const lobe_q_scaled one = lobe_qs_of(LOBE_Q30_ONE, 0), root_a = lobe_qs_of(r, 0), v_scaled = lobe_qs_of(v, 0);
    const lobe_q_scaled a = lobe_qs_mul(root_a, root_a);
    const lobe_q_scaled s = lobe_qs_sqrt(lobe_qs_mul(lobe_qs_of(u, 0), lobe_qs_add(one, v_scaled)));
    const lobe_q_scaled q = lobe_qs_div(a, lobe_qs_add(lobe_qs_add(v_scaled, a), lobe_qs_made(562949953, -19)));
    const int32_t a30 = lobe_qs_fixed(a, 30), q30 = lobe_q_saturate(lobe_qs_fixed(q, 30));
    lobe_env_fixed p;
    p.a = a;
    p.reach = lobe_qs_mul(a, s);
    p.theta = lobe_q_mul(lobe_q_arc(lobe_qs_fixed(s, 30), v), 1686629713, 29);
    p.e = lobe_energy_high_q30(roughness, n_dot_v);
    p.f[0] = LOBE_Q30_ONE;
    p.f[1] = u;
    p.f[2] = lobe_q_mul(u, u, 30);
    p.f[3] = q30;
    p.f[4] = lobe_q_mul(q30, q30, 30);
    p.f[5] = lobe_q_mul(u, q30, 30);
    p.f[6] = a30;
    p.f[7] = lobe_q_mul(a30, u, 30);
    p.f[8] = lobe_q_mul(a30, q30, 30);
    p.f[9] = lobe_q_mul(a30, p.f[5], 30);
    p.f[10] = lobe_q_mul(a30, a30, 30);
    p.f[11] = lobe_q_mul(p.f[10], u, 30);
    return p;
}

/* One quantity, Q20. */
static inline int32_t lobe_env_sum_fixed(const lobe_env_fixed *p, const int32_t *c)
{
    int32_t sum = c[0];
    int k;
    for (k = 1; k < LOBE_ENV_COLUMNS; k++)
        sum += lobe_q_mul(c[k], p->f[k], 30);
    return sum;
}

/* A Q20 number with a block exponent. */
static inline lobe_q_scaled lobe_env_scaled(int32_t x) { return lobe_qs_of(x, 30 - LOBE_ENV_BITS); }

/* 2^x, x in Q20 and at most `most`. */
static inline lobe_q_scaled lobe_env_power(int32_t x, int32_t most)
{
    return lobe_qs_shifted(lobe_qs_exp2_minus(lobe_env_scaled((most << LOBE_ENV_BITS) - x)), most);
}

/* theta + a s shift */
static inline lobe_q_scaled lobe_env_angle_fixed(const lobe_env_fixed *p, int32_t shift)
{
    return lobe_qs_add(lobe_qs_of(p->theta, 0), lobe_qs_mul(p->reach, lobe_env_scaled(shift)));
}

static inline int32_t lobe_env_width_fixed(const lobe_env_fixed *p, int32_t log_width)
{
    static const lobe_q_scaled least = LOBE_QS_CONSTANT(0.3);
    const int32_t held =
        lobe_q_clamp(log_width, -(32 << LOBE_ENV_BITS), 8 << LOBE_ENV_BITS); /* 2^-32 does not move .3 */
    const lobe_q_scaled t = lobe_qs_mul(p->a, lobe_qs_add(least, lobe_env_power(held, 8)));
    const lobe_q_scaled root = lobe_qs_sqrt(lobe_qs_add(lobe_qs_of(LOBE_Q30_ONE, 0), lobe_qs_mul(t, t)));
    return lobe_q_saturate(lobe_qs_fixed(lobe_qs_sqrt(lobe_qs_div(t, root)), 30));
}

/* All taps: rows are shift, width and part of the albedo in turn; the last tap has what is left of it. */
static inline void lobe_env_fan_q30(int32_t roughness, int32_t n_dot_v, const int32_t rows[][LOBE_ENV_COLUMNS], int n,
                                    lobe_env_tap_q30 *taps)
{
    const lobe_env_fixed p = lobe_env_fixed_of(roughness, n_dot_v);
    uint32_t rest = (uint32_t)lobe_q16_from_q30(p.e);
    int i;
    for (i = 0; i < n; i++) {
        taps[i].angle = lobe_qs_fixed(lobe_env_angle_fixed(&p, lobe_env_sum_fixed(&p, rows[3 * i])), 30);
        taps[i].width = lobe_env_width_fixed(&p, lobe_env_sum_fixed(&p, rows[3 * i + 1]));
        if (i < n - 1) {
            const lobe_q_scaled part = lobe_env_scaled(lobe_env_sum_fixed(&p, rows[3 * i + 2]));
            taps[i].weight_q16 = lobe_qs_fixed(lobe_qs_mul(lobe_qs_of(p.e, 0), part), 16);
            rest -= (uint32_t)taps[i].weight_q16; /* eight of them are under 2^14 */
        }
    }
    taps[n - 1].weight_q16 = (int32_t)rest;
}

#endif
