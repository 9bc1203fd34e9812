/* Published split-sum formulas, as their sources print them: the stars on the chart. None of them ships.
 * Operations count from roughness; add, mul, fused multiply-add, min, max = 1; exp2, log2, sqrt, reciprocal = 4;
 * pow = 9; saturate is free. Each names the BRDF that it was fitted to. */
#ifndef LOBE_PEERS_SPLIT_SUM_H
#define LOBE_PEERS_SPLIT_SUM_H
#include "../../core/exp2.h"
#include "../../core/power.h"
#include "../../core/sqrt.h"
#include "../../models/dfg.h"

LOBE_FN lobe_dfg peer_dfg(lobe_real scale, lobe_real bias)
{
    lobe_dfg d;
    d.scale = scale;
    d.bias = bias;
    return d;
}

/* Karis 2014, "Physically Based Shading on Mobile". Schlick-Smith with k = alpha / 2. 14 operations.
 * Leaves [0, 1]: bias is -.0024 at roughness 1, n_dot_v 1. */
LOBE_FN lobe_dfg peer_karis(lobe_real r, lobe_real v)
{
    LOBE_LET q0 = LOBE_R(1.0) - r;
    LOBE_LET q1 = LOBE_R(0.0425) - LOBE_R(0.0275) * r;
    LOBE_LET q2 = LOBE_R(1.04) - LOBE_R(0.572) * r;
    LOBE_LET q3 = LOBE_R(0.022) * r - LOBE_R(0.04);
    LOBE_LET k = lobe_min(q0 * q0, lobe_exp2(LOBE_R(-9.28) * v)) * q0 + q1;
    LOBE_LET scale = LOBE_R(-1.04) * k + q2;
    LOBE_LET bias = LOBE_R(1.04) * k + q3;
    return peer_dfg(scale, bias);
}

/* Iwanicki and Pesce 2015, "Approximate Models For Physically Based Rendering", symbolic regression. Separable
 * Smith; their roughness is alpha^(1/4), the square root of ours: ports that feed ours are twice as far off. 16. */
LOBE_FN lobe_dfg peer_iwanicki_pesce(lobe_real r, lobe_real v)
{
    LOBE_LET s = lobe_sqrt(r);
    LOBE_LET bias = lobe_exp2(LOBE_R(-7.0) * v - LOBE_R(4.0) * r);
    LOBE_LET knee = lobe_min(s, LOBE_R(0.739) + LOBE_R(0.323) * v) - LOBE_R(0.434);
    LOBE_LET scale = LOBE_R(1.0) - bias - r * lobe_max(bias, knee);
    return peer_dfg(scale, bias);
}

/* Lazarov 2013 as refitted by Narkowicz 2014. Separable Smith; gloss is 1 - sqrt(roughness): his prose says
 * (1 - roughness)^4, his listing alpha = (1 - gloss)^4, and only the listing fits. 17 from gloss. */
LOBE_FN lobe_dfg peer_lazarov(lobe_real r, lobe_real v)
{
    LOBE_LET g = LOBE_R(1.0) - lobe_sqrt(r);
    LOBE_LET t0 = LOBE_R(0.5745) * g + LOBE_R(0.5753);
    LOBE_LET t1 = LOBE_R(1.548) * g - LOBE_R(0.2511);
    LOBE_LET t2 = LOBE_R(-0.02397) * g - LOBE_R(0.02066);
    LOBE_LET t3 = LOBE_R(1.301) * g + LOBE_R(0.4755);
    LOBE_LET bias = lobe_saturate(t0 * lobe_min(t1, lobe_exp2(LOBE_R(-7.672) * v)) + t2);
    LOBE_LET scale = lobe_saturate(t3) - bias;
    return peer_dfg(scale, bias);
}

/* Narkowicz 2014, two polynomials. Separable Smith; gloss as above. 18 from gloss. */
LOBE_FN lobe_dfg peer_narkowicz(lobe_real r, lobe_real v)
{
    LOBE_LET g = LOBE_R(1.0) - lobe_sqrt(r);
    LOBE_LET b1 = LOBE_R(1.895) * (g * g) - LOBE_R(0.1688) * g;
    LOBE_LET b2 = LOBE_R(0.9903) + v * (LOBE_R(-4.853) + v * (LOBE_R(8.404) - LOBE_R(5.069) * v));
    LOBE_LET bias = lobe_saturate(lobe_min(b1, b2));
    LOBE_LET e = LOBE_R(0.6045) + v * (LOBE_R(-0.5228) + LOBE_R(0.1939) * v) +
                 g * (LOBE_R(1.699) + LOBE_R(1.404) * v + g * (LOBE_R(-3.603) + LOBE_R(2.661) * g));
    LOBE_LET scale = lobe_saturate(e) - bias;
    return peer_dfg(scale, bias);
}

/* Unity HDRP-Lite. Height-correlated Smith. 25 operations. */
LOBE_FN lobe_dfg peer_hdrp_lite(lobe_real r, lobe_real v)
{
    LOBE_LET p = LOBE_R(8.639877405353824) + r * (LOBE_R(-3.1381963259563754) + LOBE_R(1.8836892049272869) * r);
    LOBE_LET q = LOBE_R(0.8701752860749652) + r * (LOBE_R(-2.292256919092684) + LOBE_R(7.033675736966873) * r);
    LOBE_LET s = LOBE_R(1.165252345324149) + r * (LOBE_R(2.285565280188149) + LOBE_R(14.584919434419636) * r);
    LOBE_LET t = LOBE_R(1.9870618038751404) - LOBE_R(1.3549509840179295) * r;
    /* e^x as 2^(x log2 e), the constant folded into p by any compiler that may */
    LOBE_LET grown = lobe_exp2(LOBE_R(1.44269504088896341) * (v * p));
    LOBE_LET bias = t / (s + q * grown);
    LOBE_LET n = lobe_min(v, LOBE_R(0.87));
    LOBE_LET m = LOBE_R(-0.36245015983106055) - LOBE_R(1.233668349677881) * r;
    LOBE_LET e = lobe_saturate(LOBE_R(0.9745876192602081) + r * (n * (m + LOBE_R(0.9008769726821249) * n)));
    LOBE_LET scale = e - bias;
    return peer_dfg(scale, bias);
}

/* Ray Tracing Gems 2019, chapter 32 (hybrid rendering). Separable Smith. 37 operations. */
LOBE_FN lobe_dfg peer_ray_tracing_gems(lobe_real r, lobe_real v)
{
    LOBE_LET a = r * r;
    LOBE_LET a3 = a * a * a;
    LOBE_LET v2 = v * v;
    LOBE_LET v3 = v2 * v;
    LOBE_LET bn = LOBE_R(0.99044) - LOBE_R(1.28514) * v + a * (LOBE_R(1.29678) - LOBE_R(0.755907) * v);
    LOBE_LET bd = LOBE_R(1.0) + LOBE_R(2.92338) * v + LOBE_R(59.4188) * v3 +
                  a * (LOBE_R(20.3225) - LOBE_R(27.0302) * v + LOBE_R(222.592) * v3) +
                  a3 * (LOBE_R(121.563) + LOBE_R(626.13) * v + LOBE_R(316.627) * v3);
    LOBE_LET an = LOBE_R(0.0365463) + LOBE_R(3.32707) * v + a * (LOBE_R(9.0632) - LOBE_R(9.04756) * v);
    LOBE_LET ad = LOBE_R(1.0) + LOBE_R(3.59685) * v2 - LOBE_R(1.36772) * v3 +
                  a * (LOBE_R(9.04401) - LOBE_R(16.3174) * v2 + LOBE_R(9.22949) * v3) +
                  a3 * (LOBE_R(5.56589) + LOBE_R(19.7886) * v2 - LOBE_R(20.2123) * v3);
    LOBE_LET bias = lobe_saturate(bn / bd);
    LOBE_LET scale = lobe_saturate(an / ad);
    return peer_dfg(scale, bias);
}

/* MaterialX, rational quadratic in n_dot_v and alpha. Height-correlated Smith. 43 operations. */
LOBE_FN lobe_dfg peer_materialx(lobe_real r, lobe_real v)
{
    LOBE_LET a = r * r;
    LOBE_LET v2 = v * v;
    LOBE_LET a2 = a * a;
    LOBE_LET va = v * a;
    LOBE_LET v2a = v2 * a;
    LOBE_LET va2 = v * a2;
    LOBE_LET v2a2 = v2 * a2;
    LOBE_LET n0 = LOBE_R(0.1003) - LOBE_R(0.6303) * v + LOBE_R(9.748) * a - LOBE_R(2.038) * va +
                  LOBE_R(29.34) * v2 - LOBE_R(8.245) * a2 - LOBE_R(26.44) * v2a + LOBE_R(19.99) * va2 -
                  LOBE_R(5.448) * v2a2;
    LOBE_LET n1 = LOBE_R(0.9345) - LOBE_R(2.323) * v + LOBE_R(2.229) * a - LOBE_R(3.748) * va + LOBE_R(1.424) * v2 -
                  LOBE_R(0.7684) * a2 + LOBE_R(1.436) * v2a + LOBE_R(0.2913) * va2 + LOBE_R(0.6286) * v2a2;
    LOBE_LET d0 = LOBE_R(1.0) - LOBE_R(1.765) * v + LOBE_R(8.263) * a + LOBE_R(11.53) * va + LOBE_R(28.96) * v2 -
                  LOBE_R(7.507) * a2 - LOBE_R(36.11) * v2a + LOBE_R(15.86) * va2 + LOBE_R(33.37) * v2a2;
    LOBE_LET d1 = LOBE_R(1.0) + LOBE_R(0.2281) * v + LOBE_R(15.94) * a - LOBE_R(55.83) * va + LOBE_R(13.08) * v2 +
                  LOBE_R(41.26) * a2 + LOBE_R(54.9) * v2a + LOBE_R(300.2) * va2 - LOBE_R(285.1) * v2a2;
    LOBE_LET scale = lobe_saturate(n0 / d0);
    LOBE_LET bias = lobe_saturate(n1 / d1);
    return peer_dfg(scale, bias);
}

/* Unreal Engine 5, the path without a table. Height-correlated Smith. 49 operations. */
LOBE_FN lobe_dfg peer_unreal5(lobe_real r, lobe_real v)
{
    LOBE_LET lost = lobe_pow(r, v / r) * (r * v + LOBE_R(0.0266916)) / (LOBE_R(0.466495) + v);
    LOBE_LET e = LOBE_R(1.0) - lobe_saturate(lost);
    LOBE_LET grazing = LOBE_R(2.36651) * lobe_pow(v, LOBE_R(4.7703) * r) + LOBE_R(0.0387332);
    LOBE_LET bias = lobe_pow5(LOBE_R(1.0) - v) * lobe_pow(grazing, r);
    LOBE_LET scale = e - bias;
    return peer_dfg(scale, bias);
}

#endif
