/* A fan of taps as a function of its coefficients, in the order of models/env_lobes{1,2,4,8}.h: twelve of every tap's
 * shift, twelve of its width, twelve of its part of the albedo; the last tap has what the parts leave. */
#ifndef LOBE_ENV_FAN_H
#define LOBE_ENV_FAN_H
#include "cell.h"

enum { LOBE_FAN_TERMS = 12, LOBE_FAN_MOST = 36 * LOBE_CELL_TAPS - 12 };

/* What does not depend on coefficients: the kernel's point. */
typedef struct lobe_fan_point {
    double alpha, n_dot_v, theta, reach, term[LOBE_FAN_TERMS];
} lobe_fan_point;

lobe_fan_point lobe_fan_point_of(double alpha, double n_dot_v);

int lobe_fan_count(int taps);              /* of coefficients */
int lobe_fan_first(int tap, int quantity); /* quantity 0: shift, 1: width, 2: part */

/* growth, unless NULL: of each tap the derivative of ln t by its width's sum. */
void lobe_fan_taps(const lobe_fan_point *point, const double *p, int taps, lobe_cell_tap *out, double *growth);

/* The same where the last tap has a part of its own too, LOBE_FAN_TERMS coefficients more: the energy is free. */
void lobe_fan_free_taps(const lobe_fan_point *point, const double *p, int taps, lobe_cell_tap *out, double *growth);

#endif
