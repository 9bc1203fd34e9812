/* What the q30 tiers of a fan of spherical Gaussians share: the formulas of ../env_lobes_sg.h, with its letters; see
 * env_lobes.h. Results are Q16.16, a sharpness held at 32768. A weight is at most 1 + 2 n in magnitude, n lobes, and
 * the last takes what is left, so that the sum is the albedo to half a unit. */
#ifndef LOBE_Q30_ENV_LOBES_SG_H
#define LOBE_Q30_ENV_LOBES_SG_H
#include "env_lobes.h"

/* The quantities in the order of their rows; those that a tier has not are 0. All but the first and the third are held
 * at limits, Q20. */
enum {
    LOBE_ENV_SHIFT,
    LOBE_ENV_LEVEL,
    LOBE_ENV_SPREAD,
    LOBE_ENV_TILT,
    LOBE_ENV_LEAN,
    LOBE_ENV_RIM,
    LOBE_ENV_TAPER,
    LOBE_ENV_FLARE,
    LOBE_ENV_QUANTITIES
};

static inline void lobe_env_sg_fan_q30(int32_t roughness, int32_t n_dot_v, const int32_t rows[][LOBE_ENV_COLUMNS],
                                       int row_count, int n, lobe_env_sg_tap_q16 *taps)
{
    static const int32_t limits[LOBE_ENV_QUANTITIES][2] = {{-0x7fffffff, 0x7fffffff},
                                                           {-(4 << LOBE_ENV_BITS), 8 << LOBE_ENV_BITS},
                                                           {-0x7fffffff, 0x7fffffff},
                                                           {-(12 << LOBE_ENV_BITS), 12 << LOBE_ENV_BITS},
                                                           {-(8 << LOBE_ENV_BITS), 8 << LOBE_ENV_BITS},
                                                           {LOBE_Q_CONSTANT(-0.1, LOBE_ENV_BITS), 2 << LOBE_ENV_BITS},
                                                           {-(12 << LOBE_ENV_BITS), 24 << LOBE_ENV_BITS},
                                                           {-(4 << LOBE_ENV_BITS), 12 << LOBE_ENV_BITS}};
    const lobe_env_fixed p = lobe_env_fixed_of(roughness, n_dot_v);
    const lobe_q_scaled least = LOBE_QS_CONSTANT(0.01);
    const lobe_q_scaled narrow = lobe_qs_less(p.a, least) ? least : p.a;
    const lobe_q_scaled narrow2 = lobe_qs_mul(narrow, narrow), theta = lobe_qs_of(p.theta, 0);
    lobe_q_scaled sum = lobe_qs_made(0, LOBE_QS_ZERO), height[8], centre, spread, less, factor;
    int32_t x[LOBE_ENV_QUANTITIES], rest = lobe_q16_from_q30(p.e);
    int i;
    for (i = 0; i < LOBE_ENV_QUANTITIES; i++)
        x[i] = i < row_count ? lobe_q_clamp(lobe_env_sum_fixed(&p, rows[i]), limits[i][0], limits[i][1]) : 0;
    centre = lobe_env_angle_fixed(&p, x[LOBE_ENV_SHIFT]);
    spread = lobe_qs_positive(lobe_qs_mul(p.reach, lobe_env_scaled(x[LOBE_ENV_SPREAD])));
    if (lobe_qs_less(theta, spread))
        spread = theta;
    for (i = 0; i < n; i++) {
        /* 1/7 and 1/3; exact at the ends */
        const int32_t step = n == 8 ? 153391689 : 357913941;
        const int32_t odd = 2 * i + 1 - n;
        const int32_t d = n == 1 ? 0 : odd == n - 1 ? LOBE_Q30_ONE : odd == 1 - n ? -LOBE_Q30_ONE : odd * step;
        const int32_t d2 = lobe_q_mul(d, d, 30);
        const int32_t level =
            x[LOBE_ENV_LEVEL] + lobe_q_mul(x[LOBE_ENV_LEAN], d, 30) - lobe_q_mul(x[LOBE_ENV_FLARE], d2, 30);
        const lobe_q_scaled width = lobe_qs_div(lobe_env_power(level, 20), narrow2);
        height[i] = lobe_env_power(lobe_q_mul(x[LOBE_ENV_TILT], d, 30) - lobe_q_mul(x[LOBE_ENV_TAPER], d2, 30), 24);
        sum = lobe_qs_add(sum, height[i]);
        taps[i].angle = lobe_qs_fixed(lobe_qs_add(centre, lobe_qs_mul(spread, lobe_qs_of(d, 0))), 16);
        taps[i].sharpness = lobe_qs_fixed(width, 16);
    }
    less = lobe_qs_mul(lobe_qs_of(p.e, 0), lobe_env_scaled(x[LOBE_ENV_RIM]));
    factor = lobe_qs_div(
        lobe_qs_add(lobe_qs_of(p.e, 0), lobe_qs_mul(lobe_qs_of(n << LOBE_ENV_BITS, 30 - LOBE_ENV_BITS), less)), sum);
    for (i = 0; i < n - 1; i++) {
        taps[i].weight = lobe_qs_fixed(lobe_qs_sub(lobe_qs_mul(height[i], factor), less), 16);
        rest -= taps[i].weight;
    }
    taps[n - 1].weight = rest;
}

#endif
