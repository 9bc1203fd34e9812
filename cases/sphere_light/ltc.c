#include "ltc.h"
#include <math.h>
#include "ltc_table.h"

static const double pi = 3.14159265358979323846;

void lobe_ltc_at(double roughness, double n_dot_v, double cell[LOBE_LTC_VALUES])
{
    const int last = LOBE_LTC_SIDE - 1;
    const double x = fmin(fmax((roughness - LOBE_LTC_ROUGHNESS_LO) / (1 - LOBE_LTC_ROUGHNESS_LO), 0), 1) * last;
    const double y = sqrt(fmin(fmax(1 - n_dot_v, 0), 1)) * last;
    const int i = (int)fmin(x, last - 1), j = (int)fmin(y, last - 1);
    const float *c = lobe_ltc_table_cells + LOBE_LTC_VALUES * (i * LOBE_LTC_SIDE + j);
    const float *d = c + LOBE_LTC_VALUES * LOBE_LTC_SIDE;
    const double fx = x - i, fy = y - j;
    int k;
    for (k = 0; k < LOBE_LTC_VALUES; k++)
        cell[k] = (1 - fx) * ((1 - fy) * (double)c[k] + fy * (double)c[k + LOBE_LTC_VALUES]) +
                  fx * ((1 - fy) * (double)d[k] + fy * (double)d[k + LOBE_LTC_VALUES]);
}

/* Jacobi's rotations: a becomes diagonal, the columns of e its eigenvectors. */
static void diagonalise(double a[3][3], double e[3][3])
{
    int sweep, p, q, k;
    for (p = 0; p < 3; p++)
        for (q = 0; q < 3; q++)
            e[p][q] = p == q;
    for (sweep = 0; sweep < 12; sweep++) {
        for (p = 0; p < 2; p++) {
            for (q = p + 1; q < 3; q++) {
                double theta, t, c, s;
                if (a[p][q] == 0)
                    continue;
                theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
                t = (theta < 0 ? -1 : 1) / (fabs(theta) + sqrt(1 + theta * theta));
                c = 1 / sqrt(1 + t * t);
                s = t * c;
                for (k = 0; k < 3; k++) {
                    const double x = a[k][p], y = a[k][q];
                    a[k][p] = c * x - s * y;
                    a[k][q] = s * x + c * y;
                }
                for (k = 0; k < 3; k++) {
                    const double x = a[p][k], y = a[q][k];
                    a[p][k] = c * x - s * y;
                    a[q][k] = s * x + c * y;
                }
                for (k = 0; k < 3; k++) {
                    const double x = e[k][p], y = e[k][q];
                    e[k][p] = c * x - s * y;
                    e[k][q] = s * x + c * y;
                }
            }
        }
    }
}

/* The light after the map: {u : u = axis + x wide + y narrow, x^2 + y^2 <= 1} times any length. */
typedef struct cone {
    double axis[3], wide[3], narrow[3]; /* orthogonal, axis of length 1 */
    double a, b;                        /* lengths of the other two */
} cone;

static cone cone_of(const double cell[LOBE_LTC_VALUES], const double row[5])
{
    const double v2 = row[2], sl = sqrt(fmax(1 - v2 * v2, 0)), s2 = sin(row[4]) * sin(row[4]);
    const double l[3] = {sl * cos(row[3]), sl * sin(row[3]), v2};
    const double det = cell[LOBE_LTC_INV11] * cell[LOBE_LTC_INV33] - cell[LOBE_LTC_INV13] * cell[LOBE_LTC_INV31];
    /* from the cosine to the lobe */
    const double m[3][3] = {{cell[LOBE_LTC_INV33] / det, 0, -cell[LOBE_LTC_INV13] / det},
                            {0, 1, 0},
                            {-cell[LOBE_LTC_INV31] / det, 0, cell[LOBE_LTC_INV11] / det}};
    double q[3][3], e[3][3], ml[3] = {0, 0, 0}, sign;
    int i, j, k, first = 0, second, third;
    cone c;
    for (i = 0; i < 3; i++)
        for (j = 0; j < 3; j++)
            ml[i] += m[j][i] * l[j];
    /* w = m u lies in the light where (w.l)^2 >= cos^2 |w|^2: a quadratic cone of u with one positive eigenvalue */
    for (i = 0; i < 3; i++) {
        for (j = 0; j < 3; j++) {
            q[i][j] = ml[i] * ml[j];
            for (k = 0; k < 3; k++)
                q[i][j] -= fmax(1 - s2, 1e-12) * m[k][i] * m[k][j];
        }
    }
    diagonalise(q, e);
    for (i = 1; i < 3; i++)
        if (q[i][i] > q[first][first])
            first = i;
    second = (first + 1) % 3;
    third = (first + 2) % 3;
    sign = ml[0] * e[0][first] + ml[1] * e[1][first] + ml[2] * e[2][first] < 0 ? -1 : 1;
    c.a = sqrt(fmax(q[first][first], 0) / -q[second][second]);
    c.b = sqrt(fmax(q[first][first], 0) / -q[third][third]);
    for (i = 0; i < 3; i++)
        c.axis[i] = sign * e[i][first];
    for (i = 0; i < 3; i++) {
        c.wide[i] = c.a * e[i][second];
        c.narrow[i] = c.b * e[i][third];
    }
    /* so that axis, wide, narrow turn to the right */
    sign = c.axis[0] * (c.wide[1] * c.narrow[2] - c.wide[2] * c.narrow[1]) +
           c.axis[1] * (c.wide[2] * c.narrow[0] - c.wide[0] * c.narrow[2]) +
           c.axis[2] * (c.wide[0] * c.narrow[1] - c.wide[1] * c.narrow[0]);
    for (i = 0; i < 3 && sign < 0; i++)
        c.narrow[i] = -c.narrow[i];
    return c;
}

/* The antiderivative over s of 1 / (p^2 + k s^2). */
static double over_quadratic(double s, double p, double k)
{
    const double root = sqrt(fabs(k));
    if (root * fabs(s) < 1e-6 * p)
        return s / (p * p);
    return k > 0 ? atan(root * s / p) / (p * root) : atanh(root * s / p) / (p * root);
}

/* The antiderivative of (r x dr)_z / |r|^2 along the edge r = axis + cos t wide + sin t narrow. */
static double along_edge(const cone *c, double t)
{
    const double p = sqrt(1 + c->a * c->a), q = sqrt(1 + c->b * c->b), k = c->b * c->b - c->a * c->a;
    const double turned = atan2(q * sin(t), p * cos(t)), whole = 2 * pi * floor((t - turned) / (2 * pi) + .5);
    const double ratio = c->a > 0 ? c->b / c->a : 1, other = c->b > 0 ? c->a / c->b : 1;
    return c->a * c->b * c->axis[2] * (turned + whole) / (p * q) - ratio * c->wide[2] * over_quadratic(sin(t), p, k) +
           other * c->narrow[2] * over_quadratic(cos(t), q, -k);
}

/* Lambert's contour integral: the edge above the horizon, then back along the horizon. */
static double clipped(const cone *c)
{
    const double lean = sqrt(c->wide[2] * c->wide[2] + c->narrow[2] * c->narrow[2]), z = c->axis[2];
    double middle, half, from, to, x0, y0, x1, y1, back;
    if (z >= lean)
        return z * c->a * c->b / sqrt((1 + c->a * c->a) * (1 + c->b * c->b));
    if (z <= -lean)
        return 0;
    middle = atan2(c->narrow[2], c->wide[2]);
    half = acos(-z / lean);
    from = middle - half;
    to = middle + half;
    x0 = c->axis[0] + cos(from) * c->wide[0] + sin(from) * c->narrow[0];
    y0 = c->axis[1] + cos(from) * c->wide[1] + sin(from) * c->narrow[1];
    x1 = c->axis[0] + cos(to) * c->wide[0] + sin(to) * c->narrow[0];
    y1 = c->axis[1] + cos(to) * c->wide[1] + sin(to) * c->narrow[1];
    back = atan2(x1 * y0 - y1 * x0, x1 * x0 + y1 * y0);
    return fmax((along_edge(c, to) - along_edge(c, from) + back) / (2 * pi), 0);
}

double lobe_ltc_clipped_ellipse(const double cell[LOBE_LTC_VALUES], const double row[5])
{
    const cone c = cone_of(cell, row);
    return cell[LOBE_LTC_ALBEDO] * clipped(&c);
}

lobe_ltc_factor lobe_ltc_factor_of(const double cell[LOBE_LTC_VALUES], const double row[5])
{
    const cone c = cone_of(cell, row);
    lobe_ltc_factor f;
    f.length = c.a * c.b / sqrt((1 + c.a * c.a) * (1 + c.b * c.b));
    f.height = c.axis[2];
    return f;
}

double lobe_ltc_clipped_sphere(const double cell[LOBE_LTC_VALUES], const double row[5])
{
    const lobe_ltc_factor f = lobe_ltc_factor_of(cell, row);
    const double z = f.height, s2 = f.length, s = sqrt(s2), cosine = sqrt(1 - s2);
    double q;
    if (z >= s)
        return cell[LOBE_LTC_ALBEDO] * s2 * z;
    if (z <= -s)
        return 0;
    q = sqrt(s2 - z * z); /* Snyder 1996 */
    return cell[LOBE_LTC_ALBEDO] *
           fmax(z * s2 * acos(-z * cosine / (s * sqrt(1 - z * z))) - q * cosine + atan2(q, cosine), 0) / pi;
}

/* The lobe in a direction; 0 below the cosine's horizon. */
static double lobe_at(const double cell[LOBE_LTC_VALUES], const double l[3])
{
    const double x = cell[LOBE_LTC_INV11] * l[0] + cell[LOBE_LTC_INV13] * l[2];
    const double z = cell[LOBE_LTC_INV31] * l[0] + cell[LOBE_LTC_INV33] * l[2], n = x * x + l[1] * l[1] + z * z;
    const double det = cell[LOBE_LTC_INV11] * cell[LOBE_LTC_INV33] - cell[LOBE_LTC_INV13] * cell[LOBE_LTC_INV31];
    return z > 0 ? cell[LOBE_LTC_ALBEDO] * fabs(det) * z / (pi * n * n) : 0;
}

double lobe_ltc_both_horizons(const double cell[LOBE_LTC_VALUES], const double row[5])
{
    enum { RINGS = 150, TURNS = 75 };
    const double cz = row[2], sz = sqrt(1 - cz * cz), half = sin(.5 * row[4]), ring = 2 * half * half / RINGS;
    double sum = 0;
    int i, j;
    if (cz >= sin(row[4]))
        return lobe_ltc_clipped_ellipse(cell, row);
    for (i = 0; i < RINGS; i++) {
        const double c = 1 - ring * (i + .5), s = sqrt(1 - c * c);
        for (j = 0; j < 2 * TURNS; j++) {
            const double turn = pi * (j + .5) / TURNS, out = s * sin(turn), up = s * cos(turn);
            const double along = c * sz - up * cz, l[3] = {along * cos(row[3]) - out * sin(row[3]),
                                                           along * sin(row[3]) + out * cos(row[3]), c * cz + up * sz};
            if (l[2] > 0)
                sum += lobe_at(cell, l);
        }
    }
    return sum * ring * pi / TURNS;
}
