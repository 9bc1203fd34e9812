/* Newton's method for surfaces: the objective is a sum over points of a smooth function of a few
 * quantities, and each
 * quantity a sum of coefficients times features of the point. Derivatives are taken by the quantities, point by point,
 * and carried to the coefficients exactly, so that a hundred coefficients cost what eight do. */
#ifndef LOBE_SG_NEWTON_H
#define LOBE_SG_NEWTON_H
#include <stdbool.h>
#include <stddef.h>

enum { LOBE_NEWTON_QUANTITIES = 8 };

typedef struct lobe_newton {
    double (*value)(const void *ctx, size_t point, const double *quantity); /* called from several threads */
    const void *ctx;
    size_t points;
    int quantities, features;
    const double *feature; /* points x features */
    double step;           /* of the differences by a quantity */
    double ridge;          /* times the sum of squared coefficients */
    int rounds, threads;
    bool (*progress)(void *progress_ctx, int round, double value); /* false ends it; NULL: none */
    void *progress_ctx;
} lobe_newton;

/* c: quantities x features coefficients, start in, best out. value: of the sum at the best. Results do not depend on
 * threads. false: no memory. */
bool lobe_newton_run(const lobe_newton *n, double *c, double *value);

#endif
