#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../fit/random.h"
#include "adaptive_fit.h"
#include "normal_equations.h"

enum { COUNT = LOBE_ADAPTIVE_COUNT, TAPS = LOBE_ADAPTIVE_TAPS, NEEDS = LOBE_ADAPTIVE_NEEDS };

/* Where the tiers of 1, 2, 4 and 8 taps would stand if every cell could choose: the need that is nearest to it. */
static bool start_need(const lobe_adaptive_fit *fit, const lobe_adaptive_tiers *tiers, double generous, double *p)
{
    static const double need[4] = {-0.5, 1, 3.2, 5.2};
    lobe_normal_equations *e = lobe_normal_new(NEEDS);
    double *scratch = malloc(sizeof *scratch * lobe_cell_scratch(fit->cell[0])), zero[NEEDS] = {0};
    bool good = e && scratch;
    for (int c = 0; good && c < fit->count; c++) {
        const lobe_fan_point *point = &fit->point[c];
        double term[NEEDS], least = DBL_MAX, wanted = 0;
        for (int i = 0; i < 4; i++) {
            lobe_cell_tap tap[LOBE_CELL_TAPS];
            double part[LOBE_CELL_PARTS], cost = fit->price * generous * fit->area[c] * (1 << i);
            lobe_fan_taps(point, tiers->p[i], 1 << i, tap, NULL);
            lobe_cell_errors(fit->cell[c], tap, 1 << i, scratch, part);
            for (int k = 0; k < LOBE_CELL_PARTS; k++)
                cost += fit->weight[c] * fit->share[k] * part[k];
            if (cost < least) {
                least = cost;
                wanted = need[i];
            }
        }
        lobe_adaptive_need_terms(point, term);
        const double one = 1, miss = -wanted;
        const lobe_normal_column column = {&one, term, 0, NEEDS};
        lobe_normal_add(e, &column, 1, &miss, 1);
    }
    if (good) {
        lobe_normal_add_ridge(e, 1e-2, zero, 0);
        good = lobe_normal_step(e, 0, zero, p) > 0;
    }
    free(scratch);
    lobe_normal_free(e);
    return good;
}

/* A row of taps, in an order and as wide as the seed says; the first in the middle. */
static void start_taps(uint64_t seed, double *p)
{
    lobe_random r;
    double reach;
    int place[TAPS];
    lobe_random_seed(&r, 9, seed);
    for (int i = 0; i < TAPS; i++)
        place[i] = i;
    for (int i = TAPS - 1; i > 0; i--) {
        const int j = (int)(lobe_random_unit(&r) * (i + 1)), held = place[i];
        place[i] = place[j];
        place[j] = held;
    }
    reach = 0.6 + 1.2 * lobe_random_unit(&r);
    memset(p + NEEDS, 0, sizeof *p * (COUNT - NEEDS));
    for (int k = 0; k < TAPS; k++) {
        const double at = (2.0 * place[k] / (TAPS - 1) - 1) * (k ? 1 : 0.3);
        p[lobe_adaptive_first(k, 0) + 1] = -0.7 + reach * at;
        p[lobe_adaptive_first(k, 0) + 3] = -0.7;
        p[lobe_adaptive_first(k, 1)] =
            -0.6 - (k ? 0.8 * lobe_random_unit(&r) : 0) + 0.3 * fabs(at) + 0.3 * (lobe_random_unit(&r) - 0.5);
        if (k)
            p[lobe_adaptive_first(k, 2)] = 1.0 / TAPS;
    }
}

/* The count that is left: the price follows it. */
#define WANTED 2.185
enum { SIDE = 128 };

/* The seed that is best, of 0 to 13, by the objective at the end. */
enum { START = 5 };

static bool stopped(lobe_fit_result result)
{
    return result.status == LOBE_FIT_INTERRUPTED || result.status == LOBE_FIT_NO_MEMORY;
}

static lobe_fit_result stage(lobe_adaptive_fit *fit, double softness, int steps, double *p)
{
    fit->softness = softness;
    fit->blur = fmax(0.15, 1.4 * softness);
    return lobe_adaptive_improve(fit, steps, p);
}

/* Taps are cheap until all stand well; then they get dearer as long as there are too many, and gates harden. */
static lobe_fit_result run(lobe_adaptive_fit *fit, double price, double *p)
{
    static const double soft[] = {.15, .15, .1, .1, .1, .07, .07, .05, .05, .035, .035, .02, .02, .02, .02, .02};
    lobe_fit_result result;
    fit->price = 0.3 * price;
    fit->hold_need = true;
    result = stage(fit, 0, 24, p);
    fit->hold_need = false;
    if (!stopped(result))
        result = stage(fit, 0.1, 24, p);
    fit->price = 0.6 * price;
    if (!stopped(result))
        result = stage(fit, 0.1, 16, p);
    fit->price = price;
    for (size_t i = 0; i < sizeof soft / sizeof soft[0] && !stopped(result); i++) {
        result = stage(fit, soft[i], 14, p);
        fit->price *= exp((soft[i] > 0.02 ? 0.3 : 1) * (lobe_adaptive_mean_taps(p, SIDE) - WANTED));
    }
    return result;
}

/* With hard gates, and the price that the count which is wanted has. */
static lobe_fit_result settle(lobe_adaptive_fit *fit, double price, double *p)
{
    lobe_fit_result result = {0};
    fit->price = price;
    fit->hold_need = false;
    for (int i = 0; i < 5 && !stopped(result); i++) {
        result = stage(fit, 0.02, 14, p);
        fit->price *= exp(3 * (lobe_adaptive_mean_taps(p, SIDE) - WANTED));
    }
    fit->hold_need = true;
    return stopped(result) ? result : stage(fit, 0, 15, p);
}

lobe_fit_result lobe_adaptive_search(lobe_adaptive_fit *coarse, lobe_adaptive_fit *fine,
                                     const lobe_adaptive_tiers *tiers, double *p)
{
    const double price = fine->price;
    lobe_fit_result result;
    coarse->price = price;
    start_taps(START, p);
    if (!start_need(coarse, tiers, 0.8, p))
        return lobe_fit_no_memory();
    result = run(coarse, price, p);
    return stopped(result) ? result : settle(fine, price, p);
}
