/* The operations that models/coeffs/env_lobes*_bounds.h state are those of the kernels' texts. */
#include "../../models/coeffs/env_lobes_bounds.h"
#include "../../models/coeffs/env_lobes_sg_bounds.h"
#include "../env_lobes/operations.h"
#include <stdio.h>

static const int stated[3][4] = {
    {LOBE_ENV_LOBES_LOBES1_OPS, LOBE_ENV_LOBES_LOBES2_OPS, LOBE_ENV_LOBES_LOBES4_OPS, LOBE_ENV_LOBES_LOBES8_OPS},
    {LOBE_ENV_LOBES_SG_LOBES1_OPS, LOBE_ENV_LOBES_SG_LOBES2_OPS, LOBE_ENV_LOBES_SG_LOBES4_OPS,
     LOBE_ENV_LOBES_SG_LOBES8_OPS},
    {LOBE_ENV_LOBES_LOBES1_TABLE16_OPS, LOBE_ENV_LOBES_LOBES2_TABLE16_OPS, LOBE_ENV_LOBES_LOBES4_TABLE16_OPS,
     LOBE_ENV_LOBES_LOBES8_TABLE16_OPS}};
static const char *const named[3] = {"env_lobes", "env_lobes_sg", "env_lobes table16"};

int main(void)
{
    int kind, k, failed = 0;
    for (kind = 0; kind < 3; kind++) {
        for (k = 0; k < 4; k++) {
            const int counted = kind == 2 ? lobe_env_table_operations(1 << k) : lobe_env_operations(kind, 1 << k);
            const int good = counted == stated[kind][k];
            printf("%sok %d - %s lobes%d: %d operations stated, %d counted\n", good ? "" : "not ", 4 * kind + k + 1,
                   named[kind], 1 << k, stated[kind][k], counted);
            failed |= !good;
        }
    }
    {
        const int counted = lobe_env_adaptive_operations(), good = counted == LOBE_ENV_LOBES_ADAPTIVE_OPS;
        printf("%sok 13 - env_lobes adaptive: %d operations stated, %d counted\n", good ? "" : "not ",
               LOBE_ENV_LOBES_ADAPTIVE_OPS, counted);
        failed |= !good;
    }
    printf("1..13\n");
    return failed;
}
