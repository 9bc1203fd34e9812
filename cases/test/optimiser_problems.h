/* Standard problems with known minima, for the tests and the comparison of the optimisers.
 * Sources: More, Garbow and Hillstrom 1981 (least squares; the minimum of Kowalik-Osborne with
 * the digits that NIST certifies for it as MGH09); Rastrigin, Ackley and Griewank in their usual form. */
#ifndef LOBE_OPTIMISER_PROBLEMS_H
#define LOBE_OPTIMISER_PROBLEMS_H

#include "../fit/objective.h"

#define LOBE_PROBLEM_MAX_DIM 10
#define LOBE_PROBLEM_MAX_ROWS 40

/* Values to minimise; the minimum is 0. Every entry of the box is the same interval. */
typedef struct lobe_value_problem {
    const char *name;
    size_t dim;
    double lower, upper;
    double (*value)(const double *x, size_t dim);
} lobe_value_problem;

/* Sums of squares with the smallest sum and a start, both as published. */
typedef struct lobe_square_problem {
    const char *name;
    size_t dim, rows;
    double start[LOBE_PROBLEM_MAX_DIM];
    double minimum;
    void (*residual)(const double *x, double *r);
} lobe_square_problem;

extern const lobe_value_problem lobe_value_problems[];
extern const size_t lobe_value_problem_count;
extern const lobe_square_problem lobe_square_problems[];
extern const size_t lobe_square_problem_count;

/* lobe_batch_fns; ctx is the problem. */
void lobe_value_problem_eval(void *ctx, const double *params, size_t count, double *values);
void lobe_square_problem_eval(void *ctx, const double *params, size_t count, double *values);

#endif
