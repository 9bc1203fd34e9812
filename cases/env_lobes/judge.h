/* Errors of what ships, and of the split sum beside it, on environments that no fit has seen. */
#ifndef LOBE_ENV_JUDGE_H
#define LOBE_ENV_JUDGE_H
#include <stdbool.h>
#include "../environment/environment.h"
#include "cell.h"

enum { LOBE_JUDGE_MODELS = 6, LOBE_JUDGE_ORIENTATIONS = 96 };

/* 30 points: alpha .04 .08 .16 .32 .6 1 by n_dot_v .05 .25 .5 .75 1. */
enum { LOBE_JUDGE_ALPHAS = 6, LOBE_JUDGE_VIEWS = 5, LOBE_JUDGE_CELLS = LOBE_JUDGE_ALPHAS * LOBE_JUDGE_VIEWS };
extern const double lobe_judge_alpha[LOBE_JUDGE_ALPHAS], lobe_judge_view[LOBE_JUDGE_VIEWS];

/* split sum, split sum with dominant-direction shift, lobes1, lobes2, lobes4, lobes8; the shift is that of Lagarde and
 * de Rousiers, "Moving Frostbite to Physically Based Rendering" (2014), listing 21. */
extern const char *const lobe_judge_name[LOBE_JUDGE_MODELS];

/* Taps of weight summing to 1; their number is returned. */
int lobe_judge_taps(int model, double alpha, double n_dot_v, lobe_cell_tap *taps);

typedef struct lobe_judge_errors {
    double relative[LOBE_JUDGE_MODELS]; /* |model - truth| / truth, rms over points and orientations */
    double rms[LOBE_JUDGE_MODELS];      /* rms |model - truth| / rms truth over all orientations, rms over points */
} lobe_judge_errors;

/* Radiance is the mean of the colours; detail below .8 degrees is blurred away. False where there is no memory. */
bool lobe_judge_environment(const lobe_environment *map, unsigned seed, int threads, lobe_judge_errors *errors);

#endif
