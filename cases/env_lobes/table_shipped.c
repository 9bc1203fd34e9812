#define LOBE_DOUBLE 1
#include "../../models/env_lobes1.h"
#include "../../models/env_lobes2.h"
#include "../../models/env_lobes4.h"
#include "../../models/env_lobes8.h"
#include "../../models/q30/env_lobes_rows.h"
#include "../fit/coefficients.h"
#include "table_tier.h"

/* The rows of the integer tiers, as they stand in the headers. */
#undef LOBE_ENV_ROW
#define LOBE_ENV_ROW(P, a, b, c, d, e, f, g, h, i, j, k, l)                                                            \
    {                                                                                                                  \
        P##a, P##b, P##c, P##d, P##e, P##f, P##g, P##h, P##i, P##j, P##k, P##l                                         \
    }
static const double lobes1[][LOBE_FAN_TERMS] = LOBE_ENV_LOBES1_ROWS, lobes2[][LOBE_FAN_TERMS] = LOBE_ENV_LOBES2_ROWS,
                    lobes4[][LOBE_FAN_TERMS] = LOBE_ENV_LOBES4_ROWS, lobes8[][LOBE_FAN_TERMS] = LOBE_ENV_LOBES8_ROWS;

void lobe_env_table_shipped(int taps, double *p)
{
    const double *from = taps == 1 ? lobes1[0] : taps == 2 ? lobes2[0] : taps == 4 ? lobes4[0] : lobes8[0];
    for (int i = 0; i < lobe_fan_count(taps); i++)
        p[i] = lobe_coefficient_rounded(from[i]);
}
