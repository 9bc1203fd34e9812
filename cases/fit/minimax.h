/* The smallest maximum error: least squares whose rows are reweighted towards the largest residuals.
 *
 * Lawson's idea with Newton's speed: the p-norm (sum |e|^p)^(1/p) is minimised for p growing from p_first to p_last,
 * every step a least-squares problem in which row r weighs |e_r / max|^(p-2). The p-norm bounds the maximum from
 * above and reaches it as p grows: at p = 400 about ln(touching rows) / 400, one percent for a hundred of them.
 * What is handed back is the point with the smallest true maximum over the rows, whichever p it came from.
 *
 * Meant for 10^4 to 10^5 rows by up to about 100 parameters; it holds the Jacobian, rows x dim doubles. Powers are
 * taken by multiplication, so no library function but sqrt decides a bit. */
#ifndef LOBE_MINIMAX_H
#define LOBE_MINIMAX_H

#include "jacobian.h"
#include "status.h"

typedef struct lobe_minimax_options {
    size_t p_first, p_last;     /* 2 <= p_first <= p_last <= 1000000 */
    double p_growth;            /* > 1; p is rounded up to an integer */
    size_t steps_per_p;         /* at most this many linearisations for one p, at least 1 */
    double step_tolerance;      /* a p is done where a step gains <= this part of the p-norm */
    double ridge;               /* >= 0: ridge * max^2 * |x|^2 joins the squared norm; 1e-9 tames a rational fit */
    const double *ridge_weight; /* dim, each >= 0: of x_k^2 in the ridge; NULL: 1 */
    lobe_difference difference; /* forward; turns central by itself where a forward step fails */
    double target;              /* stop where the maximum is at most this; 0: never */
    size_t budget;              /* evaluations of the residual vector */
    lobe_progress_fn progress;
    void *progress_ctx;
} lobe_minimax_options;

typedef struct lobe_minimax_result {
    lobe_fit_result fit; /* fit.value: the largest weighted |residual| at x */
    size_t worst_row;    /* where it is */
    double rms;          /* of the weighted residuals */
} lobe_minimax_result;

lobe_minimax_options lobe_minimax_default(void);
/* x: start in, best point out. options NULL: the defaults. */
lobe_minimax_result lobe_minimax(const lobe_residuals *residuals, const lobe_minimax_options *options, double *x);

/* What it costs, to second order and up to one common factor, to force each parameter to 0 and let the others follow:
 * x_k^2 over twice the k-th diagonal of the inverse curvature of the p-norm. prices: dim. Returns NULL, or why it is
 * refused. */
const char *lobe_minimax_prices(const lobe_residuals *residuals, size_t p, const double *x, double *prices);

#endif
