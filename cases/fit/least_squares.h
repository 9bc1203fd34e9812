/* Levenberg-Marquardt: the smallest sum of squared residuals, by steps inside a trust region (More 1978) on a
 * Householder factor. Bounds are kept by freezing a parameter that is pushed against one. */
#ifndef LOBE_LEAST_SQUARES_H
#define LOBE_LEAST_SQUARES_H

#include "jacobian.h"
#include "status.h"

typedef struct lobe_ls_options {
    double value_tolerance;     /* stop where a step gains, and should gain, <= this part of the sum */
    double step_tolerance;      /* stop where the trust region is <= this part of the scaled x */
    double gradient_tolerance;  /* stop where residuals and every column are this near to orthogonal (a cosine) */
    double first_step;          /* first trust radius in units of the scaled x */
    double ridge;               /* >= 0: ridge * |x|^2 is added to the sum of squares */
    lobe_difference difference; /* forward; turns central by itself where a forward step fails */
    size_t budget;              /* evaluations of the residual vector */
    lobe_progress_fn progress;
    void *progress_ctx;
} lobe_ls_options;

lobe_ls_options lobe_ls_default(void);
/* x: start in, best point out. The value is the (weighted) sum of squares with its ridge. */
lobe_fit_result lobe_least_squares(const lobe_residuals *residuals, const lobe_ls_options *options, double *x);

#endif
