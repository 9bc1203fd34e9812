/* Symmetric positive definite systems whose rows reach only so far from the diagonal. */
#ifndef LOBE_ENV_TABLE_BAND_H
#define LOBE_ENV_TABLE_BAND_H
#include <stddef.h>

/* Row i holds columns i - reach .. i; what lies before column 0 is not looked at. */
typedef struct lobe_band {
    int size, reach;
    double *entry; /* [size][reach + 1] */
} lobe_band;

/* The address at which row i would have column 0: row[j] is its column j. */
static inline double *lobe_band_row(const lobe_band *b, int i)
{
    return b->entry + (size_t)i * (size_t)(b->reach + 1) + (size_t)b->reach - (size_t)i;
}

/* Cholesky. x: right side in, solution out. The matrix becomes its factor. */
void lobe_band_solve(const lobe_band *matrix, double *x);

/* The sum of products, in an order that does not depend on the machine. */
double lobe_band_dot(const double *a, const double *b, int n);

#endif
