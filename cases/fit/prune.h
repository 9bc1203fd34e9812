/* Which coefficients can go, and at what price: terms are set to 0 one after the other, the rest is refitted for the
 * smallest maximum error, and the price list says what each removal cost. */
#ifndef LOBE_PRUNE_H
#define LOBE_PRUNE_H

#include "minimax.h"

typedef struct lobe_prune_options {
    lobe_minimax_options refit; /* of every candidate; its progress callback is called all along */
    size_t candidates;          /* refit this many of the terms with the lowest predicted price; 0: all */
    size_t price_p;             /* the p-norm whose curvature predicts prices */
    size_t keep;                /* stop where this many terms are left, fixed ones included; at least 1 */
    double limit;               /* stop before the error would exceed this; infinity: never */
    const bool *fixed;          /* dim: terms that must stay; NULL: none */
} lobe_prune_options;

typedef struct lobe_prune_step {
    size_t term;  /* removed in this step */
    double error; /* the largest error afterwards, the rest refitted */
} lobe_prune_step;

lobe_prune_options lobe_prune_default(void);
/* x: a fitted start in; out the coefficients after the last removal, removed ones 0. removed: dim flags out.
 * steps: dim entries; *count: removals that were made. The value is the error after the last. 0 must lie inside the
 * bounds of every term that may go. */
lobe_fit_result lobe_prune(const lobe_residuals *residuals, const lobe_prune_options *options, double *x, bool *removed,
                           lobe_prune_step *steps, size_t *count);

#endif
