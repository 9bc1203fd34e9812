#include "trust_region.h"

#include <math.h>
#include <string.h>

size_t lobe_trust_scratch(size_t dim) { return 2 * dim * (dim + 1) + (dim + 1) + 2 * dim; }

static double length_of(const double *scale, const double *step, size_t n)
{
    double sum = 0.0;
    for (size_t k = 0; k < n; k++)
        sum += scale[k] * step[k] * scale[k] * step[k];
    return sqrt(sum);
}

/* |R^-T (scale^2 step / length)|^2: the derivative of the length by the damping, up to sign and length. */
static double slope_of(const lobe_triangle *t, const double *scale, const double *step, double length, double *w)
{
    const size_t n = t->dim, stride = n + 1;
    double sum = 0.0;
    for (size_t k = 0; k < n; k++)
        w[k] = scale[k] * scale[k] * step[k] / length;
    for (size_t i = 0; i < n; i++) {
        w[i] /= t->r[i * stride + i];
        for (size_t k = i + 1; k < n; k++)
            w[k] -= t->r[i * stride + k] * w[i];
        sum += w[i] * w[i];
    }
    return sum;
}

void lobe_trust_step(const lobe_triangle *t, const double *scale, double radius, double *damping, double *scratch,
                     double *step)
{
    const size_t n = t->dim;
    lobe_triangle damped = {n, scratch};
    double *rows = scratch + n * (n + 1), *spare = rows + n * (n + 1), *diagonal = spare + n + 1, *w = diagonal + n;
    double least = 0.0, most = 0.0, excess;

    if (lobe_triangle_solve(t, step)) {
        const double length = length_of(scale, step, n);
        excess = length - radius;
        if (excess <= 0.1 * radius) {
            *damping = 0.0;
            return;
        }
        least = excess / radius / slope_of(t, scale, step, length, w);
    }
    lobe_triangle_gradient(t, w);
    for (size_t k = 0; k < n; k++)
        most += w[k] / scale[k] * (w[k] / scale[k]);
    most = sqrt(most) / radius;
    if (!(most > 0.0)) { /* no gradient */
        memset(step, 0, n * sizeof *step);
        *damping = 0.0;
        return;
    }
    double mu = *damping;
    for (int i = 0; i < 10; i++) {
        if (!(mu > least && mu < most) || mu == 0.0)
            mu = fmax(1e-3 * most, sqrt(least * most));
        for (size_t k = 0; k < n; k++)
            diagonal[k] = sqrt(mu) * scale[k];
        lobe_triangle_damp(t, diagonal, &damped, rows, spare);
        if (!lobe_triangle_solve(&damped, step)) { /* damping lost in rounding: more of it */
            least = mu;
            mu = fmin(most, 1e3 * mu + 1e-300);
            memset(step, 0, n * sizeof *step);
            continue;
        }
        const double length = length_of(scale, step, n);
        excess = length - radius;
        if (fabs(excess) <= 0.1 * radius || (least == 0.0 && excess < 0.0 && mu <= 1e-15 * most))
            break;
        if (excess > 0.0)
            least = mu;
        else
            most = mu;
        const double next = mu + excess / radius / slope_of(&damped, scale, step, length, w);
        if (next == mu || i == 9)
            break;
        mu = next;
    }
    *damping = mu;
}
