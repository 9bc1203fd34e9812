/* Kernels to try the emitter on, of the form that the split sum has: one self-similar variable s, polynomials in
 * (s, a) and (s, r). Coefficients are plain least squares to the truth, so the large ones alternate in sign and
 * cancel: Horner's steps reach hundreds where the results stay in [0, 1]. Harsher than what ships. */
#ifndef LOBE_TEST_EMIT_KERNELS_H
#define LOBE_TEST_EMIT_KERNELS_H
#include "../../models/dfg.h"

#define TRY_MEDIUM_C0 LOBE_R(0.961)
#define TRY_MEDIUM_C1 LOBE_R(0.00153523369)
#define TRY_MEDIUM_C2 LOBE_R(0.428889532)
#define TRY_MEDIUM_C3 LOBE_R(6.5755791)
#define TRY_MEDIUM_C4 LOBE_R(-3.43258959)
#define TRY_MEDIUM_C5 LOBE_R(2.71241569)
#define TRY_MEDIUM_C6 LOBE_R(-13.5230246)
#define TRY_MEDIUM_C7 LOBE_R(3.27248728)
#define TRY_MEDIUM_C8 LOBE_R(-2.07703811)
#define TRY_MEDIUM_C9 LOBE_R(24.9927294)
#define TRY_MEDIUM_C10 LOBE_R(0.165889196)
#define TRY_MEDIUM_C11 LOBE_R(2.93899978)
#define TRY_MEDIUM_C12 LOBE_R(-4.16670824)
#define TRY_MEDIUM_C13 LOBE_R(1.69457461)
#define TRY_MEDIUM_C14 LOBE_R(-3.25148036)
#define TRY_MEDIUM_C15 LOBE_R(3.0630473)
#define TRY_MEDIUM_C16 LOBE_R(1.33731588)
#define TRY_HIGH_C0 LOBE_R(0.632)
#define TRY_HIGH_C1 LOBE_R(2.07929221)
#define TRY_HIGH_C2 LOBE_R(-8.2968538)
#define TRY_HIGH_C3 LOBE_R(21.2556801)
#define TRY_HIGH_C4 LOBE_R(-26.1908381)
#define TRY_HIGH_C5 LOBE_R(21.9054078)
#define TRY_HIGH_C6 LOBE_R(-5.99159613)
#define TRY_HIGH_C7 LOBE_R(-1.53118525)
#define TRY_HIGH_C8 LOBE_R(-2.14696361)
#define TRY_HIGH_C9 LOBE_R(1.99780518)
#define TRY_HIGH_C10 LOBE_R(-41.5311413)
#define TRY_HIGH_C11 LOBE_R(136.579543)
#define TRY_HIGH_C12 LOBE_R(-222.85156)
#define TRY_HIGH_C13 LOBE_R(244.864324)
#define TRY_HIGH_C14 LOBE_R(-226.207161)
#define TRY_HIGH_C15 LOBE_R(88.634349)
#define TRY_HIGH_C16 LOBE_R(22.0133611)
#define TRY_HIGH_C17 LOBE_R(-17.8175782)
#define TRY_HIGH_C18 LOBE_R(386.206283)
#define TRY_HIGH_C19 LOBE_R(-970.205883)
#define TRY_HIGH_C20 LOBE_R(1099.428)
#define TRY_HIGH_C21 LOBE_R(-698.270909)
#define TRY_HIGH_C22 LOBE_R(598.762685)
#define TRY_HIGH_C23 LOBE_R(-341.151187)
#define TRY_HIGH_C24 LOBE_R(62.0188221)
#define TRY_HIGH_C25 LOBE_R(-1956.92607)
#define TRY_HIGH_C26 LOBE_R(3878.09287)
#define TRY_HIGH_C27 LOBE_R(-3084.85275)
#define TRY_HIGH_C28 LOBE_R(663.707406)
#define TRY_HIGH_C29 LOBE_R(-242.209686)
#define TRY_HIGH_C30 LOBE_R(138.55802)
#define TRY_HIGH_C31 LOBE_R(5953.14315)
#define TRY_HIGH_C32 LOBE_R(-9240.29681)
#define TRY_HIGH_C33 LOBE_R(5564.92368)
#define TRY_HIGH_C34 LOBE_R(-328.911525)
#define TRY_HIGH_C35 LOBE_R(-143.07567)
#define TRY_HIGH_C36 LOBE_R(-11046.8044)
#define TRY_HIGH_C37 LOBE_R(12854.477)
#define TRY_HIGH_C38 LOBE_R(-5649.42766)
#define TRY_HIGH_C39 LOBE_R(212.443578)
#define TRY_HIGH_C40 LOBE_R(12219.4526)
#define TRY_HIGH_C41 LOBE_R(-9564.92859)
#define TRY_HIGH_C42 LOBE_R(2406.65227)
#define TRY_HIGH_C43 LOBE_R(-7359.36135)
#define TRY_HIGH_C44 LOBE_R(2930.44326)
#define TRY_HIGH_C45 LOBE_R(1845.24593)
#define TRY_HIGH_C46 LOBE_R(7.58570195)
#define TRY_HIGH_C47 LOBE_R(-30.5281837)
#define TRY_HIGH_C48 LOBE_R(74.3652724)
#define TRY_HIGH_C49 LOBE_R(-113.819863)
#define TRY_HIGH_C50 LOBE_R(104.413094)
#define TRY_HIGH_C51 LOBE_R(-52.2696274)
#define TRY_HIGH_C52 LOBE_R(10.9763846)
#define TRY_HIGH_C53 LOBE_R(-9.71919431)
#define TRY_HIGH_C54 LOBE_R(45.6314013)
#define TRY_HIGH_C55 LOBE_R(-100.057508)
#define TRY_HIGH_C56 LOBE_R(119.566266)
#define TRY_HIGH_C57 LOBE_R(-74.1303352)
#define TRY_HIGH_C58 LOBE_R(18.5919586)
#define TRY_HIGH_C59 LOBE_R(0.65548475)
#define TRY_HIGH_C60 LOBE_R(-24.6961176)
#define TRY_HIGH_C61 LOBE_R(45.1368583)
#define TRY_HIGH_C62 LOBE_R(-33.3949909)
#define TRY_HIGH_C63 LOBE_R(9.89154004)
#define TRY_HIGH_C64 LOBE_R(9.11597099)
#define TRY_HIGH_C65 LOBE_R(26.4261241)
#define TRY_HIGH_C66 LOBE_R(-32.6472889)
#define TRY_HIGH_C67 LOBE_R(7.8940949)
#define TRY_HIGH_C68 LOBE_R(-23.6229406)
#define TRY_HIGH_C69 LOBE_R(-16.6208568)
#define TRY_HIGH_C70 LOBE_R(15.772594)
#define TRY_HIGH_C71 LOBE_R(25.6059049)
#define TRY_HIGH_C72 LOBE_R(-0.312397545)
#define TRY_HIGH_C73 LOBE_R(-8.62006797)

LOBE_FN lobe_dfg lobe_try_medium(lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET a = r * r;
    LOBE_LET w = lobe_max(v + TRY_MEDIUM_C0 * a, LOBE_R(1e-6));
    LOBE_LET s = v / w;
    LOBE_LET t = LOBE_R(1.0) - s;
    LOBE_LET q = ((TRY_MEDIUM_C1 + a * (TRY_MEDIUM_C2 + a * (TRY_MEDIUM_C3 + a * TRY_MEDIUM_C4))) +
                  s * ((TRY_MEDIUM_C5 + a * (TRY_MEDIUM_C6 + a * TRY_MEDIUM_C7)) +
                       s * ((TRY_MEDIUM_C8 + a * TRY_MEDIUM_C9) + s * TRY_MEDIUM_C10)));
    LOBE_LET p = ((TRY_MEDIUM_C11 + r * (TRY_MEDIUM_C12 + r * TRY_MEDIUM_C13)) +
                  s * ((TRY_MEDIUM_C14 + r * TRY_MEDIUM_C15) + s * TRY_MEDIUM_C16));
    LOBE_LET e = lobe_saturate(LOBE_R(1.0) - s * (t * t) * q);
    LOBE_LET x = lobe_saturate(LOBE_R(1.0) - w * p);
    LOBE_LET x2 = x * x;
    lobe_dfg d;
    d.bias = e * (x2 * x2 * x);
    d.scale = e - d.bias;
    return d;
}

LOBE_FN lobe_dfg lobe_try_high(lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET a = r * r;
    LOBE_LET w = lobe_max(v + TRY_HIGH_C0 * a, LOBE_R(1e-6));
    LOBE_LET s = v / w;
    LOBE_LET t = LOBE_R(1.0) - s;
    LOBE_LET q =
        ((TRY_HIGH_C1 +
          a * (TRY_HIGH_C2 +
               a * (TRY_HIGH_C3 +
                    a * (TRY_HIGH_C4 +
                         a * (TRY_HIGH_C5 +
                              a * (TRY_HIGH_C6 + a * (TRY_HIGH_C7 + a * (TRY_HIGH_C8 + a * TRY_HIGH_C9)))))))) +
         s * ((TRY_HIGH_C10 +
               a * (TRY_HIGH_C11 +
                    a * (TRY_HIGH_C12 +
                         a * (TRY_HIGH_C13 +
                              a * (TRY_HIGH_C14 + a * (TRY_HIGH_C15 + a * (TRY_HIGH_C16 + a * TRY_HIGH_C17))))))) +
              s * ((TRY_HIGH_C18 +
                    a * (TRY_HIGH_C19 +
                         a * (TRY_HIGH_C20 +
                              a * (TRY_HIGH_C21 + a * (TRY_HIGH_C22 + a * (TRY_HIGH_C23 + a * TRY_HIGH_C24)))))) +
                   s * ((TRY_HIGH_C25 +
                         a * (TRY_HIGH_C26 +
                              a * (TRY_HIGH_C27 + a * (TRY_HIGH_C28 + a * (TRY_HIGH_C29 + a * TRY_HIGH_C30))))) +
                        s * ((TRY_HIGH_C31 +
                              a * (TRY_HIGH_C32 + a * (TRY_HIGH_C33 + a * (TRY_HIGH_C34 + a * TRY_HIGH_C35)))) +
                             s * ((TRY_HIGH_C36 + a * (TRY_HIGH_C37 + a * (TRY_HIGH_C38 + a * TRY_HIGH_C39))) +
                                  s * ((TRY_HIGH_C40 + a * (TRY_HIGH_C41 + a * TRY_HIGH_C42)) +
                                       s * ((TRY_HIGH_C43 + a * TRY_HIGH_C44) + s * TRY_HIGH_C45))))))));
    LOBE_LET p =
        ((TRY_HIGH_C46 +
          r * (TRY_HIGH_C47 +
               r * (TRY_HIGH_C48 + r * (TRY_HIGH_C49 + r * (TRY_HIGH_C50 + r * (TRY_HIGH_C51 + r * TRY_HIGH_C52)))))) +
         s * ((TRY_HIGH_C53 +
               r * (TRY_HIGH_C54 + r * (TRY_HIGH_C55 + r * (TRY_HIGH_C56 + r * (TRY_HIGH_C57 + r * TRY_HIGH_C58))))) +
              s * ((TRY_HIGH_C59 + r * (TRY_HIGH_C60 + r * (TRY_HIGH_C61 + r * (TRY_HIGH_C62 + r * TRY_HIGH_C63)))) +
                   s * ((TRY_HIGH_C64 + r * (TRY_HIGH_C65 + r * (TRY_HIGH_C66 + r * TRY_HIGH_C67))) +
                        s * ((TRY_HIGH_C68 + r * (TRY_HIGH_C69 + r * TRY_HIGH_C70)) +
                             s * ((TRY_HIGH_C71 + r * TRY_HIGH_C72) + s * TRY_HIGH_C73))))));
    LOBE_LET e = lobe_saturate(LOBE_R(1.0) - s * (t * t) * q);
    LOBE_LET x = lobe_saturate(LOBE_R(1.0) - w * p);
    LOBE_LET x2 = x * x;
    lobe_dfg d;
    d.bias = e * (x2 * x2 * x);
    d.scale = e - d.bias;
    return d;
}

#define TRY_INVERSE_C0 LOBE_R(0.9)
#define TRY_INVERSE_C1 LOBE_R(0.674183425)
#define TRY_INVERSE_C2 LOBE_R(-2.50155193)
#define TRY_INVERSE_C3 LOBE_R(9.19906278)
#define TRY_INVERSE_C4 LOBE_R(0.156334409)
#define TRY_INVERSE_C5 LOBE_R(-1.38859592)
#define TRY_INVERSE_C6 LOBE_R(8.77028246)
#define TRY_INVERSE_C7 LOBE_R(-1.56593165)
#define TRY_INVERSE_C8 LOBE_R(11.6058148)
#define TRY_INVERSE_C9 LOBE_R(-15.5628422)
#define TRY_INVERSE_C10 LOBE_R(-0.691991959)
#define TRY_INVERSE_C11 LOBE_R(9.63070626)
#define TRY_INVERSE_C12 LOBE_R(-30.0068277)
#define TRY_INVERSE_C13 LOBE_R(1.22719113)
#define TRY_INVERSE_C14 LOBE_R(-9.83020621)
#define TRY_INVERSE_C15 LOBE_R(-5.69663459)
#define TRY_INVERSE_C16 LOBE_R(0.318453084)
#define TRY_INVERSE_C17 LOBE_R(-8.20689905)
#define TRY_INVERSE_C18 LOBE_R(5.26957438)

/* 1/E is the polynomial here: a reciprocal at the end, a variable 2s - 1, and a guard of no size in the denominator. */
LOBE_FN lobe_real lobe_try_inverse(lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET a = r * r + LOBE_R(1e-20);
    LOBE_LET w = TRY_INVERSE_C0 * a + v;
    LOBE_LET s = v / w;
    LOBE_LET t = s - s * s;
    LOBE_LET u = LOBE_R(2.0) * s - LOBE_R(1.0);
    LOBE_LET q = ((TRY_INVERSE_C1 + a * (TRY_INVERSE_C2 + a * TRY_INVERSE_C3)) +
                  u * ((TRY_INVERSE_C4 + a * (TRY_INVERSE_C5 + a * TRY_INVERSE_C6)) +
                       u * ((TRY_INVERSE_C7 + a * (TRY_INVERSE_C8 + a * TRY_INVERSE_C9)) +
                            u * ((TRY_INVERSE_C10 + a * (TRY_INVERSE_C11 + a * TRY_INVERSE_C12)) +
                                 u * ((TRY_INVERSE_C13 + a * (TRY_INVERSE_C14 + a * TRY_INVERSE_C15)) +
                                      u * (TRY_INVERSE_C16 + a * (TRY_INVERSE_C17 + a * TRY_INVERSE_C18)))))));
    LOBE_LET f = LOBE_R(1.0) + t * q;
    LOBE_LET e = LOBE_R(1.0) / f;
    return lobe_saturate(e);
}

#endif
