/* The formulas of ../env_fresnel.h. x is Q30; weights, sums and parts have a block exponent, since quotients by the sum
 * do; the last tap's part is what the others leave of the bias. */
#include "../lobe.h"
#include "../../core/q30_scaled.h"
#include "../../core/q30_sqrt.h"

static int32_t lobe_env_grazing_fixed(int32_t v_dot_tap, int32_t width)
{
    const int32_t w = lobe_q_saturate(width), a = lobe_q_mul(w, w, 30);
    const int32_t c =
        lobe_q_mul(lobe_q_clamp(v_dot_tap, -LOBE_Q30_ONE, LOBE_Q30_ONE), LOBE_Q30_ONE - lobe_q_mul(a, a, 30), 30);
    const int32_t x = LOBE_Q30_ONE - lobe_q_sqrt((LOBE_Q30_ONE >> 1) + (c >> 1)), x2 = lobe_q_mul(x, x, 30);
    return lobe_q_mul(lobe_q_mul(x2, x2, 30), x, 30);
}

/* Held at 2^14, which eight of no fan reach. */
static lobe_q_scaled lobe_env_weight_fixed(int32_t weight_q16)
{
    return lobe_qs_of(lobe_q_clamp(weight_q16, -LOBE_Q30_ONE, LOBE_Q30_ONE), 14);
}

void lobe_env_fresnel_q30(const lobe_env_tap_q30 *taps, const int32_t *v_dot_tap, size_t n, int32_t bias,
                          int32_t *tap_bias_q16)
{
    const int32_t b = lobe_q_saturate(bias);
    lobe_q_scaled sum = lobe_qs_made(0, LOBE_QS_ZERO), grazing = sum, share, mean;
    uint32_t rest = (uint32_t)lobe_q16_from_q30(b);
    size_t i;
    for (i = 0; i < n; i++) {
        const lobe_q_scaled w = lobe_env_weight_fixed(taps[i].weight_q16);
        tap_bias_q16[i] = lobe_env_grazing_fixed(v_dot_tap[i], taps[i].width);
        sum = lobe_qs_add(sum, w);
        grazing = lobe_qs_add(grazing, lobe_qs_mul(w, lobe_qs_of(tap_bias_q16[i], 0)));
    }
    if (lobe_qs_less(sum, lobe_qs_of(LOBE_Q30_ONE / 1000, 0)))
        sum = lobe_qs_of(LOBE_Q30_ONE / 1000, 0); /* no albedo is as low */
    share = lobe_qs_div(lobe_qs_of(b, 0), sum);
    mean = lobe_qs_div(grazing, sum);
    for (i = 0; i < n; i++) {
        const lobe_q_scaled above = lobe_qs_sub(lobe_qs_of(tap_bias_q16[i], 0), mean);
        const lobe_q_scaled part = lobe_qs_add(share, lobe_qs_mul(above, lobe_qs_of(5 << 28, 0)));
        tap_bias_q16[i] =
            i + 1 < n ? lobe_qs_fixed(lobe_qs_mul(lobe_env_weight_fixed(taps[i].weight_q16), part), 16) : (int32_t)rest;
        rest -= (uint32_t)tap_bias_q16[i];
    }
}
