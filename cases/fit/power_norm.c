#include "power_norm.h"

#include <math.h>

double lobe_integer_power(double x, size_t n)
{
    double y = 1.0;
    for (; n > 0; n >>= 1, x *= x)
        if (n & 1)
            y *= x;
    return y;
}

/* The p-th root of sum >= 1, to the last bit or so. */
static double root(double sum, size_t p)
{
    double low = 1.0, high = sum;
    for (int i = 0; i < 200; i++) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high)
            break;
        if (lobe_integer_power(middle, p) < sum)
            low = middle;
        else
            high = middle;
    }
    return high;
}

lobe_power_norm lobe_power_norm_of(const double *residual, const double *weights, size_t rows, size_t p, double *factor)
{
    lobe_power_norm out = {0.0, 0, 1.0, 0.0};
    for (size_t r = 0; r < rows; r++) {
        const double e = fabs(weights ? weights[r] * residual[r] : residual[r]);
        if (!(e < HUGE_VAL)) {
            out.max = -1.0;
            out.row = r;
            return out;
        }
        if (e > out.max) {
            out.max = e;
            out.row = r;
        }
    }
    double sum = 0.0;
    for (size_t r = 0; r < rows; r++) {
        const double w = weights ? weights[r] : 1.0;
        const double u = out.max > 0.0 ? w * fabs(residual[r]) / out.max : 1.0;
        const double g = lobe_integer_power(u, p - 2);
        sum += g * u * u;
        if (factor)
            factor[r] = w * sqrt(g);
    }
    out.sum = out.max > 0.0 ? sum : 1.0;
    out.norm = out.max * root(out.sum, p);
    return out;
}
