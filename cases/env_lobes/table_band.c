#include "table_band.h"
#include <math.h>

double lobe_band_dot(const double *a, const double *b, int n)
{
    double part[8] = {0};
    int i = 0;
    for (; i + 8 <= n; i += 8)
        for (int k = 0; k < 8; k++)
            part[k] += a[i + k] * b[i + k];
    for (; i < n; i++)
        part[0] += a[i] * b[i];
    return ((part[0] + part[1]) + (part[2] + part[3])) + ((part[4] + part[5]) + (part[6] + part[7]));
}

static int first_column(const lobe_band *b, int i) { return i > b->reach ? i - b->reach : 0; }

static void factorise(const lobe_band *b)
{
    for (int i = 0; i < b->size; i++) {
        const int first = first_column(b, i);
        double *row = lobe_band_row(b, i);
        for (int j = first; j <= i; j++) {
            const double *other = lobe_band_row(b, j);
            const int from = first_column(b, j) > first ? first_column(b, j) : first;
            const double rest = row[j] - lobe_band_dot(row + from, other + from, j - from);
            row[j] = i == j ? sqrt(fmax(rest, 1e-300)) : rest / other[j];
        }
    }
}

void lobe_band_solve(const lobe_band *b, double *x)
{
    factorise(b);
    for (int i = 0; i < b->size; i++) {
        const int first = first_column(b, i);
        const double *row = lobe_band_row(b, i);
        x[i] = (x[i] - lobe_band_dot(row + first, x + first, i - first)) / row[i];
    }
    for (int i = b->size - 1; i >= 0; i--) {
        const double *row = lobe_band_row(b, i);
        x[i] /= row[i];
        for (int j = first_column(b, i); j < i; j++)
            x[j] -= row[j] * x[i];
    }
}
