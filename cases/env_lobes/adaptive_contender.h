/* The tier whose number of taps follows a need, to be judged like the others (contenders.h). */
#ifndef LOBE_ENV_ADAPTIVE_CONTENDER_H
#define LOBE_ENV_ADAPTIVE_CONTENDER_H
#include "judge.h"

extern const lobe_judge_model lobe_adaptive_contender;

/* How many taps what ships reads, in the mean over side^2 midpoints of a uniform square of (roughness, n_dot_v): those
 * of a weight that is not 0. */
double lobe_adaptive_contender_mean(int side);

#endif
