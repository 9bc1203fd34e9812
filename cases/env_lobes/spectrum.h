/* How much an environment varies at each angular scale, and what follows from it: under all orientations of an
 * environment alike, the mean square radiance through a lobe is sum_l power[l] sum_m |lobe_lm|^2, so that the error of
 * an approximation over every orientation is one norm of the difference of two lobes, without sampling. */
#ifndef LOBE_ENV_SPECTRUM_H
#define LOBE_ENV_SPECTRUM_H
#include "harmonics.h"

typedef struct lobe_env_spectrum {
    double power[LOBE_ENV_BANDS]; /* sum over m of |coefficient|^2 / (2 l + 1), of the mean of the colours */
} lobe_env_spectrum;

void lobe_env_spectrum_of(const lobe_harmonics *harmonics, lobe_env_spectrum *spectrum);

#endif
