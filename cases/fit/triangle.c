#include "triangle.h"

#include <math.h>
#include <string.h>

void lobe_triangle_clear(lobe_triangle *t) { memset(t->r, 0, t->dim * (t->dim + 1) * sizeof *t->r); }

/* dot += column j of rows times columns j + 1 .. n; along the row, so that the compiler vectorises. */
static void gather(const double *restrict rows, size_t count, size_t j, size_t n, double *restrict dot)
{
    const size_t stride = n + 1;
    size_t r = 0;
    for (; r + 4 <= count; r += 4) {
        const double *a = rows + r * stride, *b = a + stride, *c = b + stride, *d = c + stride;
        const double va = a[j], vb = b[j], vc = c[j], vd = d[j];
        for (size_t k = j + 1; k <= n; k++)
            dot[k] += (va * a[k] + vb * b[k]) + (vc * c[k] + vd * d[k]);
    }
    for (; r < count; r++)
        for (size_t k = j + 1; k <= n; k++)
            dot[k] += rows[r * stride + j] * rows[r * stride + k];
}

static void reflect(double *restrict rows, size_t count, size_t j, size_t n, const double *restrict dot)
{
    const size_t stride = n + 1;
    for (size_t r = 0; r < count; r++) {
        double *restrict row = rows + r * stride;
        const double v = row[j];
        for (size_t k = j + 1; k <= n; k++)
            row[k] -= v * dot[k];
    }
}

void lobe_triangle_add(lobe_triangle *t, double *rows, size_t count, double *spare)
{
    const size_t n = t->dim, stride = n + 1;
    for (size_t j = 0; j < n; j++) {
        double *row = t->r + j * stride, sum = 0.0;
        for (size_t r = 0; r < count; r++)
            sum += rows[r * stride + j] * rows[r * stride + j];
        if (sum == 0.0)
            continue;
        const double length = sqrt(row[j] * row[j] + sum), alpha = row[j] > 0.0 ? -length : length;
        const double head = row[j] - alpha, beta = 1.0 / (length * (length + fabs(row[j])));
        for (size_t k = j + 1; k <= n; k++)
            spare[k] = head * row[k];
        gather(rows, count, j, n, spare);
        for (size_t k = j + 1; k <= n; k++) {
            spare[k] *= beta;
            row[k] -= head * spare[k];
        }
        row[j] = alpha;
        reflect(rows, count, j, n, spare);
    }
}

bool lobe_triangle_solve(const lobe_triangle *t, double *x)
{
    const size_t n = t->dim, stride = n + 1;
    for (size_t i = n; i-- > 0;) {
        const double *row = t->r + i * stride;
        double sum = -row[n], column = 0.0;
        for (size_t k = 0; k <= i; k++)
            column += t->r[k * stride + i] * t->r[k * stride + i];
        if (!(row[i] * row[i] > 1e-30 * column))
            return false;
        for (size_t k = i + 1; k < n; k++)
            sum -= row[k] * x[k];
        x[i] = sum / row[i];
    }
    return true;
}

void lobe_triangle_damp(const lobe_triangle *from, const double *diagonal, lobe_triangle *out, double *rows,
                        double *spare)
{
    const size_t n = from->dim, stride = n + 1;
    memcpy(out->r, from->r, n * stride * sizeof *out->r);
    memset(rows, 0, n * stride * sizeof *rows);
    for (size_t k = 0; k < n; k++)
        rows[k * stride + k] = diagonal[k];
    lobe_triangle_add(out, rows, n, spare);
}

void lobe_triangle_column_lengths(const lobe_triangle *t, double *lengths)
{
    const size_t n = t->dim, stride = n + 1;
    for (size_t k = 0; k < n; k++) {
        double sum = 0.0;
        for (size_t i = 0; i <= k; i++)
            sum += t->r[i * stride + k] * t->r[i * stride + k];
        lengths[k] = sqrt(sum);
    }
}

double lobe_triangle_change(const lobe_triangle *t, const double *x)
{
    const size_t n = t->dim, stride = n + 1;
    double change = 0.0;
    for (size_t i = 0; i < n; i++) {
        const double *row = t->r + i * stride;
        double moved = 0.0;
        for (size_t k = i; k < n; k++)
            moved += row[k] * x[k];
        change += moved * (moved + 2.0 * row[n]);
    }
    return change;
}

void lobe_triangle_gradient(const lobe_triangle *t, double *g)
{
    const size_t n = t->dim, stride = n + 1;
    memset(g, 0, n * sizeof *g);
    for (size_t i = 0; i < n; i++)
        for (size_t k = i; k < n; k++)
            g[k] += t->r[i * stride + k] * t->r[i * stride + n];
}
