/* Fits the fan whose number of taps follows a need: the error of radiance over (alpha, n_dot_v) and a price on the mean
 * number of taps, together. */
#ifndef LOBE_ENV_ADAPTIVE_FIT_H
#define LOBE_ENV_ADAPTIVE_FIT_H
#include "../fit/progress.h"
#include "../fit/status.h"
#include "adaptive.h"

/* Where the mean of a square of the plane is taken for the price: side^2 midpoints. */
enum { LOBE_ADAPTIVE_SIDE = 64 };

enum { LOBE_ADAPTIVE_CELLS = 400 }; /* at most */

typedef struct lobe_adaptive_fit {
    int count; /* cells */
    lobe_cell *const *cell;
    lobe_fan_point point[LOBE_ADAPTIVE_CELLS];
    double weight[LOBE_ADAPTIVE_CELLS]; /* sum to 1 */
    double area[LOBE_ADAPTIVE_CELLS];   /* how much of the square of (roughness, n_dot_v) a cell stands for */
    const double *share;                /* weights of a cell's parts */
    double price;                       /* of a tap in the mean */
    double softness;                    /* of the gates, adaptive.h */
    double blur;                        /* of the count that is priced, in taps */
    bool hold_need;                     /* the need stays as it is */
    int threads;
    lobe_progress_line line;
} lobe_adaptive_fit;

/* Cells in rows of one alpha, n_dot_v growing along each and alpha from row to row, every row as long as the others.
 * Weights as dense as the judge's points: even over ln alpha and over n_dot_v, more at both ends of n_dot_v; what is
 * narrower than alpha .04 counts little. fit->cell and fit->share stay in use. */
void lobe_adaptive_fit_of(lobe_cell *const *cell, const lobe_fan_point *point, int rows, int columns,
                          const double *share, int threads, lobe_adaptive_fit *fit);

/* Levenberg-Marquardt on the normal equations from p, at most `steps` of them. The value is the objective. */
lobe_fit_result lobe_adaptive_improve(lobe_adaptive_fit *fit, int steps, double *p);

/* Fans of 1, 2, 4 and 8 taps, by whose errors a first need is made. */
typedef struct lobe_adaptive_tiers {
    double p[4][LOBE_FAN_MOST];
} lobe_adaptive_tiers;

/* Over a few cells through soft gates to hard ones, then over all. fine's price is where both begin
 * (adaptive_search.c). */
lobe_fit_result lobe_adaptive_search(lobe_adaptive_fit *coarse, lobe_adaptive_fit *fine,
                                     const lobe_adaptive_tiers *tiers, double *p);

/* Root mean squares of the parts over the training set by the weights, where alpha is at least .04. */
void lobe_adaptive_score(const lobe_adaptive_fit *fit, const double *p, double error[LOBE_CELL_PARTS]);

#endif
