#include "../../core/dialect.h"
#include "../coeffs/sphere_diffuse_low.h"
#include "sphere_diffuse.h"

/* Coefficients and their sums are below 1, so nothing leaves [-2, 2): k and cosine are at most 1. */
lobe_scaled_q30 lobe_sphere_diffuse_low_q30(int32_t n_dot_l, int32_t sine)
{
    const int32_t c0 = LOBE_SPHERE_DIFFUSE_Q(LOBE_SPHERE_DIFFUSE_LOW_C0);
    const int32_t c1 = LOBE_SPHERE_DIFFUSE_Q(LOBE_SPHERE_DIFFUSE_LOW_C1);
    const int32_t c2 = LOBE_SPHERE_DIFFUSE_Q(LOBE_SPHERE_DIFFUSE_LOW_C2);
    lobe_sphere_cut a;
    lobe_scaled_q30 y;
    int32_t k, ratio, less, full;
    if (!lobe_sphere_diffuse_cut(n_dot_l, sine, &a, &y))
        return y;
    k = a.e < 16 ? lobe_q_shift_right(a.k, 2 * a.e) : 0;
    ratio = c0 + lobe_q_mul(c1, a.cosine, 30) + lobe_q_mul(c2, k, 30);
    less = lobe_q_mul(lobe_q_mul(a.s, a.k, 30), lobe_q_mul(a.cosine, ratio, 30), 30);
    full = lobe_q_mul(a.s2, a.c + a.s, 31); /* c + s < 2: the sum of two that are not both 1 */
    return lobe_sphere_diffuse_scaled(full - less, -3 * a.e);
}
