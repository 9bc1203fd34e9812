#include "../lobe.h"
#include "../../core/q30.h"

int32_t lobe_scaled_to_q30(lobe_scaled_q30 value)
{
    const int32_t m = value.mantissa, e = value.exponent;
    if (e > 30)
        return m > 0 ? 0x7fffffff : m < 0 ? -0x7fffffff - 1 : 0;
    if (e >= 0)
        return lobe_q_shift_left_saturated(m, e);
    return e < -31 ? 0 : lobe_q_shift_right(m, -e);
}
