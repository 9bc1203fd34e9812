/* The split sum of GGX with separable Smith, G1(l) G1(v): what engines shipped before the height-correlated form.
 *
 * Inputs, ranges and the variables are those of models/split_sum.h. E does not reach 1 at grazing views here, so the
 * forms of medium and high have no factor s, and no logarithm:
 *     E = 1 - (1 - s) Q(s, a),   x = 1 - w U(s, r),   bias = E x^5,   scale = E - bias.
 * Errors: models/coeffs/split_sum_sep_bounds.h. */
#ifndef LOBE_SPLIT_SUM_SEP_H
#define LOBE_SPLIT_SUM_SEP_H
#include "dfg.h"
#include "coeffs/split_sum_sep_low.h"
#include "coeffs/split_sum_sep_medium.h"
#include "coeffs/split_sum_sep_high.h"

/* 20 operations. */
LOBE_FN lobe_dfg lobe_split_sum_sep_low(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET t0 = LOBE_SPLIT_SUM_SEP_LOW_C0 * v + LOBE_SPLIT_SUM_SEP_LOW_C1;
    LOBE_LET t1 = LOBE_SPLIT_SUM_SEP_LOW_C2 * r + LOBE_SPLIT_SUM_SEP_LOW_C3;
    LOBE_LET t2 = v * LOBE_SPLIT_SUM_SEP_LOW_C4 + t1;
    LOBE_LET t3 = lobe_min(t0, t2);
    LOBE_LET t4 = t3 * t3;
    LOBE_LET t5 = LOBE_SPLIT_SUM_SEP_LOW_C5 * t4 + v;
    LOBE_LET t6 = t4 * t4;
    LOBE_LET t7 = t2 * t6;
    LOBE_LET t8 = LOBE_SPLIT_SUM_SEP_LOW_C6 * t6 + LOBE_SPLIT_SUM_SEP_LOW_C7;
    LOBE_LET t9 = LOBE_SPLIT_SUM_SEP_LOW_C8 * t5 + LOBE_SPLIT_SUM_SEP_LOW_C9;
    LOBE_LET t10 = LOBE_SPLIT_SUM_SEP_LOW_C10 * t7 + LOBE_SPLIT_SUM_SEP_LOW_C11;
    LOBE_LET t11 = t10 * r + LOBE_SPLIT_SUM_SEP_LOW_C12;
    LOBE_LET t12 = t8 * v + r;
    LOBE_LET t13 = t9 * t10 + LOBE_SPLIT_SUM_SEP_LOW_C13;
    LOBE_LET t14 = LOBE_SPLIT_SUM_SEP_LOW_C14 * t1 + t13;
    LOBE_LET t15 = t14 * t12;
    LOBE_LET t16 = t11 - t15;
    LOBE_LET t17 = t4 * LOBE_SPLIT_SUM_SEP_LOW_C15 + t7;
    LOBE_LET t18 = lobe_saturate(t16);
    LOBE_LET t19 = LOBE_SPLIT_SUM_SEP_LOW_C16 * t18;
    LOBE_LET e = lobe_saturate(t19);
    LOBE_LET b = lobe_saturate(t17);
    return lobe_dfg_of_bias(e, b);
}

/* 39 operations. */
LOBE_FN lobe_dfg lobe_split_sum_sep_medium(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET a = r * r + LOBE_R(1e-6);
    LOBE_LET w = v + a * LOBE_SPLIT_SUM_SEP_MEDIUM_C0;
    LOBE_LET s = v / w;
    LOBE_LET t = LOBE_R(1.0) - s;
    LOBE_LET a2 = a * a;
    LOBE_LET s2 = s * s;
    LOBE_LET q0 =
        LOBE_SPLIT_SUM_SEP_MEDIUM_C1 +
        a2 * (LOBE_SPLIT_SUM_SEP_MEDIUM_C2 + a * (LOBE_SPLIT_SUM_SEP_MEDIUM_C3 + a * LOBE_SPLIT_SUM_SEP_MEDIUM_C4));
    LOBE_LET q1 = LOBE_SPLIT_SUM_SEP_MEDIUM_C5 + a2 * LOBE_SPLIT_SUM_SEP_MEDIUM_C6;
    LOBE_LET q3 =
        a2 * (LOBE_SPLIT_SUM_SEP_MEDIUM_C7 + a * (LOBE_SPLIT_SUM_SEP_MEDIUM_C8 + a * LOBE_SPLIT_SUM_SEP_MEDIUM_C9));
    LOBE_LET q =
        q0 + s * (q1 + s2 * (q3 + s * (LOBE_SPLIT_SUM_SEP_MEDIUM_C10 +
                                       s * (LOBE_SPLIT_SUM_SEP_MEDIUM_C11 + s * LOBE_SPLIT_SUM_SEP_MEDIUM_C12))));
    LOBE_LET u0 = LOBE_SPLIT_SUM_SEP_MEDIUM_C13 +
                  r * (LOBE_SPLIT_SUM_SEP_MEDIUM_C14 +
                       r * (LOBE_SPLIT_SUM_SEP_MEDIUM_C15 +
                            r * (LOBE_SPLIT_SUM_SEP_MEDIUM_C16 + r * LOBE_SPLIT_SUM_SEP_MEDIUM_C17)));
    LOBE_LET u1 =
        LOBE_SPLIT_SUM_SEP_MEDIUM_C18 +
        r * (LOBE_SPLIT_SUM_SEP_MEDIUM_C19 + r * (LOBE_SPLIT_SUM_SEP_MEDIUM_C20 + r * LOBE_SPLIT_SUM_SEP_MEDIUM_C21));
    LOBE_LET u3 = LOBE_SPLIT_SUM_SEP_MEDIUM_C22 + r * LOBE_SPLIT_SUM_SEP_MEDIUM_C23;
    LOBE_LET u = u0 + s * (u1 + s2 * (u3 + s * LOBE_SPLIT_SUM_SEP_MEDIUM_C24));
    LOBE_LET e = lobe_saturate(LOBE_R(1.0) - t * q);
    LOBE_LET x = lobe_saturate(LOBE_R(1.0) - w * u);
    return lobe_dfg_of_angle(e, x);
}

/* 77 operations. */
LOBE_FN lobe_dfg lobe_split_sum_sep_high(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET a = r * r + LOBE_R(1e-6);
    LOBE_LET w = v + a * (LOBE_SPLIT_SUM_SEP_HIGH_C0 + a * LOBE_SPLIT_SUM_SEP_HIGH_C1);
    LOBE_LET s = v / w;
    LOBE_LET t = LOBE_R(1.0) - s;
    LOBE_LET a2 = a * a;
    LOBE_LET a3 = a2 * a;
    LOBE_LET s2 = s * s;
    LOBE_LET q0 = LOBE_SPLIT_SUM_SEP_HIGH_C2 +
                  a * (LOBE_SPLIT_SUM_SEP_HIGH_C3 +
                       a * (LOBE_SPLIT_SUM_SEP_HIGH_C4 +
                            a * (LOBE_SPLIT_SUM_SEP_HIGH_C5 +
                                 a * (LOBE_SPLIT_SUM_SEP_HIGH_C6 + a * LOBE_SPLIT_SUM_SEP_HIGH_C7))));
    LOBE_LET q1 = LOBE_SPLIT_SUM_SEP_HIGH_C8 +
                  a * (LOBE_SPLIT_SUM_SEP_HIGH_C9 +
                       a2 * (LOBE_SPLIT_SUM_SEP_HIGH_C10 +
                             a * (LOBE_SPLIT_SUM_SEP_HIGH_C11 +
                                  a * (LOBE_SPLIT_SUM_SEP_HIGH_C12 + a * LOBE_SPLIT_SUM_SEP_HIGH_C13))));
    LOBE_LET q2 =
        LOBE_SPLIT_SUM_SEP_HIGH_C14 +
        a2 * (LOBE_SPLIT_SUM_SEP_HIGH_C15 + a * (LOBE_SPLIT_SUM_SEP_HIGH_C16 + a3 * LOBE_SPLIT_SUM_SEP_HIGH_C17));
    LOBE_LET q3 =
        LOBE_SPLIT_SUM_SEP_HIGH_C18 +
        a3 * (LOBE_SPLIT_SUM_SEP_HIGH_C19 + a * (LOBE_SPLIT_SUM_SEP_HIGH_C20 + a * LOBE_SPLIT_SUM_SEP_HIGH_C21));
    LOBE_LET q4 = LOBE_SPLIT_SUM_SEP_HIGH_C22 + a * (LOBE_SPLIT_SUM_SEP_HIGH_C23 + a * LOBE_SPLIT_SUM_SEP_HIGH_C24);
    LOBE_LET q5 = LOBE_SPLIT_SUM_SEP_HIGH_C25 + a * (LOBE_SPLIT_SUM_SEP_HIGH_C26 + a * LOBE_SPLIT_SUM_SEP_HIGH_C27);
    LOBE_LET q6 = LOBE_SPLIT_SUM_SEP_HIGH_C28 + a * (LOBE_SPLIT_SUM_SEP_HIGH_C29 + a * LOBE_SPLIT_SUM_SEP_HIGH_C30);
    LOBE_LET q7 = LOBE_SPLIT_SUM_SEP_HIGH_C31 + a * LOBE_SPLIT_SUM_SEP_HIGH_C32;
    LOBE_LET q =
        q0 +
        s * (q1 + s * (q2 + s * (q3 + s * (q4 + s * (q5 + s * (q6 + s * (q7 + s * LOBE_SPLIT_SUM_SEP_HIGH_C33)))))));
    LOBE_LET u0 = LOBE_SPLIT_SUM_SEP_HIGH_C34 +
                  s * (LOBE_SPLIT_SUM_SEP_HIGH_C42 +
                       s2 * (LOBE_SPLIT_SUM_SEP_HIGH_C52 +
                             s2 * (LOBE_SPLIT_SUM_SEP_HIGH_C58 + s2 * LOBE_SPLIT_SUM_SEP_HIGH_C62)));
    LOBE_LET u1 = LOBE_SPLIT_SUM_SEP_HIGH_C35 +
                  s * (LOBE_SPLIT_SUM_SEP_HIGH_C43 +
                       s * (LOBE_SPLIT_SUM_SEP_HIGH_C49 +
                            s * (LOBE_SPLIT_SUM_SEP_HIGH_C53 +
                                 s * (LOBE_SPLIT_SUM_SEP_HIGH_C55 +
                                      s * (LOBE_SPLIT_SUM_SEP_HIGH_C59 + s * LOBE_SPLIT_SUM_SEP_HIGH_C61)))));
    LOBE_LET u2 = LOBE_SPLIT_SUM_SEP_HIGH_C36 +
                  s * (LOBE_SPLIT_SUM_SEP_HIGH_C44 +
                       s * (LOBE_SPLIT_SUM_SEP_HIGH_C50 +
                            s * (LOBE_SPLIT_SUM_SEP_HIGH_C54 +
                                 s * (LOBE_SPLIT_SUM_SEP_HIGH_C56 + s * LOBE_SPLIT_SUM_SEP_HIGH_C60))));
    LOBE_LET u3 =
        LOBE_SPLIT_SUM_SEP_HIGH_C37 +
        s * (LOBE_SPLIT_SUM_SEP_HIGH_C45 + s * (LOBE_SPLIT_SUM_SEP_HIGH_C51 + s2 * LOBE_SPLIT_SUM_SEP_HIGH_C57));
    LOBE_LET u4 = LOBE_SPLIT_SUM_SEP_HIGH_C38 + s * LOBE_SPLIT_SUM_SEP_HIGH_C46;
    LOBE_LET u5 = LOBE_SPLIT_SUM_SEP_HIGH_C39 + s * LOBE_SPLIT_SUM_SEP_HIGH_C47;
    LOBE_LET u6 = LOBE_SPLIT_SUM_SEP_HIGH_C40 + s * LOBE_SPLIT_SUM_SEP_HIGH_C48;
    LOBE_LET u = u0 + r * (u1 + r * (u2 + r * (u3 + r * (u4 + r * (u5 + r * (u6 + r * LOBE_SPLIT_SUM_SEP_HIGH_C41))))));
    LOBE_LET e = lobe_saturate(LOBE_R(1.0) - t * q);
    LOBE_LET x = lobe_saturate(LOBE_R(1.0) - w * u);
    return lobe_dfg_of_angle(e, x);
}

#endif
