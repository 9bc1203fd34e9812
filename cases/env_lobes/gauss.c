#include "gauss.h"
#include <math.h>

/* Newton on the Legendre polynomial, from the usual first guess; ascending. */
void lobe_gauss(int n, double *node, double *weight)
{
    const double pi = 3.14159265358979323846;
    int i, turn, k;
    for (i = 0; i < n; i++) {
        double t = -cos(pi * (i + 0.75) / (n + 0.5)), derivative = 1;
        for (turn = 0; turn < 40; turn++) {
            double p0 = 1, p1 = t, step;
            for (k = 2; k <= n; k++) {
                const double p2 = ((2 * k - 1) * t * p1 - (k - 1) * p0) / k;
                p0 = p1;
                p1 = p2;
            }
            derivative = n * (t * p1 - p0) / (t * t - 1);
            step = p1 / derivative;
            t -= step;
            if (fabs(step) < 1e-16)
                break;
        }
        node[i] = (1 + t) / 2;
        weight[i] = 1 / ((1 - t * t) * derivative * derivative);
    }
}
