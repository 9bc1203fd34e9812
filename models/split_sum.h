/* The split sum of GGX with height-correlated Smith: reflectance under constant light is f0 scale + f90 bias.
 *
 * roughness is perceptual, alpha = a = roughness^2, v = n_dot_v; both inputs in [0, 1], clamped, NaN counts as 0.
 * scale, bias and E = scale + bias are in [0, 1] for every input. Errors: models/coeffs/split_sum_bounds.h.
 *
 * low was found by a search over straight-line programs (cases/split_sum/README.md): one kink for the effective
 * angle, its fifth power for the bias, and E as products of what is linear in roughness and v. It neither divides
 * nor takes a root, and polynomials have no poles.
 *
 * medium and high use one self-similar variable. With w = v + a k(a) and s = v / w, which runs from 0 at grazing
 * views to 1 at a mirror, the edge of E at v ~ a stands still as roughness goes to 0:
 *     E = 1 - s (1 - s) Q(s, a),   x = 1 - w U(s, r),   bias = E x^5,   scale = E - bias.
 * w > 0, since 1e-6 is added to a, so there are no poles. high adds s log2 s to E: at a = 1 the true E is
 * 1 - v ln((1 + v) / v), and with that singularity in the form the polynomials gain a factor of five. */
#ifndef LOBE_SPLIT_SUM_H
#define LOBE_SPLIT_SUM_H
#include "../core/log2.h"
#include "dfg.h"
#include "coeffs/split_sum_low.h"
#include "coeffs/split_sum_medium.h"
#include "coeffs/split_sum_high.h"

/* 20 operations. */
LOBE_FN lobe_dfg lobe_split_sum_low(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET t0 = LOBE_SPLIT_SUM_LOW_C0 - v;
    LOBE_LET t1 = r * LOBE_SPLIT_SUM_LOW_C1 + LOBE_SPLIT_SUM_LOW_C2;
    LOBE_LET t2 = v * LOBE_SPLIT_SUM_LOW_C3 + t1;
    LOBE_LET t3 = lobe_min(t0, t2);
    LOBE_LET t4 = t3 * t3;
    LOBE_LET t5 = t4 * t4;
    LOBE_LET t6 = t5 * t3;
    LOBE_LET t7 = LOBE_SPLIT_SUM_LOW_C4 * t5 + t1;
    LOBE_LET t8 = r * LOBE_SPLIT_SUM_LOW_C5 + LOBE_SPLIT_SUM_LOW_C6;
    LOBE_LET t9 = LOBE_SPLIT_SUM_LOW_C7 * t3 + v;
    LOBE_LET t10 = v * LOBE_SPLIT_SUM_LOW_C8 + LOBE_SPLIT_SUM_LOW_C9;
    LOBE_LET t11 = t9 * LOBE_SPLIT_SUM_LOW_C10 + t10;
    LOBE_LET t12 = t7 * t11 + t8;
    LOBE_LET t13 = t10 * v + r;
    LOBE_LET t14 = t6 * t12 + t11;
    LOBE_LET t15 = t14 * t13;
    LOBE_LET t16 = t8 * r + LOBE_SPLIT_SUM_LOW_C11;
    LOBE_LET t17 = LOBE_SPLIT_SUM_LOW_C12 * t14 + t15;
    LOBE_LET t18 = t16 - t17;
    LOBE_LET e = lobe_saturate(t18);
    LOBE_LET b = lobe_saturate(t6);
    return lobe_dfg_of_bias(e, b);
}

/* 40 operations. */
LOBE_FN lobe_dfg lobe_split_sum_medium(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET a = r * r + LOBE_R(1e-6);
    LOBE_LET w = v + a * (LOBE_SPLIT_SUM_MEDIUM_C0 + r * LOBE_SPLIT_SUM_MEDIUM_C1);
    LOBE_LET s = v / w;
    LOBE_LET t = LOBE_R(1.0) - s;
    LOBE_LET a2 = a * a;
    LOBE_LET q0 = LOBE_SPLIT_SUM_MEDIUM_C2 + a2 * (LOBE_SPLIT_SUM_MEDIUM_C3 + a * LOBE_SPLIT_SUM_MEDIUM_C4);
    LOBE_LET q1 = LOBE_SPLIT_SUM_MEDIUM_C5 + a * LOBE_SPLIT_SUM_MEDIUM_C6;
    LOBE_LET q2 = LOBE_SPLIT_SUM_MEDIUM_C7 +
                  a * (LOBE_SPLIT_SUM_MEDIUM_C8 + a2 * (LOBE_SPLIT_SUM_MEDIUM_C9 + a * LOBE_SPLIT_SUM_MEDIUM_C10));
    LOBE_LET q3 =
        LOBE_SPLIT_SUM_MEDIUM_C11 +
        a * (LOBE_SPLIT_SUM_MEDIUM_C12 +
             a * (LOBE_SPLIT_SUM_MEDIUM_C13 + a * (LOBE_SPLIT_SUM_MEDIUM_C14 + a * LOBE_SPLIT_SUM_MEDIUM_C15)));
    LOBE_LET q = q0 + s * (q1 + s * (q2 + s * (q3 + s * LOBE_SPLIT_SUM_MEDIUM_C16)));
    LOBE_LET u0 = LOBE_SPLIT_SUM_MEDIUM_C17 + r * (LOBE_SPLIT_SUM_MEDIUM_C18 + r * LOBE_SPLIT_SUM_MEDIUM_C19);
    LOBE_LET u1 = LOBE_SPLIT_SUM_MEDIUM_C20 + r * (LOBE_SPLIT_SUM_MEDIUM_C21 + r * LOBE_SPLIT_SUM_MEDIUM_C22);
    LOBE_LET u = u0 + s * (u1 + s * (LOBE_SPLIT_SUM_MEDIUM_C23 +
                                     s * (LOBE_SPLIT_SUM_MEDIUM_C24 +
                                          s * (LOBE_SPLIT_SUM_MEDIUM_C25 + s * LOBE_SPLIT_SUM_MEDIUM_C26))));
    LOBE_LET e = lobe_saturate(LOBE_R(1.0) - s * t * q);
    LOBE_LET x = lobe_saturate(LOBE_R(1.0) - w * u);
    return lobe_dfg_of_angle(e, x);
}

/* 80 operations. */
LOBE_FN lobe_dfg lobe_split_sum_high(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET a = r * r + LOBE_R(1e-6);
    LOBE_LET w = v + a * (LOBE_SPLIT_SUM_HIGH_C0 + a * LOBE_SPLIT_SUM_HIGH_C1);
    LOBE_LET s = v / w;
    LOBE_LET t = LOBE_R(1.0) - s;
    LOBE_LET log_s = lobe_log2(lobe_max(s, LOBE_R(1e-6)));
    LOBE_LET a2 = a * a;
    LOBE_LET s2 = s * s;
    LOBE_LET s4 = s2 * s2;
    LOBE_LET q0 = LOBE_SPLIT_SUM_HIGH_C2 +
                  s4 * (LOBE_SPLIT_SUM_HIGH_C14 +
                        s * (LOBE_SPLIT_SUM_HIGH_C17 + s * (LOBE_SPLIT_SUM_HIGH_C18 + s * LOBE_SPLIT_SUM_HIGH_C19)));
    LOBE_LET q1 = s * (LOBE_SPLIT_SUM_HIGH_C7 + s2 * LOBE_SPLIT_SUM_HIGH_C12);
    LOBE_LET q2 = LOBE_SPLIT_SUM_HIGH_C3 + s4 * LOBE_SPLIT_SUM_HIGH_C15;
    LOBE_LET q3 = LOBE_SPLIT_SUM_HIGH_C4 +
                  s2 * (LOBE_SPLIT_SUM_HIGH_C9 + s * (LOBE_SPLIT_SUM_HIGH_C13 + s * LOBE_SPLIT_SUM_HIGH_C16));
    LOBE_LET q4 = LOBE_SPLIT_SUM_HIGH_C5 + s2 * LOBE_SPLIT_SUM_HIGH_C10;
    LOBE_LET q5 = LOBE_SPLIT_SUM_HIGH_C6 + s2 * LOBE_SPLIT_SUM_HIGH_C11;
    LOBE_LET q6 = s * LOBE_SPLIT_SUM_HIGH_C8;
    LOBE_LET q = q0 + a * (q1 + a * (q2 + a * (q3 + a * (q4 + a * (q5 + a * q6)))));
    LOBE_LET l0 = a2 * (LOBE_SPLIT_SUM_HIGH_C20 + a2 * LOBE_SPLIT_SUM_HIGH_C21);
    LOBE_LET l1 = LOBE_SPLIT_SUM_HIGH_C22 + a2 * (LOBE_SPLIT_SUM_HIGH_C23 + a * LOBE_SPLIT_SUM_HIGH_C24);
    LOBE_LET l2 = a * (LOBE_SPLIT_SUM_HIGH_C25 + a * LOBE_SPLIT_SUM_HIGH_C26);
    LOBE_LET l = l0 + s * (l1 + s * (l2 + s2 * LOBE_SPLIT_SUM_HIGH_C27));
    LOBE_LET u0 =
        LOBE_SPLIT_SUM_HIGH_C28 +
        s * (LOBE_SPLIT_SUM_HIGH_C36 +
             s2 * (LOBE_SPLIT_SUM_HIGH_C45 +
                   s * (LOBE_SPLIT_SUM_HIGH_C48 + s2 * (LOBE_SPLIT_SUM_HIGH_C54 + s * LOBE_SPLIT_SUM_HIGH_C55))));
    LOBE_LET u1 = LOBE_SPLIT_SUM_HIGH_C29 +
                  s * (LOBE_SPLIT_SUM_HIGH_C37 +
                       s2 * (LOBE_SPLIT_SUM_HIGH_C46 + s * (LOBE_SPLIT_SUM_HIGH_C49 + s * LOBE_SPLIT_SUM_HIGH_C52)));
    LOBE_LET u2 = LOBE_SPLIT_SUM_HIGH_C30 +
                  s * (LOBE_SPLIT_SUM_HIGH_C38 +
                       s * (LOBE_SPLIT_SUM_HIGH_C42 + s2 * (LOBE_SPLIT_SUM_HIGH_C50 + s * LOBE_SPLIT_SUM_HIGH_C53)));
    LOBE_LET u3 = LOBE_SPLIT_SUM_HIGH_C31 +
                  s * (LOBE_SPLIT_SUM_HIGH_C39 +
                       s * (LOBE_SPLIT_SUM_HIGH_C43 + s * (LOBE_SPLIT_SUM_HIGH_C47 + s * LOBE_SPLIT_SUM_HIGH_C51)));
    LOBE_LET u4 = LOBE_SPLIT_SUM_HIGH_C32 + s * LOBE_SPLIT_SUM_HIGH_C40;
    LOBE_LET u5 = LOBE_SPLIT_SUM_HIGH_C33 + s * (LOBE_SPLIT_SUM_HIGH_C41 + s * LOBE_SPLIT_SUM_HIGH_C44);
    LOBE_LET u =
        u0 +
        r * (u1 +
             r * (u2 + r * (u3 + r * (u4 + r * (u5 + r * (LOBE_SPLIT_SUM_HIGH_C34 + r * LOBE_SPLIT_SUM_HIGH_C35))))));
    LOBE_LET e = lobe_saturate(LOBE_R(1.0) - s * t * (q + log_s * l));
    LOBE_LET x = lobe_saturate(LOBE_R(1.0) - w * u);
    return lobe_dfg_of_angle(e, x);
}

#endif
