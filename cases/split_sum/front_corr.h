/* The front that was explored, height-correlated Smith: a form at the operation count of each published formula.
 * None ships; `lobefit search` fits each from scratch and prints what it reaches. p[i] are its coefficients. */
#ifndef LOBE_FRONT_CORR_H
#define LOBE_FRONT_CORR_H
#include "../../core/log2.h"
#include "../../models/dfg.h"

LOBE_FN lobe_dfg lobe_front_corr_14(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET t0 = p[0] * r + p[1];
    LOBE_LET t1 = p[2] - v;
    LOBE_LET t2 = r * t0 + p[3];
    LOBE_LET t3 = v * p[4] + t2;
    LOBE_LET t4 = p[5] * t1 + t2;
    LOBE_LET t5 = lobe_min(t1, t2);
    LOBE_LET t6 = t4 * t5;
    LOBE_LET t7 = t6 * t6;
    LOBE_LET t8 = p[6] * t3 + p[7];
    LOBE_LET t9 = r * p[8] + v;
    LOBE_LET t10 = p[9] * r + p[10];
    LOBE_LET t11 = t9 * t8 + t7;
    LOBE_LET t12 = t10 * t11 + p[11];
    LOBE_LET e = lobe_saturate(t12);
    LOBE_LET b = lobe_saturate(t7);
    return lobe_dfg_of_bias(e, b);
}

LOBE_FN lobe_dfg lobe_front_corr_16(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET t0 = p[0] - v;
    LOBE_LET t1 = r * p[1] + p[2];
    LOBE_LET t2 = v * p[3] + t1;
    LOBE_LET t3 = lobe_saturate(t2);
    LOBE_LET t4 = lobe_min(t1, t0);
    LOBE_LET t5 = t3 * t4;
    LOBE_LET t6 = t5 * t5;
    LOBE_LET t7 = t6 * t4;
    LOBE_LET t8 = t0 * p[4] + t2;
    LOBE_LET t9 = r * v + p[5];
    LOBE_LET t10 = p[6] * t1 + p[7];
    LOBE_LET t11 = t7 * p[8] + t9;
    LOBE_LET t12 = t8 * t11;
    LOBE_LET t13 = p[9] * t6 + p[10];
    LOBE_LET t14 = p[11] * v + t13;
    LOBE_LET t15 = t14 * t12 + t10;
    LOBE_LET e = lobe_saturate(t15);
    LOBE_LET b = lobe_saturate(t7);
    return lobe_dfg_of_bias(e, b);
}

LOBE_FN lobe_dfg lobe_front_corr_17(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET t0 = p[0] - v;
    LOBE_LET t1 = r * p[1] + p[2];
    LOBE_LET t2 = p[3] * v + t1;
    LOBE_LET t3 = t0 * p[4] + t2;
    LOBE_LET t4 = t3 * t0 + p[5];
    LOBE_LET t5 = lobe_min(t1, t0);
    LOBE_LET t6 = t5 * t3;
    LOBE_LET t7 = t6 * t6;
    LOBE_LET t8 = t7 * t5;
    LOBE_LET t9 = t3 * p[6] + t2;
    LOBE_LET t10 = v * r + p[7];
    LOBE_LET t11 = t4 * t10 + p[8];
    LOBE_LET t12 = t8 * t0 + t11;
    LOBE_LET t13 = t9 * t12;
    LOBE_LET t14 = p[9] * t7 + p[10];
    LOBE_LET t15 = t14 * t13 + p[11];
    LOBE_LET e = lobe_saturate(t15);
    LOBE_LET b = lobe_saturate(t8);
    return lobe_dfg_of_bias(e, b);
}

LOBE_FN lobe_dfg lobe_front_corr_18(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET t0 = p[0] - v;
    LOBE_LET t1 = r * p[1] + p[2];
    LOBE_LET t2 = p[3] * v + t1;
    LOBE_LET t3 = t0 * p[4] + t2;
    LOBE_LET t4 = t3 * t0 + p[5];
    LOBE_LET t5 = lobe_min(t1, t0);
    LOBE_LET t6 = t5 * t3;
    LOBE_LET t7 = p[6] * t0 + t6;
    LOBE_LET t8 = t7 * t6;
    LOBE_LET t9 = t8 * t5;
    LOBE_LET t10 = t3 * p[7] + t2;
    LOBE_LET t11 = v * r + p[8];
    LOBE_LET t12 = t4 * t11 + p[9];
    LOBE_LET t13 = t9 * t0 + t12;
    LOBE_LET t14 = t10 * t13;
    LOBE_LET t15 = p[10] * t8 + p[11];
    LOBE_LET t16 = t15 * t14 + p[12];
    LOBE_LET e = lobe_saturate(t16);
    LOBE_LET b = lobe_saturate(t9);
    return lobe_dfg_of_bias(e, b);
}

LOBE_FN lobe_dfg lobe_front_corr_25(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET t0 = p[0] - v;
    LOBE_LET t1 = r * p[1] + p[2];
    LOBE_LET t2 = v * p[3] + t1;
    LOBE_LET t3 = lobe_min(t0, t2);
    LOBE_LET t4 = p[4] * v + t1;
    LOBE_LET t5 = t3 * t3;
    LOBE_LET t6 = t4 * t5 + p[5];
    LOBE_LET t7 = t5 * t5;
    LOBE_LET t8 = t7 * t6;
    LOBE_LET t9 = p[6] * v + r;
    LOBE_LET t10 = p[7] * t7 + v;
    LOBE_LET t11 = r * p[8] + p[9];
    LOBE_LET t12 = p[10] * t8 + p[11];
    LOBE_LET t13 = p[12] * t10 + t3;
    LOBE_LET t14 = t12 * t13 + p[13];
    LOBE_LET t15 = t14 * t9 + p[14];
    LOBE_LET t16 = t15 * p[15] + t11;
    LOBE_LET t17 = t13 * p[16];
    LOBE_LET t18 = p[17] * v + t15;
    LOBE_LET t19 = t18 * t8 + t16;
    LOBE_LET t20 = t19 * t17;
    LOBE_LET t21 = t11 * r + p[18];
    LOBE_LET t22 = p[19] * t19 + t20;
    LOBE_LET t23 = t21 - t22;
    LOBE_LET e = lobe_saturate(t23);
    LOBE_LET b = lobe_saturate(t8);
    return lobe_dfg_of_bias(e, b);
}

LOBE_FN lobe_dfg lobe_front_corr_37(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET a = r * r + LOBE_R(1e-6);
    LOBE_LET w = v + a * ((p[0] + r * p[1]) + v * p[2]);
    LOBE_LET s = v / w;
    LOBE_LET t = LOBE_R(1.0) - s;
    LOBE_LET a2 = a * a;
    LOBE_LET t2 = t * t;
    LOBE_LET q0 = t2 * (p[9] + t * p[6]);
    LOBE_LET q2 = p[3] + t * (p[5] + t * (p[8] + t * (p[10] + t * p[7])));
    LOBE_LET q = q0 + a2 * (q2 + a2 * p[4]);
    LOBE_LET u0 = p[11] + r * (p[18] + r * (p[20] + r * p[12]));
    LOBE_LET u1 = p[16] + r * (p[13] + r * p[14]);
    LOBE_LET u2 = p[15] + r * p[19];
    LOBE_LET u3 = p[21] + r * p[17];
    LOBE_LET u = u0 + t * (u1 + t * (u2 + t * u3));
    LOBE_LET e = lobe_saturate(LOBE_R(1.0) - s * t * q);
    LOBE_LET x = lobe_saturate(LOBE_R(1.0) - w * u);
    return lobe_dfg_of_angle(e, x);
}

LOBE_FN lobe_dfg lobe_front_corr_43(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET a = r * r + LOBE_R(1e-6);
    LOBE_LET w = v + a * p[0];
    LOBE_LET s = v / w;
    LOBE_LET t = LOBE_R(1.0) - s;
    LOBE_LET log_s = lobe_log2(lobe_max(s, LOBE_R(1e-6)));
    LOBE_LET a2 = a * a;
    LOBE_LET a4 = a2 * a2;
    LOBE_LET s2 = s * s;
    LOBE_LET l0 = p[1] + a2 * (p[2] + a * p[3]);
    LOBE_LET l1 = p[4] + a4 * p[5];
    LOBE_LET l2 = a2 * p[6];
    LOBE_LET l = l0 + s * (l1 + s * (l2 + s * (p[7] + s * p[8])));
    LOBE_LET u0 = p[9] + r * (p[10] + r * (p[11] + r * (p[12] + r * p[13])));
    LOBE_LET u1 = p[14] + r * (p[15] + r * (p[16] + r * p[17]));
    LOBE_LET u3 = p[18] + r * p[19];
    LOBE_LET u = u0 + s * (u1 + s2 * (u3 + s2 * p[20]));
    LOBE_LET e = lobe_saturate(LOBE_R(1.0) - s * t * (log_s * l));
    LOBE_LET x = lobe_saturate(LOBE_R(1.0) - w * u);
    return lobe_dfg_of_angle(e, x);
}

LOBE_FN lobe_dfg lobe_front_corr_49(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET a = r * r + LOBE_R(1e-6);
    LOBE_LET w = v + a * (p[0] + a * p[1]);
    LOBE_LET s = v / w;
    LOBE_LET t = LOBE_R(1.0) - s;
    LOBE_LET log_s = lobe_log2(lobe_max(s, LOBE_R(1e-6)));
    LOBE_LET a2 = a * a;
    LOBE_LET r2 = r * r;
    LOBE_LET t2 = t * t;
    LOBE_LET q0 = t2 * (p[7] + t * (p[8] + t * (p[9] + t * p[10])));
    LOBE_LET q3 = p[3] + t * p[5];
    LOBE_LET q4 = p[4] + t * p[6];
    LOBE_LET q = q0 + a * (p[2] + a2 * (q3 + a * q4));
    LOBE_LET l0 = p[11] + a2 * p[12];
    LOBE_LET l = l0 + t * p[13];
    LOBE_LET u0 = p[14] + r * (p[15] + r * (p[16] + r * (p[17] + r * p[18])));
    LOBE_LET u1 = p[19] + r2 * (p[20] + r * p[21]);
    LOBE_LET u2 = p[22] + r * p[23];
    LOBE_LET u3 = p[24] + r * p[25];
    LOBE_LET u = u0 + t * (u1 + t * (u2 + t * (u3 + t * p[26])));
    LOBE_LET e = lobe_saturate(LOBE_R(1.0) - s * t * (q + log_s * l));
    LOBE_LET x = lobe_saturate(LOBE_R(1.0) - w * u);
    return lobe_dfg_of_angle(e, x);
}

#endif
