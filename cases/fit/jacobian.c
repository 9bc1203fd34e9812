#include "jacobian.h"

#include <math.h>
#include <string.h>

/* Central differences hold their lower side in chunks of this many parameters, to save memory. */
#define CHUNK 8
static const double forward_step = 0x1p-26; /* square root of the spacing of doubles */
static const double central_step = 0x1p-17; /* its cube root */

static size_t chunk(const lobe_residuals *p) { return p->dim < CHUNK ? p->dim : CHUNK; }

size_t lobe_jacobian_scratch(const lobe_residuals *residuals)
{
    return residuals->dim * residuals->dim + chunk(residuals) * residuals->rows;
}

/* Writes x with parameter k moved by about h; returns the move that was made. */
static double move(const lobe_residuals *p, const double *x, size_t k, double h, double *out)
{
    double to = x[k] + h;
    memcpy(out, x, p->dim * sizeof *x);
    if (p->lower && to > p->upper[k])
        to = p->upper[k];
    if (p->lower && to < p->lower[k])
        to = p->lower[k];
    out[k] = to;
    return to - x[k];
}

static double step_of(double step, double x) { return step * (fabs(x) > 1e-3 ? fabs(x) : x == 0.0 ? 1.0 : 1e-3); }

static void divide(const double *from, size_t rows, double distance, double *column)
{
    for (size_t r = 0; r < rows; r++) {
        const double d = distance != 0.0 ? (column[r] - from[r]) / distance : 0.0;
        column[r] = isfinite(d) ? d : 0.0;
    }
}

static size_t forward(const lobe_residuals *p, const double *x, const double *at_x, double *points, double *out)
{
    const size_t n = p->dim;
    for (size_t k = 0; k < n; k++) {
        const double h = step_of(forward_step, x[k]);
        const bool turn = p->lower && x[k] + h > p->upper[k];
        move(p, x, k, turn ? -h : h, points + k * n);
    }
    p->f(p->ctx, points, n, out);
    for (size_t k = 0; k < n; k++)
        divide(at_x, p->rows, points[k * n + k] - x[k], out + k * p->rows);
    return n;
}

static size_t central(const lobe_residuals *p, const double *x, double *points, double *below, double *out)
{
    const size_t n = p->dim;
    for (size_t k = 0; k < n; k++)
        move(p, x, k, step_of(central_step, x[k]), points + k * n);
    p->f(p->ctx, points, n, out);
    for (size_t first = 0; first < n; first += chunk(p)) {
        const size_t count = n - first < chunk(p) ? n - first : chunk(p);
        double *lower = points + first * n, above[CHUNK];
        for (size_t i = 0; i < count; i++) {
            const size_t k = first + i;
            above[i] = lower[i * n + k];
            move(p, x, k, -step_of(central_step, x[k]), lower + i * n);
        }
        p->f(p->ctx, lower, count, below);
        for (size_t i = 0; i < count; i++)
            divide(below + i * p->rows, p->rows, above[i] - lower[i * n + first + i], out + (first + i) * p->rows);
    }
    return 2 * n;
}

size_t lobe_jacobian(const lobe_residuals *residuals, lobe_difference difference, const double *x, const double *at_x,
                     double *scratch, double *transposed)
{
    const size_t n = residuals->dim;
    if (residuals->jacobian) {
        residuals->jacobian(residuals->ctx, x, transposed);
        for (size_t i = 0; i < n * residuals->rows; i++)
            if (!isfinite(transposed[i]))
                transposed[i] = 0.0;
        return 0;
    }
    if (difference == LOBE_DIFFERENCE_CENTRAL)
        return central(residuals, x, scratch, scratch + n * n, transposed);
    return forward(residuals, x, at_x, scratch, transposed);
}

void lobe_jacobian_rows(const lobe_residuals *residuals, const double *transposed, const double *at_x,
                        const bool *frozen, const double *factor, size_t first, size_t end, double *rows)
{
    const size_t n = residuals->dim, stride = n + 1;
    const double *w = factor ? factor : residuals->weights;
    for (size_t k = 0; k < n; k++) {
        const double *column = transposed + k * residuals->rows;
        for (size_t r = first; r < end; r++)
            rows[(r - first) * stride + k] = frozen[k] ? 0.0 : w ? w[r] * column[r] : column[r];
    }
    for (size_t r = first; r < end; r++)
        rows[(r - first) * stride + n] = w ? w[r] * at_x[r] : at_x[r];
}
