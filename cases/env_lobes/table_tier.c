#include "table_tier.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "../case.h"
#include "table_fit.h"
#include "table_write.h"

/* What serves environments best that are neither trained on nor judged by: from 1e-5 to 1e-3 their error with 4 taps
 * moves by a fortieth. */
#define STIFFNESS 3e-4

enum { BUDGET = 20 };

bool lobe_env_table_tier(const lobe_case *self, const lobe_fit_request *request,
                         const lobe_env_table_training *training, int taps, const double *closed)
{
    lobe_env_table_fit fit = {training, request->sweep.threads, STIFFNESS, lobe_progress_line_default()};
    lobe_env_table_text text = {.brdf = self->brdf, .taps = taps};
    double *table = malloc(sizeof *table * LOBE_ENV_TABLE_MOST);
    lobe_fit_result result = lobe_fit_no_memory();
    bool good = false;
    fit.line.out = request->sweep.progress ? stderr : NULL;
    if (table) {
        lobe_env_table_start(closed, taps, table);
        result = lobe_env_table_improve(&fit, taps, BUDGET, table);
        lobe_progress_finish(&fit.line);
    }
    if (!table || result.status == LOBE_FIT_INTERRUPTED || result.status == LOBE_FIT_NO_MEMORY ||
        !isfinite(result.value)) {
        fprintf(stderr, "lobefit: fit env_lobes lobes%d_table%d: %s: %s; the old table stands\n", taps,
                LOBE_ENV_TABLE_SIDE, lobe_fit_status_name(result.status), result.reason);
    } else {
        lobe_env_table_round(table, taps);
        lobe_env_table_score(&fit, taps, table, text.error);
        text.grid =
            "20 x 20, denser toward low alpha and grazing views; eighteen environments, 80 orientations of each";
        text.metric = taps > 2 ? "radiance relative to each orientation's; to its rms over all (.5); shape (.05)"
                               : "radiance relative to each orientation's; to its rms over all (2); shape (.05)";
        text.table = table;
        good = lobe_env_table_write(&text, request->tables);
    }
    free(table);
    return good;
}
