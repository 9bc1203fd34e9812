#include "truth_diffuse.h"
#include <math.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

double lobe_burley_2012(double n_dot_l, double n_dot_v, double l_dot_v, double roughness)
{
    const double h_length = sqrt(fmax(0, 2 + 2 * l_dot_v));
    const double l_dot_h = h_length > 0 ? (1 + l_dot_v) / h_length : 0;
    const double fd90 = 0.5 + 2 * roughness * l_dot_h * l_dot_h;
    const double fl = 1 + (fd90 - 1) * pow(1 - n_dot_l, 5), fv = 1 + (fd90 - 1) * pow(1 - n_dot_v, 5);
    return fl * fv / pi;
}

void lobe_truth_basis(double b[9], double x, double y, double z)
{
    const double k1 = sqrt(3 / (4 * pi)), k2 = sqrt(15 / (4 * pi));
    b[0] = sqrt(1 / (4 * pi));
    b[1] = k1 * y;
    b[2] = k1 * z;
    b[3] = k1 * x;
    b[4] = k2 * x * y;
    b[5] = k2 * y * z;
    b[6] = sqrt(5 / (16 * pi)) * (3 * z * z - 1);
    b[7] = k2 * x * z;
    b[8] = k2 / 2 * (x * x - y * y);
}

/* Newton on the Legendre polynomial, from the usual first guess. */
void lobe_truth_gauss(int n, double *node, double *weight)
{
    int i, turn, k;
    for (i = 0; i < n; i++) {
        double t = cos(pi * (i + 0.75) / (n + 0.5)), derivative = 1;
        for (turn = 0; turn < 40; turn++) {
            double p0 = 1, p1 = t, step;
            for (k = 2; k <= n; k++) {
                const double p2 = ((2 * k - 1) * t * p1 - (k - 1) * p0) / k;
                p0 = p1;
                p1 = p2;
            }
            derivative = n * (t * p1 - p0) / (t * t - 1);
            step = p1 / derivative;
            t -= step;
            if (fabs(step) < 1e-16)
                break;
        }
        node[i] = (1 + t) / 2;
        weight[i] = 1 / ((1 - t * t) * derivative * derivative);
    }
}

static void add(lobe_diffuse_brdf *brdf, double r, double v, const double l[3], double weight, double c[9])
{
    const double s = sqrt(fmax(0, 1 - v * v)), value = brdf(l[2], v, s * l[0] + v * l[2], r) * l[2] * weight;
    double b[9];
    int i;
    lobe_truth_basis(b, l[0], l[1], l[2]);
    for (i = 0; i < 9; i++)
        c[i] += value * b[i];
}

void lobe_diffuse_about_z(lobe_diffuse_brdf *brdf, double roughness, double n_dot_v, int order, double c[9])
{
    double node[LOBE_DIFFUSE_NODES], weight[LOBE_DIFFUSE_NODES];
    int i, j;
    lobe_truth_gauss(order, node, weight);
    memset(c, 0, 9 * sizeof *c);
    for (i = 0; i < order; i++)
        for (j = 0; j < order; j++) {
            const double phi = 2 * pi * (j + 0.5) / order, sine = sqrt(1 - node[i] * node[i]);
            const double l[3] = {sine * cos(phi), sine * sin(phi), node[i]};
            add(brdf, roughness, n_dot_v, l, weight[i] * 2 * pi / order, c);
        }
}

void lobe_diffuse_about_y(lobe_diffuse_brdf *brdf, double roughness, double n_dot_v, int order, double c[9])
{
    double node[LOBE_DIFFUSE_NODES], weight[LOBE_DIFFUSE_NODES];
    int i, j;
    lobe_truth_gauss(order, node, weight);
    memset(c, 0, 9 * sizeof *c);
    for (i = 0; i < order; i++)
        for (j = 0; j < order; j++) {
            const double theta = pi * node[i], psi = pi * (node[j] - 0.5);
            const double l[3] = {sin(theta) * sin(psi), cos(theta), sin(theta) * cos(psi)};
            add(brdf, roughness, n_dot_v, l, weight[i] * weight[j] * pi * pi * sin(theta), c);
        }
}

void lobe_diffuse_adaptive(lobe_diffuse_integrator *integrate, lobe_diffuse_brdf *brdf, double roughness,
                           double n_dot_v, double c[9])
{
    double before[9], change = 1;
    int order = 12, i;
    integrate(brdf, roughness, n_dot_v, order, c);
    while (change > 1e-14 && order < LOBE_DIFFUSE_NODES) {
        memcpy(before, c, sizeof before);
        order *= 2;
        integrate(brdf, roughness, n_dot_v, order, c);
        for (change = 0, i = 0; i < 9; i++)
            change = fmax(change, fabs(c[i] - before[i]));
    }
}

void lobe_truth_diffuse_rows(const double *in, double *out, size_t n)
{
    size_t i;
    for (i = 0; i < n; i++) {
        double *c = out + 9 * i;
        lobe_diffuse_adaptive(lobe_diffuse_about_z, lobe_burley_2012, in[2 * i], in[2 * i + 1], c);
        c[1] = c[4] = c[5] = 0; /* the lobe is even in y */
    }
}
