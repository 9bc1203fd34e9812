#include "../lobe.h"
#include "../../core/q30.h"

/* The root of x in [0, 1], to nearest: digit by digit, since sqrt(x / 2^30) 2^30 is the root of the integer x 2^30. */
static int32_t lobe_q_root(int32_t x)
{
    uint64_t rest = (uint64_t)x << 30, digits = 0, bit = (uint64_t)1 << 60;
    int i;
    for (i = 0; i < 31; i++) {
        const uint64_t step = digits + bit;
        digits >>= 1;
        if (rest >= step) {
            rest -= step;
            digits += bit;
        }
        bit >>= 2;
    }
    return (int32_t)(digits + (rest > digits ? 1u : 0u));
}

int32_t lobe_alpha_of_roughness_q30(int32_t roughness)
{
    const int32_t r = lobe_q_saturate(roughness);
    return lobe_q_mul(r, r, 30);
}

int32_t lobe_roughness_of_alpha_q30(int32_t alpha) { return lobe_q_root(lobe_q_saturate(alpha)); }

int32_t lobe_roughness_of_smoothness_q30(int32_t smoothness) { return LOBE_Q30_ONE - lobe_q_saturate(smoothness); }

int32_t lobe_roughness_of_gloss_q30(int32_t gloss)
{
    const int32_t m = LOBE_Q30_ONE - lobe_q_saturate(gloss);
    return lobe_q_mul(m, m, 30);
}

int32_t lobe_gloss_of_roughness_q30(int32_t roughness)
{
    return LOBE_Q30_ONE - lobe_q_root(lobe_q_saturate(roughness));
}

/* alpha^2 = 2 / (n + 2); n + 2 must fit Q16.16 too. */
int32_t lobe_roughness_of_phong_q30(int32_t exponent_q16)
{
    const int32_t n = lobe_q_clamp(exponent_q16, 0, 0x7ffd0000);
    const int32_t alpha2 = lobe_q_quotient(2 << 16, lobe_q_reciprocal(n + (2 << 16)), 30);
    return lobe_q_root(lobe_q_root(alpha2));
}

/* Half of the exponent first, 1 / alpha^2 - 1: the other half is a shift that saturates. */
int32_t lobe_phong_of_roughness_q16(int32_t roughness)
{
    const int32_t a = lobe_alpha_of_roughness_q30(roughness);
    const int32_t alpha2 = lobe_q_mul(a, a, 30);
    const int32_t half = lobe_q_quotient(LOBE_Q30_ONE, lobe_q_reciprocal(alpha2), 16);
    return lobe_q_shift_left_saturated(half - (1 << 16), 1);
}
