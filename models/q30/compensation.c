#include "../lobe.h"
#include "../../core/q30.h"

enum { LOBE_ONE_Q29 = 1 << 29 };

int32_t lobe_compensation_q29(int32_t f0, int32_t inverse_e)
{
    const int32_t lost = lobe_q_max(inverse_e, LOBE_ONE_Q29) - LOBE_ONE_Q29;
    return LOBE_ONE_Q29 + lobe_q_mul(lobe_q_saturate(f0), lost, 30);
}

static int32_t lobe_q_alpha2(int32_t roughness)
{
    const int32_t r = lobe_q_saturate(roughness), a = lobe_q_mul(r, r, 30);
    return lobe_q_mul(a, a, 30);
}

/* 2 alpha^2 v in Q29 has the digits of alpha^2 v in Q30. */
int32_t lobe_inverse_energy_alpha2_view_q29(int32_t roughness, int32_t n_dot_v)
{
    return LOBE_ONE_Q29 + lobe_q_mul(lobe_q_alpha2(roughness), lobe_q_saturate(n_dot_v), 30);
}

int32_t lobe_inverse_energy_alpha2_q29(int32_t roughness)
{
    return LOBE_ONE_Q29 + lobe_q_shift_right(lobe_q_alpha2(roughness), 1);
}
