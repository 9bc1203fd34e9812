#include "differential_evolution.h"
#include "random.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

lobe_de_options lobe_de_default(void)
{
    lobe_de_options o = {0};
    o.strategy = LOBE_DE_RAND_1_BIN;
    o.bounds = LOBE_DE_REDRAW;
    o.f_min = 0.5;
    o.f_max = 1.0;
    o.crossover = 0.9;
    o.seed = 1;
    o.budget = 100000;
    o.target = -HUGE_VAL;
    o.value_tolerance = 1e-10;
    o.spread_tolerance = 1e-10;
    o.stall_generations = 500;
    return o;
}

static const char *check(const lobe_objective *objective, const lobe_de_options *o, size_t population)
{
    const char *reason = lobe_objective_check(objective, true);
    if (reason)
        return reason;
    if (o->strategy != LOBE_DE_RAND_1_BIN && o->strategy != LOBE_DE_BEST_1_BIN)
        return "unknown strategy";
    if (o->bounds != LOBE_DE_CLAMP && o->bounds != LOBE_DE_REDRAW)
        return "unknown treatment of bounds";
    if (population < 4)
        return "a population needs at least 4 members";
    if (!(o->f_min > 0.0 && o->f_min <= o->f_max && o->f_max <= 2.0))
        return "the weights must satisfy 0 < f_min <= f_max <= 2";
    if (!(o->crossover >= 0.0 && o->crossover <= 1.0))
        return "the crossover rate must be in [0, 1]";
    if (o->budget < population)
        return "the budget is smaller than one population";
    if (!(o->value_tolerance >= 0.0) || !(o->spread_tolerance >= 0.0) || isnan(o->target))
        return "a tolerance is negative or not a number";
    return NULL;
}

typedef struct population {
    size_t count, dim, best;
    double *x, *value;       /* members */
    double *trial, *outcome; /* candidates of the next generation */
} population;

/* One candidate for member i: a mutant where the coin says so, and in one parameter always. */
static void breed(const lobe_objective *objective, const lobe_de_options *o, const population *pop, size_t i,
                  lobe_random *random)
{
    const size_t n = pop->dim;
    size_t a, b, c;
    do
        a = o->strategy == LOBE_DE_BEST_1_BIN ? pop->best : lobe_random_below(random, pop->count);
    while (o->strategy == LOBE_DE_RAND_1_BIN && a == i);
    do
        b = lobe_random_below(random, pop->count);
    while (b == i || b == a);
    do
        c = lobe_random_below(random, pop->count);
    while (c == i || c == a || c == b);
    const double weight = o->f_min + (o->f_max - o->f_min) * lobe_random_unit(random);
    const size_t always = lobe_random_below(random, n);
    for (size_t k = 0; k < n; k++) {
        const double old = pop->x[i * n + k], lower = objective->lower[k], upper = objective->upper[k];
        double t = old;
        if (lobe_random_unit(random) < o->crossover || k == always) {
            t = pop->x[a * n + k] + weight * (pop->x[b * n + k] - pop->x[c * n + k]);
            if (t < lower)
                t = o->bounds == LOBE_DE_CLAMP ? lower : lower + (old - lower) * lobe_random_unit(random);
            else if (t > upper)
                t = o->bounds == LOBE_DE_CLAMP ? upper : upper + (old - upper) * lobe_random_unit(random);
        }
        pop->trial[i * n + k] = t;
    }
}

/* The better of member and candidate stays; a tie goes to the candidate, so that a plateau is crossed. */
static void select_survivors(population *pop)
{
    const size_t n = pop->dim;
    for (size_t i = 0; i < pop->count; i++) {
        if (pop->outcome[i] <= pop->value[i]) {
            pop->value[i] = pop->outcome[i];
            memcpy(pop->x + i * n, pop->trial + i * n, n * sizeof(double));
        }
    }
    for (size_t i = 0; i < pop->count; i++)
        if (pop->value[i] < pop->value[pop->best])
            pop->best = i;
}

static bool values_agree(const population *pop, double tolerance)
{
    double worst = pop->value[0];
    for (size_t i = 1; i < pop->count; i++)
        if (pop->value[i] > worst)
            worst = pop->value[i];
    return worst - pop->value[pop->best] <= tolerance * fabs(pop->value[pop->best]);
}

static bool spread_is_small(const lobe_objective *objective, const population *pop, double tolerance)
{
    const size_t n = pop->dim;
    for (size_t k = 0; k < n; k++) {
        double lowest = pop->x[k], highest = pop->x[k];
        for (size_t i = 1; i < pop->count; i++) {
            lowest = fmin(lowest, pop->x[i * n + k]);
            highest = fmax(highest, pop->x[i * n + k]);
        }
        if (highest - lowest > tolerance * (objective->upper[k] - objective->lower[k]))
            return false;
    }
    return true;
}

static void evaluate(const lobe_objective *objective, population *pop)
{
    if (!objective->race) {
        lobe_objective_eval(objective, pop->trial, pop->count, pop->outcome);
        return;
    }
    objective->race(objective->ctx, pop->trial, pop->count, pop->value, pop->outcome);
    for (size_t i = 0; i < pop->count; i++)
        if (isnan(pop->outcome[i]))
            pop->outcome[i] = HUGE_VAL;
}

/* Sets status and reason, and returns true, where the search is over. */
static bool finished(const lobe_objective *objective, const lobe_de_options *o, const population *pop, size_t stall,
                     lobe_fit_result *result)
{
    const double best = pop->value[pop->best];
    result->status = LOBE_FIT_CONVERGED;
    if (best <= o->target) {
        result->reason = "the target value is reached";
        return true;
    }
    if (best < HUGE_VAL && values_agree(pop, o->value_tolerance)) {
        result->reason = "the values of the population agree";
        return true;
    }
    if (best < HUGE_VAL && spread_is_small(objective, pop, o->spread_tolerance)) {
        result->reason = "the population has contracted";
        return true;
    }
    if (o->stall_generations > 0 && stall >= o->stall_generations) {
        result->status = LOBE_FIT_STALLED;
        result->reason = "the best value has not changed for stall_generations";
        return true;
    }
    if (result->evaluations + pop->count > o->budget) {
        result->status = LOBE_FIT_BUDGET;
        result->reason = "the evaluations ran out";
        return true;
    }
    const lobe_progress progress = {"differential evolution", result->evaluations, o->budget, best};
    if (o->progress && !o->progress(o->progress_ctx, &progress)) {
        result->status = LOBE_FIT_INTERRUPTED;
        result->reason = "interrupted";
        return true;
    }
    return false;
}

lobe_fit_result lobe_differential_evolution(const lobe_objective *objective, const lobe_de_options *options, double *x)
{
    const lobe_de_options o = options ? *options : lobe_de_default();
    lobe_fit_result result = {LOBE_FIT_STALLED, "", 0.0, 0, 0};
    if (!x)
        return lobe_fit_refused("no place for the result");
    size_t count = o.population;
    if (count == 0 && objective)
        count = objective->dim < 2 ? 20 : 10 * objective->dim;
    const char *reason = check(objective, &o, count);
    if (reason)
        return lobe_fit_refused(reason);
    const size_t n = objective->dim;
    double *memory = malloc((2 * count * n + 2 * count) * sizeof *memory);
    if (!memory)
        return lobe_fit_no_memory();
    population pop = {count, n, 0, memory, memory + count * n, NULL, NULL};
    pop.trial = pop.value + count;
    pop.outcome = pop.trial + count * n;

    lobe_random random;
    lobe_random_seed(&random, o.seed, 0);
    lobe_random_latin(&random, objective->lower, objective->upper, n, count, pop.x);
    if (o.start_at_x) {
        memcpy(pop.x, x, n * sizeof *x);
        lobe_box_clamp(objective->lower, objective->upper, n, pop.x);
    }
    lobe_objective_eval(objective, pop.x, count, pop.value);
    result.evaluations = count;
    for (size_t i = 1; i < count; i++)
        if (pop.value[i] < pop.value[pop.best])
            pop.best = i;

    for (size_t stall = 0; !finished(objective, &o, &pop, stall, &result);) {
        const double before = pop.value[pop.best];
        for (size_t i = 0; i < count; i++)
            breed(objective, &o, &pop, i, &random);
        evaluate(objective, &pop);
        select_survivors(&pop);
        result.evaluations += count;
        result.iterations++;
        stall = pop.value[pop.best] < before ? 0 : stall + 1;
    }
    result.value = pop.value[pop.best];
    memcpy(x, pop.x + pop.best * n, n * sizeof *x);
    free(memory);
    return result;
}
