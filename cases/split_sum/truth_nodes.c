#include "truth_nodes.h"

/* cos(x) to about 1e-6 on [0, pi/2], enough for Newton's method to find each root */
static double rough_cos(double x)
{
    const double z = x * x;
    return 1.0 + z * (-1.0 / 2 + z * (1.0 / 24 + z * (-1.0 / 720 + z * (1.0 / 40320 - z / 3628800))));
}

/* P_n(x) and its derivative, from the recurrence */
static double legendre(int n, double x, double *derivative)
{
    double p0 = 1, p1 = x;
    int k;
    for (k = 2; k <= n; k++) {
        const double p2 = ((2 * k - 1) * x * p1 - (k - 1) * p0) / k;
        p0 = p1;
        p1 = p2;
    }
    *derivative = n * (x * p1 - p0) / (x * x - 1);
    return p1;
}

void lobe_truth_nodes(double *u, double *weight, int n)
{
    int i, k;
    for (i = 0; i < (n + 1) / 2; i++) {
        double x = rough_cos(3.14159265358979323846 * (i + 0.75) / (n + 0.5)), d = 1;
        if (2 * i + 1 == n) {
            x = 0;
        }
        for (k = 0; k < 8; k++) {
            const double p = legendre(n, x, &d);
            x -= p / d;
        }
        legendre(n, x, &d);
        u[n - 1 - i] = 0.5 + 0.5 * x;
        u[i] = 0.5 - 0.5 * x;
        weight[i] = weight[n - 1 - i] = 1 / ((1 - x * x) * d * d);
    }
}
