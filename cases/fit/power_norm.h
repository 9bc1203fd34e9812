/* The p-norm of many residuals for large integer p, without overflow and without the library's pow. */
#ifndef LOBE_POWER_NORM_H
#define LOBE_POWER_NORM_H

#include <stddef.h>

typedef struct lobe_power_norm {
    double max;  /* largest |weighted residual|; negative where one is not finite */
    size_t row;  /* the first row that has it */
    double sum;  /* of |e / max|^p: between 1 and the number of rows */
    double norm; /* max * sum^(1/p) */
} lobe_power_norm;

/* x^n for x >= 0, by squaring. */
double lobe_integer_power(double x, size_t n);
/* weights: rows or NULL. factor: NULL, or rows out: sqrt(|e / max|^(p-2)) times the row's weight. */
lobe_power_norm lobe_power_norm_of(const double *residual, const double *weights, size_t rows, size_t p,
                                   double *factor);

#endif
