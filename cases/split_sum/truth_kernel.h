/* Ground truth of the split sum, integrated over the light direction. One text for C and OpenCL C, in double.
 *
 * With l = NdotL, v = NdotV, phi the azimuth from the mirror direction and q = 1 + L.V = 2 VdotH^2,
 *     scale, bias = int_0^1 l V(l, v) int_0^2pi D(l, phi) {1 - F, F} dphi dl,   F = (1 - VdotH)^5.
 * V = G2 / (4 l v) has no azimuth in it for any Smith form, so the domain is a rectangle without a horizon inside.
 * README.md derives the forms below; none of them subtracts nearly equal numbers.
 *
 * Only + - * / and sqrt are used, all correctly rounded in C and in OpenCL C: the two give the same bits. */
#ifndef LOBE_TRUTH_KERNEL_H
#define LOBE_TRUTH_KERNEL_H
#include "../../core/dialect.h"

#if defined(LOBE_OPENCL)
#define LOBE_NODES __global const lobe_real *
#else
#include <math.h>
#define LOBE_NODES const lobe_real *
#endif

#define LOBE_TRUTH_CORRELATED 0 /* height-correlated Smith */
#define LOBE_TRUTH_SEPARABLE 1  /* G1(l) G1(v) */
#define LOBE_TRUTH_KIBL 2       /* Schlick-Smith, G1(x) = x / (x (1 - k) + k), k = alpha / 2 */

LOBE_STRUCT(lobe_truth_sum)
{
    lobe_real scale;
    lobe_real bias;
};

/* Once an evaluation of the integrand; a test counts them. */
#if !defined(LOBE_TRUTH_EVALUATED)
#define LOBE_TRUTH_EVALUATED
#endif

/* x = width sinh t maps u in [0, 1] to [0, span]: it moves a pole at distance width, where the lobe begins to fall,
 * to t = i pi/2. exp(-t) = y^8 with y = 1 - slope u puts most nodes before the tail, which falls like exp(-2t); plain
 * sinh wastes half of them there once the lobe is narrow. All of it needs no exponential. */
LOBE_STRUCT(lobe_truth_map)
{
    lobe_real width;
    lobe_real slope;
};

LOBE_FN lobe_truth_map lobe_truth_map_over(lobe_real width, lobe_real span)
{
    LOBE_LET s = span / width;
    LOBE_LET y8 = 1.0 / (s + sqrt(1.0 + s * s));
    LOBE_LET slope = 1.0 - sqrt(sqrt(sqrt(y8)));
    lobe_truth_map map;
    map.width = width;
    map.slope = slope;
    return map;
}

/* width sinh t = width (y^-8 - y^8) / 2, with 1 - y^16 as a product so that a small x keeps its digits */
LOBE_FN lobe_real lobe_truth_map_x(lobe_truth_map map, lobe_real u)
{
    LOBE_LET d = map.slope * u;
    LOBE_LET y = 1.0 - d;
    LOBE_LET y2 = y * y;
    LOBE_LET y4 = y2 * y2;
    LOBE_LET y8 = y4 * y4;
    LOBE_LET x = 0.5 * map.width * (d * (2.0 - d) * (1.0 + y2) * (1.0 + y4) * (1.0 + y8)) / y8;
    return x;
}

/* dx / du */
LOBE_FN lobe_real lobe_truth_map_dx(lobe_truth_map map, lobe_real u)
{
    LOBE_LET y = 1.0 - map.slope * u;
    LOBE_LET y2 = y * y;
    LOBE_LET y4 = y2 * y2;
    LOBE_LET y8 = y4 * y4;
    LOBE_LET dx = 4.0 * map.slope * map.width * (1.0 + y8 * y8) / (y8 * y);
    return dx;
}

/* sin(x)^2, x in [0, pi/2]; the series of sin x up to x^21 is exact to 1e-18 */
LOBE_FN lobe_real lobe_truth_sin2(lobe_real x)
{
    LOBE_LET z = x * x;
    LOBE_LET s21 = 1.0 / 51090942171709440000.0;
    LOBE_LET s19 = s21 * z - 1.0 / 121645100408832000.0;
    LOBE_LET s17 = s19 * z + 1.0 / 355687428096000.0;
    LOBE_LET s15 = s17 * z - 1.0 / 1307674368000.0;
    LOBE_LET s13 = s15 * z + 1.0 / 6227020800.0;
    LOBE_LET s11 = s13 * z - 1.0 / 39916800.0;
    LOBE_LET s9 = s11 * z + 1.0 / 362880.0;
    LOBE_LET s7 = s9 * z - 1.0 / 5040.0;
    LOBE_LET s5 = s7 * z + 1.0 / 120.0;
    LOBE_LET s3 = s5 * z - 1.0 / 6.0;
    LOBE_LET s = x + x * z * s3;
    LOBE_LET squared = s * s;
    return squared;
}

/* G2 / (4 l v) */
LOBE_FN lobe_real lobe_truth_visibility(int smith, lobe_real a, lobe_real l, lobe_real v)
{
    LOBE_LET a2 = a * a;
    LOBE_LET b = (1.0 - a) * (1.0 + a);
    LOBE_LET gv = sqrt(a2 + b * v * v);
    LOBE_LET gl = sqrt(a2 + b * l * l);
    LOBE_LET k = 0.5 * a;
    LOBE_LET correlated = 0.5 / (l * gv + v * gl);
    LOBE_LET separable = 1.0 / ((v + gv) * (l + gl));
    LOBE_LET kibl = 0.25 / ((v * (1.0 - k) + k) * (l * (1.0 - k) + k));
    return smith == LOBE_TRUTH_CORRELATED ? correlated : smith == LOBE_TRUTH_SEPARABLE ? separable : kibl;
}

/* The azimuth integral at one l. d = l - v comes from the map, not by subtraction. */
LOBE_FN lobe_truth_sum lobe_truth_azimuth(lobe_real a, lobe_real v, lobe_real l, lobe_real d, LOBE_NODES u,
                                          LOBE_NODES weight, int n)
{
    LOBE_LET pi = 3.14159265358979323846;
    LOBE_LET sum2 = (l + v) * (l + v);
    /* 1 - l and 1 - lv, which lose their digits near v = 1 when subtracted as they stand */
    LOBE_LET l1 = (1.0 - v) - d;
    LOBE_LET lv1 = l1 + l * (1.0 - v);
    LOBE_LET s = sqrt(l1 * (1.0 + l) * ((1.0 - v) * (1.0 + v)));
    LOBE_LET up = 1.0 + l * v + s;
    LOBE_LET q0 = sum2 / up;
    LOBE_LET m0 = sum2 * (d * d / ((lv1 + s) * up) + a * a);
    /* 2q - (1 - a^2)(l + v)^2 = m0 + 4 s sin^2(phi/2) is zero at phi = 2i asinh sqrt(m0 / 4s), the pole of D.
     * A width within a few percent of it is as good; beyond 3 the pole is too far to matter. */
    LOBE_LET width = m0 < 18.0 * s ? sqrt(m0 / (s + m0 * (1.0 / 12.0))) : 3.0;
    lobe_truth_map map = lobe_truth_map_over(width, pi);
    lobe_real scale = 0.0;
    lobe_real bias = 0.0;
    lobe_truth_sum out;
    int i;
    for (i = 0; i < n; i++) {
        LOBE_LET y = 2.0 * s * lobe_truth_sin2(0.5 * lobe_truth_map_x(map, u[i]));
        LOBE_LET q = q0 + y;
        LOBE_LET ratio = q / (m0 + 2.0 * y);
        LOBE_LET density = ratio * ratio * (lobe_truth_map_dx(map, u[i]) * weight[i]);
        LOBE_LET h = sqrt(0.5 * q);
        LOBE_LET f = 1.0 - h;
        LOBE_LET f2 = f * f;
        /* 1 - f^5 as a sum of positive terms, so that scale keeps its digits where h is small */
        scale = scale + density * (h * (1.0 + f + f2 * (1.0 + f + f2)));
        bias = bias + density * (f2 * f2 * f);
        LOBE_TRUTH_EVALUATED;
    }
    /* D = 4 a^2 / pi ratio^2, and both halves of the azimuth */
    out.scale = 8.0 / pi * (a * a) * scale;
    out.bias = 8.0 / pi * (a * a) * bias;
    return out;
}

/* The integral over l = from + sign x, x in [0, span]. */
LOBE_FN lobe_truth_sum lobe_truth_panel(int smith, lobe_real a, lobe_real v, lobe_real from, lobe_real sign,
                                        lobe_real span, lobe_real width, LOBE_NODES u, LOBE_NODES weight, int n)
{
    lobe_truth_map map = lobe_truth_map_over(width, span);
    lobe_truth_sum out;
    int i;
    out.scale = 0.0;
    out.bias = 0.0;
    for (i = 0; i < n; i++) {
        LOBE_LET x = sign * lobe_truth_map_x(map, u[i]);
        LOBE_LET l = from + x;
        LOBE_LET d = from > 0.0 ? x : x - v;
        LOBE_LET k = lobe_truth_map_dx(map, u[i]) * weight[i] * (l * lobe_truth_visibility(smith, a, l, v));
        lobe_truth_sum phi = lobe_truth_azimuth(a, v, l, d, u, weight, n);
        out.scale = out.scale + k * phi.scale;
        out.bias = out.bias + k * phi.bias;
    }
    return out;
}

/* scale and bias at alpha and NdotV in (0, 1], with at most 3 n^2 evaluations of the integrand; u and weight are the
 * n Gauss-Legendre nodes of [0, 1]. The error at n = 28 is in README.md. */
LOBE_FN lobe_truth_sum lobe_truth_split_sum(int smith, lobe_real a, lobe_real v, LOBE_NODES u, LOBE_NODES weight, int n)
{
    /* Width of the peak around l = v, and the distance of the pole that V has at l = -v when the lobe is wide */
    LOBE_LET peak = 2.0 * a * sqrt((1.0 - v) * (1.0 + v) + a * a * (v * v));
    LOBE_LET pole = 8.0 * v;
    LOBE_LET width = peak < pole ? peak : pole;
    LOBE_LET half_v = 0.5 * v;
    lobe_truth_sum low = lobe_truth_panel(smith, a, v, 0.0, 1.0, half_v, a, u, weight, n);
    lobe_truth_sum below = lobe_truth_panel(smith, a, v, v, -1.0, half_v, width, u, weight, n);
    lobe_truth_sum out;
    out.scale = low.scale + below.scale;
    out.bias = low.bias + below.bias;
    if (v < 1.0) {
        lobe_truth_sum above = lobe_truth_panel(smith, a, v, v, 1.0, 1.0 - v, width, u, weight, n);
        out.scale = out.scale + above.scale;
        out.bias = out.bias + above.bias;
    }
    return out;
}

#endif
