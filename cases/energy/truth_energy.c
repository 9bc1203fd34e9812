#include "truth_energy.h"
#include <math.h>
#include "../split_sum/truth_nodes.h"

/* l times G2 / (4 l v) */
static double lit_visibility(int smith, double a, double l, double v)
{
    const double gl = sqrt(a * a + (1 - a * a) * l * l), gv = sqrt(a * a + (1 - a * a) * v * v), k = 0.5 * a;
    if (smith == 0)
        return 0.5 * l / (l * gv + v * gl);
    if (smith == 1)
        return l / ((l + gl) * (v + gv));
    return 0.25 * l / ((l * (1 - k) + k) * (v * (1 - k) + k));
}

/* D = a^2/pi (1 + c/X)^2 with X = P - 2s cos(phi), c = b (l + v)^2, b = 1 - a^2. With
 * int dphi/X = 2 pi / sqrt(P^2 - 4s^2) and int dphi/X^2 = 2 pi P / (P^2 - 4s^2)^1.5, and P^2 - 4s^2 = (l + v)^2 R:
 *     int D dphi = 2a^2 (1 + 2b(l + v) / sqrt R + b^2 (l + v) P / R^1.5),  R = b^2 d^2 + 4a^2 (1 - lv + a^2 lv) */
static double azimuth(double a, double v, double l, double d)
{
    const double a2 = a * a, b = (1 - a) * (1 + a), sum = l + v;
    const double l1 = (1 - v) - d, lv1 = l1 + l * (1 - v); /* 1 - l, 1 - lv */
    const double s = sqrt(fmax(0, l1) * (1 + l) * (1 - v) * (1 + v));
    const double p = sum * sum * (d * d / ((lv1 + s) * (1 + l * v + s)) + a2) + 2 * s;
    const double r = b * b * d * d + 4 * a2 * (lv1 + a2 * l * v), root = sqrt(r);
    return 2 * a2 * (1 + 2 * b * sum / root + b * b * sum * p / (r * root));
}

double lobe_truth_energy(int smith, double alpha, double n_dot_v, int order, size_t *evaluations)
{
    const double v = n_dot_v, peak = fmin(8 * v, 2 * alpha * sqrt((1 - v) * (1 + v) + alpha * alpha * v * v));
    const double from[3] = {0, v, v}, sign[3] = {1, -1, 1}, span[3] = {0.5 * v, 0.5 * v, 1 - v};
    const double width[3] = {alpha, peak, peak};
    double u[LOBE_TRUTH_NODES_MAX], weight[LOBE_TRUTH_NODES_MAX], e = 0;
    int panel, i;
    *evaluations = 0;
    lobe_truth_nodes(u, weight, order);
    for (panel = 0; panel < 3; panel++) {
        const double length = asinh(span[panel] / width[panel]);
        for (i = 0; i < order && length > 0; i++) {
            const double t = length * u[i], x = sign[panel] * width[panel] * sinh(t);
            const double l = from[panel] + x, d = panel == 0 ? x - v : x;
            e += weight[i] * length * width[panel] * cosh(t) * lit_visibility(smith, alpha, l, v) *
                 azimuth(alpha, v, l, d);
            ++*evaluations;
        }
    }
    return e;
}
