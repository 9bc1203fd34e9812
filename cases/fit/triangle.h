/* The triangular factor of a tall least-squares problem, built from blocks of rows by Householder reflections: never
 * the normal equations, which would square the condition of a polynomial basis. Rows are added in order by one
 * thread, so the bytes are always the same. */
#ifndef LOBE_TRIANGLE_H
#define LOBE_TRIANGLE_H

#include <stdbool.h>
#include <stddef.h>

/* [R | c]: minimising |A x + b| over all rows [A | b] added so far is R x = -c. */
typedef struct lobe_triangle {
    size_t dim;
    double *r; /* dim x (dim + 1), row-major; below the diagonal 0 */
} lobe_triangle;

#define LOBE_TRIANGLE_BLOCK 96 /* rows that are worth adding at once: a block of 100 columns stays in cache */

void lobe_triangle_clear(lobe_triangle *t);
/* rows: count x (dim + 1), [A | b] row-major, destroyed. spare: dim + 1. */
void lobe_triangle_add(lobe_triangle *t, double *rows, size_t count, double *spare);
/* x = -R^-1 c. Returns false, with x undefined, where a pivot is 0 against the size of its column. */
bool lobe_triangle_solve(const lobe_triangle *t, double *x);
/* out = from with the dim rows [diagonal | 0] added. rows: dim x (dim + 1) of scratch. spare: dim + 1. */
void lobe_triangle_damp(const lobe_triangle *from, const double *diagonal, lobe_triangle *out, double *rows,
                        double *spare);
/* Column lengths of R, which are those of A. */
void lobe_triangle_column_lengths(const lobe_triangle *t, double *lengths);
/* |R x + c|^2 - |c|^2: what a step x changes in the sum of squares; negative is better. */
double lobe_triangle_change(const lobe_triangle *t, const double *x);
/* g = R^T c: half the gradient of the sum of squares. */
void lobe_triangle_gradient(const lobe_triangle *t, double *g);

#endif
