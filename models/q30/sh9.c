#include "../lobe.h"
#include "../../core/q30.h"

lobe_sh9_q30 lobe_sh9_other_sign_q30(lobe_sh9_q30 c)
{
    const int odd[4] = {1, 3, 5, 7};
    int k;
    for (k = 0; k < 4; k++)
        c.c[odd[k]] = lobe_q_subtract_saturated(0, c.c[odd[k]]);
    return c;
}
