#include "spline.h"

void lobe_spline_prepare(double *coefficient, int n, int stride, int even)
{
    double upper[LOBE_SPLINE_MOST], right[LOBE_SPLINE_MOST];
    int i;
    /* (c[i-1] + 4 c[i] + c[i+1]) / 6 = value i, with c[-1] = c[1] or c[-1] = 2 c[0] - c[1] at the ends */
    upper[0] = even ? 0.5 : 0;
    right[0] = coefficient[stride] * (even ? 1.5 : 1);
    for (i = 1; i < n; i++) {
        const int last = i == n - 1;
        const double value = coefficient[(1 + i) * stride], pivot = last ? 1 : 4 - upper[i - 1];
        upper[i] = last ? 0 : 1 / pivot;
        right[i] = last ? value : (6 * value - right[i - 1]) / pivot;
    }
    coefficient[n * stride] = right[n - 1];
    for (i = n - 2; i >= 0; i--)
        coefficient[(1 + i) * stride] = right[i] - upper[i] * coefficient[(2 + i) * stride];
    coefficient[0] = even ? coefficient[2 * stride] : 2 * coefficient[stride] - coefficient[2 * stride];
    coefficient[(n + 1) * stride] = 2 * coefficient[n * stride] - coefficient[(n - 1) * stride];
}

lobe_spline_weights lobe_spline_at(int n, double x)
{
    lobe_spline_weights w;
    const double in = x > 0 ? (x < n - 1 ? x : n - 1) : 0;
    const int i = in < n - 2 ? (int)in : n - 2;
    const double t = in - i, s = 1 - t;
    w.first = i;
    w.value[0] = s * s * s / 6;
    w.value[1] = (4 - 6 * t * t + 3 * t * t * t) / 6;
    w.value[2] = (4 - 6 * s * s + 3 * s * s * s) / 6;
    w.value[3] = t * t * t / 6;
    w.slope[0] = -s * s / 2;
    w.slope[1] = -2 * t + 1.5 * t * t;
    w.slope[2] = 2 * s - 1.5 * s * s;
    w.slope[3] = t * t / 2;
    return w;
}
