/* The front that was explored, separable Smith: a form at the operation count of each published formula.
 * None ships; `lobefit search` fits each from scratch and prints what it reaches. p[i] are its coefficients. */
#ifndef LOBE_FRONT_SEP_H
#define LOBE_FRONT_SEP_H
#include "../../core/log2.h"
#include "../../models/dfg.h"

LOBE_FN lobe_dfg lobe_front_sep_14(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET t0 = p[0] - v;
    LOBE_LET t1 = r * p[1] + p[2];
    LOBE_LET t2 = lobe_min(t0, t1);
    LOBE_LET t3 = t2 * t2;
    LOBE_LET t4 = t3 * t3;
    LOBE_LET t5 = v * p[3] + t1;
    LOBE_LET t6 = p[4] * t5 + p[5];
    LOBE_LET t7 = t5 + p[6];
    LOBE_LET t8 = t4 * t7 + p[7];
    LOBE_LET t9 = p[8] * v + r;
    LOBE_LET t10 = t5 * t4 + t6;
    LOBE_LET t11 = t10 * t9;
    LOBE_LET t12 = p[9] - t11;
    LOBE_LET e = lobe_saturate(t12);
    LOBE_LET b = lobe_saturate(t8);
    return lobe_dfg_of_bias(e, b);
}

LOBE_FN lobe_dfg lobe_front_sep_16(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET t0 = v * p[0] + p[1];
    LOBE_LET t1 = p[2] * r + p[3];
    LOBE_LET t2 = v * p[4] + t1;
    LOBE_LET t3 = lobe_min(t0, t2);
    LOBE_LET t4 = t3 * t3;
    LOBE_LET t5 = t4 * t4;
    LOBE_LET t6 = p[5] * t5 + p[6];
    LOBE_LET t7 = p[7] * t5 + p[8];
    LOBE_LET t8 = t6 * r + p[9];
    LOBE_LET t9 = t6 * v + r;
    LOBE_LET t10 = t8 * t7 + p[10];
    LOBE_LET t11 = p[11] * t9 + t10;
    LOBE_LET t12 = t11 * t9;
    LOBE_LET t13 = p[12] - t12;
    LOBE_LET t14 = lobe_saturate(t13);
    LOBE_LET t15 = p[13] * t14;
    LOBE_LET e = lobe_saturate(t15);
    LOBE_LET b = lobe_saturate(t5);
    return lobe_dfg_of_bias(e, b);
}

LOBE_FN lobe_dfg lobe_front_sep_17(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET t0 = p[0] - v;
    LOBE_LET t1 = r * p[1] + p[2];
    LOBE_LET t2 = v * p[3] + t1;
    LOBE_LET t3 = lobe_min(t0, t2);
    LOBE_LET t4 = t3 * t3;
    LOBE_LET t5 = t4 * t4;
    LOBE_LET t6 = v * p[4] + p[5];
    LOBE_LET t7 = r * p[6] + t6;
    LOBE_LET t8 = p[7] * v + r;
    LOBE_LET t9 = t5 * t5 + t7;
    LOBE_LET t10 = p[8] * t4 + t9;
    LOBE_LET t11 = t10 * t8;
    LOBE_LET t12 = p[9] - t11;
    LOBE_LET t13 = p[10] * t7 + p[11];
    LOBE_LET t14 = t12 * t5 + t5;
    LOBE_LET t15 = t13 * t14;
    LOBE_LET e = lobe_saturate(t12);
    LOBE_LET b = lobe_saturate(t15);
    return lobe_dfg_of_bias(e, b);
}

LOBE_FN lobe_dfg lobe_front_sep_18(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET t0 = v * p[0] + p[1];
    LOBE_LET t1 = p[2] * r + p[3];
    LOBE_LET t2 = p[4] * r + p[5];
    LOBE_LET t3 = v * p[6] + t1;
    LOBE_LET t4 = lobe_min(t0, t3);
    LOBE_LET t5 = t4 * t4;
    LOBE_LET t6 = p[7] * v + t5;
    LOBE_LET t7 = t5 * t5;
    LOBE_LET t8 = p[8] * t7 + t2;
    LOBE_LET t9 = p[9] * t6 + p[10];
    LOBE_LET t10 = t7 * t5 + p[11];
    LOBE_LET t11 = v * t8 + r;
    LOBE_LET t12 = t9 * t10 + p[12];
    LOBE_LET t13 = r * p[13] + t12;
    LOBE_LET t14 = t13 * t11;
    LOBE_LET t15 = p[14] - t14;
    LOBE_LET t16 = lobe_saturate(t15);
    LOBE_LET t17 = p[15] * t16;
    LOBE_LET e = lobe_saturate(t17);
    LOBE_LET b = lobe_saturate(t7);
    return lobe_dfg_of_bias(e, b);
}

LOBE_FN lobe_dfg lobe_front_sep_25(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET t0 = p[0] * v + p[1];
    LOBE_LET t1 = p[2] * t0 + r;
    LOBE_LET t2 = p[3] * r + p[4];
    LOBE_LET t3 = p[5] * t0 + p[6];
    LOBE_LET t4 = p[7] * t1 + p[8];
    LOBE_LET t5 = v * p[9] + t4;
    LOBE_LET t6 = p[10] * t4 + t2;
    LOBE_LET t7 = lobe_min(t0, t4);
    LOBE_LET t8 = t7 * t7;
    LOBE_LET t9 = t4 * t8 + v;
    LOBE_LET t10 = t8 * t8;
    LOBE_LET t11 = t5 * t10;
    LOBE_LET t12 = p[11] * t10 + p[12];
    LOBE_LET t13 = p[13] * t9 + p[14];
    LOBE_LET t14 = t13 * p[15] + p[16];
    LOBE_LET t15 = t12 * v + t1;
    LOBE_LET t16 = p[17] * v + t11;
    LOBE_LET t17 = t14 * t16 + t13;
    LOBE_LET t18 = p[18] * r + t17;
    LOBE_LET t19 = p[19] - t18;
    LOBE_LET t20 = t18 * t15;
    LOBE_LET t21 = t3 - t20;
    LOBE_LET t22 = p[20] * t19 + t11;
    LOBE_LET t23 = lobe_saturate(t21);
    LOBE_LET t24 = t6 * t23;
    LOBE_LET e = lobe_saturate(t24);
    LOBE_LET b = lobe_saturate(t22);
    return lobe_dfg_of_bias(e, b);
}

LOBE_FN lobe_dfg lobe_front_sep_37(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET a = r * r + LOBE_R(1e-6);
    LOBE_LET w = v + a * (p[0] + a * p[1]);
    LOBE_LET s = v / w;
    LOBE_LET t = LOBE_R(1.0) - s;
    LOBE_LET a2 = a * a;
    LOBE_LET a3 = a2 * a;
    LOBE_LET r2 = r * r;
    LOBE_LET q0 = p[2] + a2 * (p[3] + a2 * p[4]);
    LOBE_LET q1 = a3 * (p[5] + a * p[6]);
    LOBE_LET q2 = p[7] + a3 * p[8];
    LOBE_LET q = q0 + t * (q1 + t * (q2 + t * (p[9] + t * p[10])));
    LOBE_LET u0 = p[11] + r2 * p[12];
    LOBE_LET u1 = p[13] + r * (p[14] + r * (p[15] + r * p[16]));
    LOBE_LET u2 = p[17] + r * p[18];
    LOBE_LET u = u0 + t * (u1 + t * (u2 + t * (p[19] + t * p[20])));
    LOBE_LET e = lobe_saturate(LOBE_R(1.0) - t * t * q);
    LOBE_LET x = lobe_saturate(LOBE_R(1.0) - w * u);
    return lobe_dfg_of_angle(e, x);
}

LOBE_FN lobe_dfg lobe_front_sep_43(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET a = r * r + LOBE_R(1e-6);
    LOBE_LET w = v + a * (p[0] + a * p[1]);
    LOBE_LET s = v / w;
    LOBE_LET t = LOBE_R(1.0) - s;
    LOBE_LET s2 = s * s;
    LOBE_LET q0 = p[2] + s * (p[6] + s2 * (p[11] + s * (p[14] + s * p[15])));
    LOBE_LET q1 = s2 * (p[9] + s * p[12]);
    LOBE_LET q3 = p[4] + s * (p[7] + s2 * p[13]);
    LOBE_LET q4 = p[5] + s * (p[8] + s * p[10]);
    LOBE_LET q = q0 + a * (q1 + a * (p[3] + a * (q3 + a * q4)));
    LOBE_LET u0 = p[16] + r * (p[17] + r * (p[18] + r * (p[19] + r * (p[20] + r * p[21]))));
    LOBE_LET u1 = p[22] + r * p[23];
    LOBE_LET u2 = p[24] + r * (p[25] + r * p[26]);
    LOBE_LET u3 = p[27] + r * p[28];
    LOBE_LET u = u0 + s * (u1 + s * (u2 + s * (u3 + s * p[29])));
    LOBE_LET e = lobe_saturate(LOBE_R(1.0) - t * q);
    LOBE_LET x = lobe_saturate(LOBE_R(1.0) - w * u);
    return lobe_dfg_of_angle(e, x);
}

LOBE_FN lobe_dfg lobe_front_sep_49(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET a = r * r + LOBE_R(1e-6);
    LOBE_LET w = v + a * p[0];
    LOBE_LET s = v / w;
    LOBE_LET t = LOBE_R(1.0) - s;
    LOBE_LET s2 = s * s;
    LOBE_LET q0 = p[1] + s2 * (p[12] + s2 * (p[18] + s * (p[20] + s * p[22])));
    LOBE_LET q1 = p[2] + s * (p[8] + s2 * (p[16] + s * (p[19] + s * p[21])));
    LOBE_LET q2 = p[3] + s2 * (p[13] + s * p[17]);
    LOBE_LET q3 = p[4] + s * (p[9] + s * p[14]);
    LOBE_LET q4 = p[5] + s * (p[10] + s * p[15]);
    LOBE_LET q5 = p[6] + s * p[11];
    LOBE_LET q = q0 + a * (q1 + a * (q2 + a * (q3 + a * (q4 + a * (q5 + a * p[7])))));
    LOBE_LET u0 = p[23] + r * (p[24] + r * (p[25] + r * (p[26] + r * (p[27] + r * p[28]))));
    LOBE_LET u1 = p[29] + r * (p[30] + r * (p[31] + r * p[32]));
    LOBE_LET u3 = p[33] + r * p[34];
    LOBE_LET u = u0 + s * (u1 + s2 * (u3 + s * p[35]));
    LOBE_LET e = lobe_saturate(LOBE_R(1.0) - t * q);
    LOBE_LET x = lobe_saturate(LOBE_R(1.0) - w * u);
    return lobe_dfg_of_angle(e, x);
}

#endif
