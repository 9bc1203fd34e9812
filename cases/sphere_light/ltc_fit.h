/* The fit of the table of linearly transformed cosines. */
#ifndef LOBE_SPHERE_LIGHT_LTC_FIT_H
#define LOBE_SPHERE_LIGHT_LTC_FIT_H
#include <stdbool.h>
#include "../fit/sweep.h"

typedef struct lobe_ltc_fit_options {
    int power; /* of the error that is minimised over the directions: 2 or 3 */
    lobe_sweep_options sweep;
} lobe_ltc_fit_options;

/* 3 as in the published code. */
lobe_ltc_fit_options lobe_ltc_fit_default(void);

/* Row by row from the roughest, each cell from its neighbour's; the bytes do not depend on the threads. Writes a header
 * with nine significant digits. false after a line on stderr. */
bool lobe_ltc_fit(const lobe_ltc_fit_options *options, const char *path);

#endif
