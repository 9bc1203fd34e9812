/* Fits the fan whose number of taps follows a need: the error of radiance over (alpha, n_dot_v) and a price on the mean
 * number of taps, together. */
#ifndef LOBE_ENV_ADAPTIVE_FIT_H
#define LOBE_ENV_ADAPTIVE_FIT_H
#include "../fit/progress.h"
#include "../fit/status.h"
#include "adaptive.h"
#include "training.h"

/* Where the mean of a square of the plane is taken for the price: side^2 midpoints. */
enum { LOBE_ADAPTIVE_SIDE = 64 };

typedef struct lobe_adaptive_fit {
    const lobe_training *training;
    double weight[LOBE_TRAINING_CELLS]; /* sum to 1 */
    double price;                       /* of a tap in the mean */
    double softness;                    /* of the gates, adaptive.h */
    double blur;                        /* of the count that is priced, in taps */
    bool hold_need;                     /* the need stays as it is */
    int threads;
    lobe_progress_line line;
} lobe_adaptive_fit;

/* Weights as dense as the judge's points: even over ln alpha and over n_dot_v, more at both ends of n_dot_v; what is
 * narrower than alpha .04 counts little. */
void lobe_adaptive_fit_of(const lobe_training *training, int threads, lobe_adaptive_fit *fit);

/* Levenberg-Marquardt on the normal equations from p, at most `steps` of them. The value is the objective. */
lobe_fit_result lobe_adaptive_improve(lobe_adaptive_fit *fit, int steps, double *p);

/* Fans of 1, 2, 4 and 8 taps, by whose errors a first need is made. */
typedef struct lobe_adaptive_tiers {
    double p[4][LOBE_FAN_MOST];
} lobe_adaptive_tiers;

/* From starts, through soft gates to hard ones: the best by the objective (adaptive_search.c). */
lobe_fit_result lobe_adaptive_search(lobe_adaptive_fit *fit, const lobe_adaptive_tiers *tiers, double *p);

/* Root mean squares of the parts over the training set by the weights, where alpha is at least .04. */
void lobe_adaptive_score(const lobe_adaptive_fit *fit, const double *p, double error[LOBE_CELL_PARTS]);

#endif
