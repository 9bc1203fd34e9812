#include "../lobe.h"
#include "../../core/q30.h"

/* E is at least .3, so the quotient stays under 4, and the 2^-29.4 of the reciprocal under 2^-27. */
int32_t lobe_energy_inverse_medium_q29(int32_t roughness, int32_t n_dot_v)
{
    const lobe_q_inverse inverse = lobe_q_reciprocal(lobe_energy_medium_q30(roughness, n_dot_v));
    return lobe_q_quotient(LOBE_Q30_ONE, inverse, 29);
}
