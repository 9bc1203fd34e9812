/* Differential evolution (Storn and Price 1997): the global stage. Needs bounds, no derivatives.
 * A generation is one batch, drawn before it is evaluated, so results do not depend on threads. */
#ifndef LOBE_DIFFERENTIAL_EVOLUTION_H
#define LOBE_DIFFERENTIAL_EVOLUTION_H

#include "objective.h"
#include "status.h"
#include <stdint.h>

typedef enum lobe_de_strategy { LOBE_DE_RAND_1_BIN, LOBE_DE_BEST_1_BIN } lobe_de_strategy;
typedef enum lobe_de_bounds {
    LOBE_DE_CLAMP, /* onto the bound: finds minima that lie on it */
    LOBE_DE_REDRAW /* anew, uniformly between the bound and the target vector: keeps the population spread */
} lobe_de_bounds;

typedef struct lobe_de_options {
    lobe_de_strategy strategy;
    lobe_de_bounds bounds;
    size_t population;   /* at least 4; 0: 10 a parameter, at least 20 */
    double f_min, f_max; /* weight, drawn anew for every trial ("dither") from [f_min, f_max] in (0, 2] */
    double crossover;    /* [0, 1] */
    uint64_t seed;
    size_t budget;             /* evaluations, at least one population */
    double target;             /* stop where the best value is at most this; -infinity: never */
    double value_tolerance;    /* stop where worst - best <= this * |best|; 0: where all are equal */
    double spread_tolerance;   /* stop where every parameter spreads over <= this part of its range */
    size_t stall_generations;  /* stop after this many without a better best; 0: never */
    bool start_at_x;           /* x is a member of the first population */
    lobe_progress_fn progress; /* NULL: none */
    void *progress_ctx;
} lobe_de_options;

lobe_de_options lobe_de_default(void);
/* x: the best point out (and one start in, if start_at_x). options NULL: the defaults. */
lobe_fit_result lobe_differential_evolution(const lobe_objective *objective, const lobe_de_options *options, double *x);

#endif
