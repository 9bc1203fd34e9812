/* Windows against ringing, and the exact minimum of nine coefficients over the sphere.
 *
 * On the unit sphere the function is c + b.d + d'Md with M traceless, and its minimum is that of a trust-region
 * problem: with M's eigenvalues e_i and b in their frame it equals the largest value of the concave
 *     g(m) = c + m - sum b_i^2 / (4 (e_i - m)),   m <= the least e_i,
 * which needs neither a start nor samples. */
#include "window.h"
#include "environment.h"
#include <math.h>
#include <string.h>

/* Jacobi rotations: m becomes diagonal, b is turned along. */
static void diagonal(double m[3][3], double b[3])
{
    for (int sweep = 0; sweep < 30; sweep++)
        for (int p = 0; p < 2; p++)
            for (int q = p + 1; q < 3; q++) {
                if (fabs(m[p][q]) < 1e-300)
                    continue;
                const double angle = 0.5 * atan2(2 * m[p][q], m[q][q] - m[p][p]);
                const double c = cos(angle), s = sin(angle);
                for (int k = 0; k < 3; k++) {
                    const double a = m[k][p], d = m[k][q];
                    m[k][p] = c * a - s * d;
                    m[k][q] = s * a + c * d;
                }
                for (int k = 0; k < 3; k++) {
                    const double a = m[p][k], d = m[q][k];
                    m[p][k] = c * a - s * d;
                    m[q][k] = s * a + c * d;
                }
                const double a = b[p], d = b[q];
                b[p] = c * a - s * d;
                b[q] = s * a + c * d;
            }
}

double lobe_sh9_minimum(const double c[9])
{
    const double k1 = sqrt(3 / (4 * LOBE_PI)), k2 = sqrt(15 / (4 * LOBE_PI)), k3 = sqrt(5 / (16 * LOBE_PI));
    double m[3][3], b[3] = {k1 * c[3], k1 * c[1], k1 * c[2]}, least, low, high;
    m[0][0] = -k3 * c[6] + k2 / 2 * c[8];
    m[1][1] = -k3 * c[6] - k2 / 2 * c[8];
    m[2][2] = 2 * k3 * c[6];
    m[0][1] = m[1][0] = k2 / 2 * c[4];
    m[1][2] = m[2][1] = k2 / 2 * c[5];
    m[0][2] = m[2][0] = k2 / 2 * c[7];
    diagonal(m, b);
    least = fmin(m[0][0], fmin(m[1][1], m[2][2]));
    high = least;
    low = least - 0.5 * sqrt(b[0] * b[0] + b[1] * b[1] + b[2] * b[2]) - 1e-30; /* slope >= 0 there */
    for (int turn = 0; turn < 200; turn++) {
        const double mid = (low + high) / 2;
        double slope = 1;
        for (int i = 0; i < 3; i++)
            slope -= b[i] * b[i] / (4 * (m[i][i] - mid) * (m[i][i] - mid));
        if (slope > 0)
            low = mid;
        else
            high = mid;
    }
    double value = c[0] * sqrt(1 / (4 * LOBE_PI)) + low;
    for (int i = 0; i < 3; i++)
        if (b[i] != 0)
            value -= b[i] * b[i] / (4 * (m[i][i] - low));
    return value;
}

static void scale_bands(double c[9], double h1, double h2)
{
    for (int k = 1; k < 9; k++)
        c[k] *= k < 4 ? h1 : h2;
}

void lobe_sh9_window_hanning(double c[9], double width)
{
    scale_bands(c, 0.5 + 0.5 * cos(LOBE_PI / width), 0.5 + 0.5 * cos(2 * LOBE_PI / width));
}

/* The least irradiance of any channel and normal with smoothing k, up to a factor; out holds the smoothed lighting. The
 * cosine lobe keeps its bands in the ratio 1 : 2/3 : 1/4. */
static double least_irradiance(double sh[3][9], double k, double out[3][9])
{
    double least = 1e300, seen[9];
    for (int c = 0; c < 3; c++) {
        memcpy(out[c], sh[c], sizeof seen);
        scale_bands(out[c], 1 / (1 + 4 * k), 1 / (1 + 36 * k));
        memcpy(seen, out[c], sizeof seen);
        scale_bands(seen, 2 / 3.0, 0.25);
        least = fmin(least, lobe_sh9_minimum(seen));
    }
    return least;
}

double lobe_sh9_window_positive(double sh[3][9])
{
    double low = 0, high = 1, out[3][9];
    if (least_irradiance(sh, 0, out) >= 0)
        return 0;
    while (least_irradiance(sh, high, out) < 0)
        if ((high *= 2) > 1e15)
            return -1;
    for (int turn = 0; turn < 60; turn++) {
        const double mid = (low + high) / 2;
        if (least_irradiance(sh, mid, out) < 0)
            low = mid;
        else
            high = mid;
    }
    least_irradiance(sh, high, out);
    memcpy(sh, out, sizeof out);
    return high;
}
