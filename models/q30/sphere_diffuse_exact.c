#include "sphere_diffuse.h"
#include "../../core/q30_arc.h"

/* (atan z - z / (1 + z^2)) / (pi z^3), s = z^2: that of ../../core/arc.h anew, minimax with coefficients in Q30
 * (polynomials.sollya), within 1.8e-9. */
static int32_t sphere_segment_over_z3(int32_t s)
{
    static const int32_t p[11] = {227855090, -273425640, 292936350, -303464603, 307690868, -299541206,
                                  264294754, -192611168, 103195302, -34822494,  5436886};
    return lobe_q_polynomial(p, 10, s);
}

/* Where the light is nearly half the sky and nearly gone, both are small, and only their ratio counts. */
static void sphere_align(lobe_sphere_root a, lobe_sphere_root b, int32_t *x, int32_t *y)
{
    const int both = a.shift < b.shift ? a.shift : b.shift;
    *x = lobe_q_shift_right(a.value, a.shift - both);
    *y = lobe_q_shift_right(b.value, b.shift - both);
}

/* The segment and sin cos over pi of the angle of (cosine, q): the first of the third degree in q, the other of the
 * first, and q shifted left by e, which scales both. Only where e = 0 may the angle exceed 45 degrees. */
static void sphere_half_chord(int32_t q, int32_t cosine, int e, int32_t *segment, int32_t *product)
{
    const int32_t one_half = LOBE_Q30_ONE >> 1, inverse_pi = 341782638;
    const int steep = e == 0 && q > cosine;
    const int32_t far_side = steep ? q : cosine, near_side = steep ? cosine : q;
    /* q / cosine is at most 2 / sqrt(3) where e > 0: half of it is below 1 */
    const int32_t z = lobe_q_shift_left_saturated(lobe_q_ratio(near_side >> 1, lobe_q_reciprocal(far_side)), 1);
    const int32_t z2 = lobe_q_mul(z, z, 30), s = e < 16 ? lobe_q_shift_right(z2, 2 * e) : 0;
    const lobe_q_inverse inverse = lobe_q_reciprocal(one_half + (s >> 1)); /* of (1 + s) / 2 */
    const int32_t sine_cosine = lobe_q_mul(lobe_q_ratio(z >> 2, inverse), inverse_pi, 29);
    const int32_t octant = lobe_q_mul(lobe_q_mul(z2, z, 30), sphere_segment_over_z3(s), 30);
    *product = sine_cosine;
    *segment = steep ? one_half - octant - 2 * sine_cosine : octant;
}

lobe_scaled_q30 lobe_sphere_diffuse_exact_q30(int32_t n_dot_l, int32_t sine)
{
    lobe_sphere_cut a;
    lobe_scaled_q30 y;
    int32_t m, h, q, cosine, segment, product, excess, up;
    if (!lobe_sphere_diffuse_cut(n_dot_l, sine, &a, &y))
        return y;
    m = lobe_sphere_diffuse_magnitude(a.c);
    h = a.s - m;
    sphere_align(lobe_sphere_diffuse_fine_root(h, a.s - (h >> 1)),
                 lobe_sphere_diffuse_fine_across(lobe_q_saturate(sine)), &q, &cosine);
    sphere_half_chord(q, cosine, a.e, &segment, &product);
    excess = segment + lobe_q_mul(lobe_q_mul(m, m, 30), product, 30) -
             lobe_q_mul(lobe_q_mul(m, a.s2, 30), lobe_q_arc(q, lobe_q_mul(m, cosine, 30)), 30);
    up = lobe_q_mul(a.s2, lobe_q_max(a.c, 0), 30);
    return lobe_sphere_diffuse_scaled(up + lobe_q_max(excess, 0), -3 * a.e);
}
