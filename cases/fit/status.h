/* What every engine of the fitter hands back: how it ended, why, and what it cost. */
#ifndef LOBE_FIT_STATUS_H
#define LOBE_FIT_STATUS_H

#include <stddef.h>

typedef enum lobe_fit_status {
    LOBE_FIT_CONVERGED,   /* a tolerance or the target value was reached */
    LOBE_FIT_BUDGET,      /* the evaluations ran out; the best point so far is handed back */
    LOBE_FIT_STALLED,     /* no further progress, and no tolerance says that this is a minimum */
    LOBE_FIT_INTERRUPTED, /* the progress callback asked to stop; the best point so far is handed back */
    LOBE_FIT_BAD_INPUT,   /* an option or the problem is out of range; the point is unchanged */
    LOBE_FIT_NO_MEMORY    /* the point is unchanged */
} lobe_fit_status;

typedef struct lobe_fit_result {
    lobe_fit_status status;
    const char *reason; /* static text, never NULL */
    double value;       /* of the point handed back */
    size_t evaluations; /* parameter vectors tried, those for derivatives included */
    size_t iterations;  /* generations, simplex steps or linearisations */
} lobe_fit_result;

static inline const char *lobe_fit_status_name(lobe_fit_status status)
{
    switch (status) {
    case LOBE_FIT_CONVERGED:
        return "converged";
    case LOBE_FIT_BUDGET:
        return "budget";
    case LOBE_FIT_STALLED:
        return "stalled";
    case LOBE_FIT_INTERRUPTED:
        return "interrupted";
    case LOBE_FIT_BAD_INPUT:
        return "bad input";
    case LOBE_FIT_NO_MEMORY:
        return "no memory";
    }
    return "unknown";
}

static inline lobe_fit_result lobe_fit_refused(const char *reason)
{
    lobe_fit_result result = {LOBE_FIT_BAD_INPUT, reason, 0.0, 0, 0};
    return result;
}

static inline lobe_fit_result lobe_fit_no_memory(void)
{
    lobe_fit_result result = {LOBE_FIT_NO_MEMORY, "out of memory", 0.0, 0, 0};
    return result;
}

#endif
