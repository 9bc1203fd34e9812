#include "kernels.h"
#include <math.h>
#include "gauss.h"

static const double pi = 3.14159265358979323846;

double lobe_prefilter_t_of_alpha(double alpha) { return alpha / sqrt(fmax(1e-12, (1 - alpha) * (1 + alpha))); }

double lobe_prefilter_alpha_of_t(double t) { return t / sqrt(1 + t * t); }

double lobe_prefilter_factor(double t)
{
    const double k = 0.5 / (t * t);
    /* the integral of (1 - x) / (1 + k x)^2 over [0, 1]: 1 / k - ln(1 + k) / k^2, and its series where that cancels */
    const double part = k < 1e-3 ? 0.5 - k / 3 + k * k / 4 : (1 - log1p(k) / k) / k;
    return 1 / (2 * pi * part);
}

double lobe_prefilter_kernel(double t, double c)
{
    const double k = 0.5 / (t * t), w = 1 + k * (1 - c);
    return c > 0 ? lobe_prefilter_factor(t) * c / (w * w) : 0;
}

double lobe_sg_kernel(double sharpness, double c)
{
    return sharpness / (2 * pi * -expm1(-2 * sharpness)) * exp(sharpness * (c - 1));
}

/* Angles by w sinh(x), w the kernel's own width, so that both its peak and the bands' waves are resolved. */
void lobe_prefilter_bands(double t, int bands, double *factor)
{
    enum { NODES = 64, PANELS = 10 };
    double node[NODES], weight[NODES];
    const double w = fmax(t, 1e-3), most = asinh(0.5 * pi / w);
    int i, j, l;
    lobe_gauss(NODES, node, weight);
    for (l = 0; l < bands; l++)
        factor[l] = 0;
    for (i = 0; i < PANELS; i++)
        for (j = 0; j < NODES; j++) {
            const double x = most * (i + node[j]) / PANELS, angle = w * sinh(x), c = cos(angle), half = sin(angle / 2);
            const double bend = 1 + half * half / (t * t); /* 1 + k (1 - c) */
            const double value = 2 * pi * sin(angle) * w * cosh(x) * most / PANELS * weight[j] *
                                 lobe_prefilter_factor(t) * c / (bend * bend);
            double p0 = 1, p1 = c;
            for (l = 0; l < bands; l++) {
                const double p2 = ((2 * l + 3) * c * p1 - (l + 1) * p0) / (l + 2);
                factor[l] += value * p0;
                p0 = p1;
                p1 = p2;
            }
        }
}
