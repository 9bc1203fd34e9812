#include "normal_equations.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct lobe_normal_equations {
    int n;
    double *matrix, *factor;      /* n * n, their lower halves */
    double *right, *scale, *step; /* half the gradient; the largest diagonal so far */
};

lobe_normal_equations *lobe_normal_new(int unknowns)
{
    const size_t n = (size_t)unknowns;
    lobe_normal_equations *e = calloc(1, sizeof *e);
    double *room = calloc(2 * n * n + 3 * n, sizeof *room);
    if (!e || !room) {
        free(e);
        free(room);
        return NULL;
    }
    e->n = unknowns;
    e->matrix = room;
    e->factor = e->matrix + n * n;
    e->right = e->factor + n * n;
    e->scale = e->right + n;
    e->step = e->scale + n;
    return e;
}

void lobe_normal_free(lobe_normal_equations *e)
{
    if (e)
        free(e->matrix);
    free(e);
}

void lobe_normal_clear(lobe_normal_equations *e)
{
    memset(e->matrix, 0, sizeof *e->matrix * (size_t)e->n * (size_t)e->n);
    memset(e->right, 0, sizeof *e->right * (size_t)e->n);
}

static double dot(const double *a, const double *b, int n)
{
    double part[4] = {0};
    int i = 0;
    for (; i + 4 <= n; i += 4)
        for (int k = 0; k < 4; k++)
            part[k] += a[i + k] * b[i + k];
    for (; i < n; i++)
        part[0] += a[i] * b[i];
    return (part[0] + part[1]) + (part[2] + part[3]);
}

static void add_block(lobe_normal_equations *e, const lobe_normal_column *x, const lobe_normal_column *y,
                      double product)
{
    const lobe_normal_column *low = x->first > y->first ? x : y, *high = low == x ? y : x;
    for (int i = 0; i < low->count; i++) {
        double *row = e->matrix + (low->first + i) * e->n + high->first;
        const double part = product * low->term[i];
        for (int j = 0; j < high->count; j++)
            row[j] += part * high->term[j];
    }
}

void lobe_normal_add(lobe_normal_equations *e, const lobe_normal_column *column, int count, const double *residual,
                     int rows)
{
    for (int a = 0; a < count; a++) {
        const double along = dot(column[a].slope, residual, rows);
        for (int i = 0; i < column[a].count; i++)
            e->right[column[a].first + i] += along * column[a].term[i];
        for (int b = 0; b <= a; b++)
            add_block(e, &column[a], &column[b], dot(column[a].slope, column[b].slope, rows));
    }
}

void lobe_normal_add_square(lobe_normal_equations *e, double factor, double value, const double *slope, int count)
{
    for (int i = 0; i < count; i++) {
        e->right[i] += 0.5 * factor * slope[i];
        for (int j = 0; j <= i; j++)
            e->matrix[i * e->n + j] += 0.25 * factor * slope[i] * slope[j] / value;
    }
}

void lobe_normal_add_ridge(lobe_normal_equations *e, double ridge, const double *x, int held)
{
    for (int i = 0; i < e->n; i++) {
        if (i < held) {
            e->right[i] = 0;
            e->matrix[i * e->n + i] = 1;
        } else {
            e->right[i] += ridge * x[i];
            e->matrix[i * e->n + i] += ridge;
        }
    }
}

/* Cholesky; the lower half. */
static int factorise(double *m, int n)
{
    for (int i = 0; i < n; i++)
        for (int j = 0; j <= i; j++) {
            const double rest = m[i * n + j] - dot(m + i * n, m + j * n, j);
            if (i != j)
                m[i * n + j] = rest / m[j * n + j];
            else if (rest > 0)
                m[i * n + i] = sqrt(rest);
            else
                return 0;
        }
    return 1;
}

double lobe_normal_step(lobe_normal_equations *e, double damping, const double *x, double *to)
{
    const int n = e->n;
    double lost = 0, *s = e->step;
    memcpy(e->factor, e->matrix, sizeof *e->factor * (size_t)n * (size_t)n);
    for (int i = 0; i < n; i++) {
        e->scale[i] = fmax(e->scale[i], e->matrix[i * n + i]);
        e->factor[i * n + i] += damping * (e->scale[i] + 1e-9);
    }
    if (!factorise(e->factor, n))
        return 0;
    for (int i = 0; i < n; i++)
        s[i] = (-e->right[i] - dot(e->factor + i * n, s, i)) / e->factor[i * n + i];
    for (int i = n - 1; i >= 0; i--) {
        for (int j = i + 1; j < n; j++)
            s[i] -= e->factor[j * n + i] * s[j];
        s[i] /= e->factor[i * n + i];
    }
    for (int i = 0; i < n; i++) {
        lost -= s[i] * (2 * e->right[i] + e->matrix[i * n + i] * s[i] + 2 * dot(e->matrix + i * n, s, i));
        to[i] = x[i] + s[i];
    }
    return lost;
}
