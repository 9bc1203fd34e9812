/* Cubic B-splines through even nodes, for smooth functions that are dear to compute. n values have n + 2 coefficients:
 * one before the first node and one after the last. */
#ifndef LOBE_ENV_SPLINE_H
#define LOBE_ENV_SPLINE_H

enum { LOBE_SPLINE_MOST = 1024 };

/* coefficient[(1 + i) stride] holds value i, 4 <= n <= LOBE_SPLINE_MOST; all n + 2 come out. even: the function is even
 * about its first node; otherwise, and at the last node, its second derivative vanishes there. */
void lobe_spline_prepare(double *coefficient, int n, int stride, int even);

/* The four coefficients first .. first + 3 that x in [0, n - 1] needs, their weights, and those of the derivative by x.
 * Out of range x counts as the end. */
typedef struct lobe_spline_weights {
    int first;
    double value[4], slope[4];
} lobe_spline_weights;

lobe_spline_weights lobe_spline_at(int n, double x);

#endif
