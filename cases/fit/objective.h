/* What is fitted: a value, or a vector of residuals, as a function of the parameters.
 *
 * Both are asked for in batches, so that the callee may thread or vectorise; entry i of a batch must
 * depend on parameter vector i alone, and then no result depends on the number of threads. */
#ifndef LOBE_OBJECTIVE_H
#define LOBE_OBJECTIVE_H

#include <stdbool.h>
#include <stddef.h>

/* params: count x dim. values: count (objective) or count x rows (residuals). */
typedef void (*lobe_batch_fn)(void *ctx, const double *params, size_t count, double *values);

typedef struct lobe_objective {
    lobe_batch_fn f; /* a NaN counts as +infinity */
    void *ctx;
    size_t dim;
    const double *lower, *upper; /* dim each, both or neither; NULL: unbounded */
    /* Optional: values[i] is exact where it is at most cutoffs[i], else any number above cutoffs[i]. Lets a
     * callee stop early on hopeless candidates (see coarse_to_fine.h). */
    void (*race)(void *ctx, const double *params, size_t count, const double *cutoffs, double *values);
} lobe_objective;

typedef struct lobe_residuals {
    lobe_batch_fn f;
    /* Optional, else differences of f: derivative of row r by parameter k at transposed[k * rows + r]. */
    void (*jacobian)(void *ctx, const double *params, double *transposed);
    void *ctx;
    size_t dim, rows;
    const double *lower, *upper; /* dim each, both or neither */
    const double *weights;       /* rows, each at least 0, multiply the residuals; NULL: 1 */
} lobe_residuals;

/* Called between batches. Returning false interrupts: the engine hands back the best point so far. */
typedef struct lobe_progress {
    const char *stage;
    size_t evaluations, budget;
    double best;
} lobe_progress;
typedef bool (*lobe_progress_fn)(void *ctx, const lobe_progress *progress);

/* NULL, or why the problem cannot be fitted. need_box: finite bounds are required. */
const char *lobe_objective_check(const lobe_objective *objective, bool need_box);
const char *lobe_residuals_check(const lobe_residuals *residuals);

/* x into the box; does nothing without bounds. */
void lobe_box_clamp(const double *lower, const double *upper, size_t dim, double *x);

/* f with every NaN turned into +infinity. */
void lobe_objective_eval(const lobe_objective *objective, const double *params, size_t count, double *values);

#endif
