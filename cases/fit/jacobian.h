/* Derivatives of residuals by their parameters: the caller's own, or differences taken in one batch. */
#ifndef LOBE_JACOBIAN_H
#define LOBE_JACOBIAN_H

#include "objective.h"

typedef enum lobe_difference {
    LOBE_DIFFERENCE_FORWARD, /* dim evaluations, about 8 digits */
    LOBE_DIFFERENCE_CENTRAL  /* 2 dim evaluations, about 10 digits */
} lobe_difference;

/* Doubles of scratch that lobe_jacobian needs. */
size_t lobe_jacobian_scratch(const lobe_residuals *residuals);
/* transposed: dim x rows. at_x: the residuals of x. A step stays inside the bounds; an entry that is not finite
 * becomes 0, so that one bad row does not end a fit. Returns the evaluations it took. */
size_t lobe_jacobian(const lobe_residuals *residuals, lobe_difference difference, const double *x, const double *at_x,
                     double *scratch, double *transposed);
/* Rows first .. end - 1 of the problem that is linear about x as a block [weight * J | weight * at_x] for
 * lobe_triangle_add; frozen parameters (a flag each) get no column. factor: rows, or NULL: the problem's weights. */
void lobe_jacobian_rows(const lobe_residuals *residuals, const double *transposed, const double *at_x,
                        const bool *frozen, const double *factor, size_t first, size_t end, double *rows);

#endif
