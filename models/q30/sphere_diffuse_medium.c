#include "../../core/dialect.h"
#include "../coeffs/sphere_diffuse_medium.h"
#include "sphere_diffuse.h"

/* The sum below is at least the cosine and at most 1.94: cosine + .77 run - .16 q + .16 k, and q <= run. */
lobe_scaled_q30 lobe_sphere_diffuse_medium_q30(int32_t n_dot_l, int32_t sine)
{
    const int32_t c0 = LOBE_SPHERE_DIFFUSE_Q(LOBE_SPHERE_DIFFUSE_MEDIUM_C0);
    const int32_t c1 = LOBE_SPHERE_DIFFUSE_Q(LOBE_SPHERE_DIFFUSE_MEDIUM_C1);
    const int32_t c2 = LOBE_SPHERE_DIFFUSE_Q(LOBE_SPHERE_DIFFUSE_MEDIUM_C2);
    const int32_t c3 = LOBE_SPHERE_DIFFUSE_Q(LOBE_SPHERE_DIFFUSE_MEDIUM_C3);
    const int32_t c4 = LOBE_SPHERE_DIFFUSE_Q(LOBE_SPHERE_DIFFUSE_MEDIUM_C4);
    lobe_sphere_cut a;
    lobe_scaled_q30 y;
    int32_t m, k, q, run, sum, bottom, part, top, less;
    if (!lobe_sphere_diffuse_cut(n_dot_l, sine, &a, &y))
        return y;
    m = lobe_sphere_diffuse_magnitude(a.c);
    k = a.e < 16 ? lobe_q_shift_right(a.k, 2 * a.e) : 0;
    q = lobe_q_shift_right(lobe_sphere_diffuse_root(a.s - m, a.s - ((a.s - m) >> 1)), a.e);
    run = lobe_sphere_diffuse_across(lobe_q_shift_right(m, a.e));
    sum = a.cosine + lobe_q_mul(c2, run, 30) + lobe_q_mul(c3, q, 30) + lobe_q_mul(c4, k, 30);
    top = lobe_q_mul(c0, a.s2, 30) + lobe_q_mul(c1, a.k, 30);
    /* cosine / (2 s sum) is at most 1, since sum >= cosine and s >= 1/2 */
    bottom = lobe_q_mul(a.s, lobe_q_max(sum, a.cosine), 30);
    part = lobe_q_ratio(lobe_q_min(a.cosine >> 1, bottom), lobe_q_reciprocal(bottom));
    less = lobe_q_mul(lobe_q_mul(a.k, part, 30), top, 29);
    return lobe_sphere_diffuse_scaled(lobe_q_mul(a.s2, a.c + a.s, 31) - less, -3 * a.e);
}
