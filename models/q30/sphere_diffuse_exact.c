#include "sphere_diffuse.h"

/* The polynomials of ../../core/arc.h anew, minimax over z^2 with coefficients in Q30 (polynomials.sollya): within
 * 9.4e-10 and 1.8e-9. */
static int32_t sphere_polynomial(const int32_t *p, int degree, int32_t x)
{
    int32_t y = p[degree];
    int k;
    for (k = degree - 1; k >= 0; k--)
        y = p[k] + lobe_q_mul(x, y, 30);
    return y;
}

/* atan z / pi for z in [0, 1]. */
static int32_t sphere_arc_octant(int32_t z)
{
    static const int32_t p[10] = {341782637, -113927388, 68350970,  -48748871, 37419808,
                                  -28697534, 19784368,   -10644120, 3729356,   -613771};
    return lobe_q_mul(z, sphere_polynomial(p, 9, lobe_q_mul(z, z, 30)), 30);
}

/* The angle of (x, y) over pi. */
static int32_t sphere_arc(int32_t y, int32_t x)
{
    const int32_t far_side = lobe_q_max(x, y),
                  octant = sphere_arc_octant(lobe_q_ratio(lobe_q_min(x, y), lobe_q_reciprocal(far_side)));
    return y > x ? (LOBE_Q30_ONE >> 1) - octant : octant;
}

/* (atan z - z / (1 + z^2)) / (pi z^3), s = z^2. */
static int32_t sphere_segment_over_z3(int32_t s)
{
    static const int32_t p[11] = {227855090, -273425640, 292936350, -303464603, 307690868, -299541206,
                                  264294754, -192611168, 103195302, -34822494,  5436886};
    return sphere_polynomial(p, 10, s);
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
             lobe_q_mul(lobe_q_mul(m, a.s2, 30), sphere_arc(q, lobe_q_mul(m, cosine, 30)), 30);
    up = lobe_q_mul(a.s2, lobe_q_max(a.c, 0), 30);
    return lobe_sphere_diffuse_scaled(up + lobe_q_max(excess, 0), -3 * a.e);
}
