/* `lobefit fit CASE`: parses its options and fits the tiers of a case, one after the other. */
#ifndef LOBE_FIT_COMMAND_H
#define LOBE_FIT_COMMAND_H
#include <stdbool.h>
#include "sweep.h"

struct lobe_case;

typedef struct lobe_fit_request {
    char coeffs[4000], tables[4000]; /* the folders to write into, which exist */
    lobe_sweep_options sweep;        /* threads and progress */
} lobe_fit_request;

/* Writes what the tier consists of; false after a line on stderr. Nothing half-written either way. */
typedef bool (*lobe_fit_tier_fn)(const struct lobe_case *self, const lobe_fit_request *request);

typedef struct lobe_fit_tier {
    const char *tier;
    lobe_fit_tier_fn fit;
} lobe_fit_tier;

/* The exit status. Tiers may be fitted in any order and alone: none reads what another wrote. */
int lobe_fit_command(const struct lobe_case *self, const lobe_fit_tier *tiers, int count, int argc, char **argv);

#endif
