/* The operations that models/coeffs/env_lobes*_bounds.h state are those of the kernels' texts. */
#include "../../models/coeffs/env_lobes_bounds.h"
#include "../../models/coeffs/env_lobes_sg_bounds.h"
#include "../env_lobes/operations.h"
#include <stdio.h>

static const int stated[2][4] = {
    {LOBE_ENV_LOBES_LOBES1_OPS, LOBE_ENV_LOBES_LOBES2_OPS, LOBE_ENV_LOBES_LOBES4_OPS, LOBE_ENV_LOBES_LOBES8_OPS},
    {LOBE_ENV_LOBES_SG_LOBES1_OPS, LOBE_ENV_LOBES_SG_LOBES2_OPS, LOBE_ENV_LOBES_SG_LOBES4_OPS,
     LOBE_ENV_LOBES_SG_LOBES8_OPS}};

int main(void)
{
    int gaussian, k, failed = 0;
    for (gaussian = 0; gaussian < 2; gaussian++) {
        for (k = 0; k < 4; k++) {
            const int counted = lobe_env_operations(gaussian, 1 << k), good = counted == stated[gaussian][k];
            printf("%sok %d - %s lobes%d: %d operations stated, %d counted\n", good ? "" : "not ", 4 * gaussian + k + 1,
                   gaussian ? "env_lobes_sg" : "env_lobes", 1 << k, stated[gaussian][k], counted);
            failed |= !good;
        }
    }
    printf("1..8\n");
    return failed;
}
