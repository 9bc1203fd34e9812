/* The fan whose number of taps follows a need, as a function of its coefficients, in the order of
 * models/env_lobes_adaptive.h: 15 of the need, twelve terms and three of the roughness; then 17, twelve terms and the
 * gates, of every tap's shift, width and part of the albedo, where the first tap has no part.
 *
 * A fit needs slopes where a gate is shut, so it may blur the gates: with a softness s > 0 they are s (ln(1 + e^(x /
 * s)) - ln(1 + e^((x - 1) / s))) instead of x held in [0, 1]. */
#ifndef LOBE_ENV_ADAPTIVE_H
#define LOBE_ENV_ADAPTIVE_H
#include "fan.h"

enum {
    LOBE_ADAPTIVE_TAPS = 6,
    LOBE_ADAPTIVE_GATES = LOBE_ADAPTIVE_TAPS - 1,
    LOBE_ADAPTIVE_TERMS = LOBE_FAN_TERMS + LOBE_ADAPTIVE_GATES,
    LOBE_ADAPTIVE_NEEDS = LOBE_FAN_TERMS + 3,
    LOBE_ADAPTIVE_COUNT = LOBE_ADAPTIVE_NEEDS + LOBE_ADAPTIVE_TERMS * (3 * LOBE_ADAPTIVE_TAPS - 1)
};

int lobe_adaptive_first(int tap, int quantity); /* quantity 0: shift, 1: width, 2: part */

/* The taps at a point, and what a slope by their coefficients is made of. */
typedef struct lobe_adaptive_fan {
    int count;
    double need, term[LOBE_ADAPTIVE_TERMS], term_by_need[LOBE_ADAPTIVE_TERMS];
    lobe_cell_tap tap[LOBE_ADAPTIVE_TAPS];
    double gate[LOBE_ADAPTIVE_TAPS]; /* 1 for the first */
    double angle_by_shift[LOBE_ADAPTIVE_TAPS], log_t_by_width[LOBE_ADAPTIVE_TAPS];
    double angle_by_need[LOBE_ADAPTIVE_TAPS], log_t_by_need[LOBE_ADAPTIVE_TAPS], weight_by_need[LOBE_ADAPTIVE_TAPS];
} lobe_adaptive_fan;

void lobe_adaptive_need_terms(const lobe_fan_point *point, double term[LOBE_ADAPTIVE_NEEDS]);
double lobe_adaptive_need(const lobe_fan_point *point, const double *p);

/* softness 0: what ships. */
void lobe_adaptive_taps(const lobe_fan_point *point, const double *p, double softness, lobe_adaptive_fan *fan);

/* How many taps are read, in the mean over a uniform square of (roughness, n_dot_v): side^2 midpoints. */
double lobe_adaptive_mean_taps(const double *p, int side);

#endif
