#include "nelder_mead.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* In units of scale, so that a parameter in millionths counts like one in units. */
static const double flat = 1e-6; /* an edge with a smaller part outside the span of the others is degenerate */
static const double tiny = 1e-13;

/* Removes from v what lies in the span of the count orthonormal rows of basis; returns the length of the rest. */
static double orthogonalise(const double *basis, size_t count, size_t n, double *v)
{
    double length = 0.0;
    for (int pass = 0; pass < 2; pass++) { /* twice is enough (Kahan) */
        for (size_t i = 0; i < count; i++) {
            double dot = 0.0;
            for (size_t k = 0; k < n; k++)
                dot += basis[i * n + k] * v[k];
            for (size_t k = 0; k < n; k++)
                v[k] -= dot * basis[i * n + k];
        }
    }
    for (size_t k = 0; k < n; k++)
        length += v[k] * v[k];
    return sqrt(length);
}

static size_t freest_axis(const double *basis, size_t count, size_t n, double *v)
{
    size_t axis = 0;
    double largest = -1.0;
    for (size_t k = 0; k < n; k++) {
        memset(v, 0, n * sizeof *v);
        v[k] = 1.0;
        const double rest = orthogonalise(basis, count, n, v);
        if (rest > largest) {
            largest = rest;
            axis = k;
        }
    }
    return axis;
}

int lobe_simplex_repair(double *simplex, size_t dim, const double *scale, const double *upper)
{
    const size_t n = dim;
    double *basis = malloc((n * n + n) * sizeof *basis), *v = basis ? basis + n * n : NULL;
    int replaced = 0;
    if (!basis)
        return -1;
    for (size_t i = 0; i < n; i++) {
        double *vertex = simplex + (i + 1) * n, length = 0.0;
        for (size_t k = 0; k < n; k++) {
            v[k] = (vertex[k] - simplex[k]) / scale[k];
            length += v[k] * v[k];
        }
        length = sqrt(length);
        double rest = isfinite(length) && length > tiny ? orthogonalise(basis, i, n, v) : 0.0;
        if (!(rest > flat * length) || rest == 0.0) {
            const size_t axis = freest_axis(basis, i, n, v);
            memcpy(vertex, simplex, n * sizeof *vertex);
            vertex[axis] += upper && vertex[axis] + scale[axis] > upper[axis] ? -scale[axis] : scale[axis];
            memset(v, 0, n * sizeof *v);
            v[axis] = 1.0;
            rest = orthogonalise(basis, i, n, v);
            replaced++;
        }
        for (size_t k = 0; k < n; k++)
            basis[i * n + k] = v[k] / rest;
    }
    free(basis);
    return replaced;
}
