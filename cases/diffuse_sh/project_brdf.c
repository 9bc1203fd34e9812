/* Any low-frequency BRDF that is one kernel: its nine coefficients, best direction, zonal lobe, and a fit.
 *
 *     make project-brdf BRDF=my.h              builds build/project_my; its function is lobe_brdf_my, or BRDF_NAME=f
 *     build/project_my truth ROUGHNESS NDOTV   nine coefficients and the two integrators' difference
 *     build/project_my table                   direction, beta and zonal ratios over roughness x NdotV
 *     build/project_my fit DEGREE NAME         a shape kernel, polynomials in roughness and 1 - v, for diffuse_sh.h
 *
 * The header holds lobe_real f(n_dot_l, n_dot_v, l_dot_v, roughness) in the dialect, 1/pi included (brdf/eon.h). Both
 * integrators split the hemisphere where diffuse BRDFs have kinks, at n.L = n.V and at azimuth 90 degrees from the
 * view: Gauss in (polar angle, azimuth), and tanh-sinh in (n.L, azimuth). */
#define LOBE_DOUBLE 1
#include LOBE_BRDF_HEADER
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "truth_diffuse.h"

static const double pi = 3.14159265358979323846;

enum { GRID = 17, MOST_TERMS = 36 };

static void add(double r, double v, double z, double phi, double weight, double c[9])
{
    const double sl = sqrt(fmax(0, 1 - z * z)), sv = sqrt(fmax(0, 1 - v * v)), x = sl * cos(phi), y = sl * sin(phi);
    double b[9];
    const double value = LOBE_BRDF(z, v, sl * sv * cos(phi) + v * z, r) * z * weight;
    lobe_truth_basis(b, x, y, z);
    for (int i = 0; i < 9; i++)
        c[i] += value * b[i];
}

/* Both halves of the azimuth are mirror images: [0, pi/2] and [pi/2, pi], doubled; sin terms vanish. */
static void panels(double r, double v, int polar_angle, int n, const double *node, const double *weight, double c[9])
{
    const double edge[3] = {0, polar_angle ? acos(v) : v, polar_angle ? pi / 2 : 1};
    memset(c, 0, 9 * sizeof *c);
    for (int p = 0; p < 2; p++)
        for (int q = 0; q < 2; q++)
            for (int i = 0; i < n; i++)
                for (int j = 0; j < n; j++) {
                    const double width = edge[p + 1] - edge[p], a = edge[p] + width * node[i];
                    const double phi = pi / 2 * (q + node[j]);
                    const double jacobian = width * (polar_angle ? sin(a) : 1) * pi;
                    if (width > 0)
                        add(r, v, polar_angle ? cos(a) : a, phi, weight[i] * weight[j] * jacobian, c);
                }
    c[1] = c[4] = c[5] = 0;
}

static void tanh_sinh(int n, double *node, double *weight)
{
    const double h = 6.4 / (n - 1);
    for (int i = 0; i < n; i++) {
        const double t = -3.2 + i * h, u = pi / 2 * sinh(t);
        node[i] = 0.5 + 0.5 * tanh(u);
        weight[i] = h * pi / 4 * cosh(t) / (cosh(u) * cosh(u));
    }
}

static double project(double r, double v, double c[9], int second)
{
    static double node[2][64], weight[2][64];
    double other[9], worst = 0;
    if (node[0][0] == 0) {
        lobe_truth_gauss(24, node[0], weight[0]);
        tanh_sinh(61, node[1], weight[1]);
    }
    panels(r, v, 1, 24, node[0], weight[0], c);
    if (second) {
        panels(r, v, 0, 61, node[1], weight[1], other);
        for (int i = 0; i < 9; i++)
            worst = fmax(worst, fabs(c[i] - other[i]));
    }
    return worst;
}

/* The zonal lobe at `angle` from the normal that is nearest to c; returns the squared distance. */
static double zonal_at(const double c[9], double angle, double z[3])
{
    const double s = sin(angle), k = cos(angle);
    const double u[3] = {1.5 * k * k - 0.5, sqrt(3) * s * k, sqrt(0.75) * s * s};
    z[0] = c[0];
    z[1] = c[2] * k + c[3] * s;
    z[2] = c[6] * u[0] + c[7] * u[1] + c[8] * u[2];
    return c[2] * c[2] + c[3] * c[3] - z[1] * z[1] + c[6] * c[6] + c[7] * c[7] + c[8] * c[8] - z[2] * z[2];
}

static double best_angle(const double c[9], double z[3])
{
    double low = -1.2, high = 1.2;
    for (int turn = 0; turn < 100; turn++) { /* golden section: one minimum, since band 1 dominates */
        const double a = high - 0.6180339887498949 * (high - low), b = low + 0.6180339887498949 * (high - low);
        double unused[3];
        if (zonal_at(c, a, unused) < zonal_at(c, b, unused))
            high = b;
        else
            low = a;
    }
    zonal_at(c, (low + high) / 2, z);
    return (low + high) / 2;
}

static double beta_of(double angle, double v)
{
    const double t = tan(angle), d = sqrt(1 - v * v) + t * (1 - v);
    return d > 1e-9 ? t / d : 0;
}

static void table(void)
{
    double lobe = 0, total = 0, furnace_low = 1e9, furnace_high = 0, agreement = 0;
    printf("# roughness NdotV albedo linear-degrees zonal-degrees beta Z0 Z1/Z0 Z2/Z0 zonal-error%%\n");
    for (int i = 0; i < GRID; i++)
        for (int j = 0; j < GRID; j++) {
            const double r = i / (GRID - 1.0), v = j / (GRID - 1.0);
            double c[9], z[3], norm = 0;
            agreement = fmax(agreement, project(r, v, c, i % 4 == 0 && j % 4 == 0));
            const double angle = best_angle(c, z), miss = fmax(0, zonal_at(c, angle, z));
            for (int k = 0; k < 9; k++)
                norm += c[k] * c[k];
            lobe += miss, total += norm;
            furnace_low = fmin(furnace_low, c[0] * sqrt(4 * pi)),
            furnace_high = fmax(furnace_high, c[0] * sqrt(4 * pi));
            if (i % 4 == 0 && j % 4 == 0)
                printf("%.2f %.2f %.6f %7.3f %7.3f %8.5f %.6f %.5f %.5f %.3f\n", r, v, c[0] * sqrt(4 * pi),
                       atan2(c[3], c[2]) * 180 / pi, angle * 180 / pi, beta_of(angle, v), z[0], z[1] / z[0],
                       z[2] / z[0], 100 * sqrt(miss / norm));
        }
    printf("# albedo %.5f .. %.5f, best zonal lobe %.3f %% rms, integrators agree to %.1e\n", furnace_low, furnace_high,
           100 * sqrt(lobe / total), agreement);
}

/* Least squares by modified Gram-Schmidt, twice; columns are few and well scaled. */
static void least_squares(int rows, int n, double *a, double *b, double *x)
{
    double r[MOST_TERMS][MOST_TERMS] = {{0}};
    for (int k = 0; k < n; k++) {
        for (int turn = 0; turn < 2; turn++)
            for (int m = 0; m < k; m++) {
                double s = 0;
                for (int i = 0; i < rows; i++)
                    s += a[m * rows + i] * a[k * rows + i];
                r[m][k] += s;
                for (int i = 0; i < rows; i++)
                    a[k * rows + i] -= s * a[m * rows + i];
            }
        double s = 0;
        for (int i = 0; i < rows; i++)
            s += a[k * rows + i] * a[k * rows + i];
        r[k][k] = sqrt(s);
        for (int i = 0; i < rows; i++)
            a[k * rows + i] /= r[k][k];
    }
    for (int k = n - 1; k >= 0; k--) {
        double s = 0;
        for (int i = 0; i < rows; i++)
            s += a[k * rows + i] * b[i];
        for (int m = k + 1; m < n; m++)
            s -= r[k][m] * x[m];
        x[k] = s / r[k][k];
    }
}

/* Each of the six weights as a polynomial of total degree `degree` in r and x = 1 - v. */
static int fit(int degree, const char *name)
{
    enum { SIDE = 33, ROWS = SIDE * SIDE };
    static double c[ROWS][9], a[MOST_TERMS * ROWS], b[ROWS], coefficient[6][MOST_TERMS];
    static const int index[6] = {0, 2, 3, 6, 7, 8}, power_of_s[6] = {0, 0, 1, 0, 1, 2};
    static const char *const label[6] = {"c00", "c1n", "c1t", "c2n", "c2t", "c2tt"};
    char upper[32];
    const int terms = (degree + 1) * (degree + 2) / 2;
    double miss = 0, total = 0, furnace = 0, furnace_max = 0;
    if (!*name || strlen(name) >= sizeof upper ||
        strspn(name, "abcdefghijklmnopqrstuvwxyz0123456789_") != strlen(name)) {
        fprintf(stderr, "project_brdf: name \"%s\" is not lower case letters, digits and _, 1 to 31\n", name);
        return 2;
    }
    for (size_t i = 0; i <= strlen(name); i++)
        upper[i] = (char)(name[i] >= 'a' && name[i] <= 'z' ? name[i] - 32 : name[i]);
    for (int i = 0; i < ROWS; i++) {
        project((i / SIDE) / (SIDE - 1.0), (i % SIDE) / (SIDE - 1.0), c[i], 0);
        for (int k = 0; k < 9; k++)
            total += c[i][k] * c[i][k];
    }
    for (int k = 0; k < 6; k++) {
        for (int i = 0; i < ROWS; i++) {
            const double r = (i / SIDE) / (SIDE - 1.0), v = (i % SIDE) / (SIDE - 1.0), x = 1 - v;
            const double weight = 1 / c[i][0], s = pow(sqrt(1 - v * v), power_of_s[k]);
            for (int p = 0, t = 0; p <= degree; p++)
                for (int q = 0; p + q <= degree; q++, t++)
                    a[t * ROWS + i] = pow(r, p) * pow(x, q) * weight * s;
            b[i] = c[i][index[k]] * weight;
        }
        least_squares(ROWS, terms, a, b, coefficient[k]);
        for (int i = 0; i < ROWS; i++) {
            const double r = (i / SIDE) / (SIDE - 1.0), v = (i % SIDE) / (SIDE - 1.0), x = 1 - v;
            double value = 0;
            for (int p = 0, t = 0; p <= degree; p++)
                for (int q = 0; p + q <= degree; q++, t++)
                    value += coefficient[k][t] * pow(r, p) * pow(x, q);
            value = value * pow(sqrt(1 - v * v), power_of_s[k]) - c[i][index[k]];
            miss += value * value;
            if (k == 0) {
                furnace += value * value / (c[i][0] * c[i][0]);
                furnace_max = fmax(furnace_max, fabs(value / c[i][0]));
            }
        }
    }
    printf("/* %s times the cosine as nine spherical harmonics: polynomials of degree %d in roughness and 1 - v.\n"
           " * Random order-3 lighting %.3f %% rms; furnace %.3f %% rms, %.3f %% max. Written by "
           "cases/diffuse_sh/project_brdf.c. */\n",
           name, degree, 100 * sqrt(miss / total), 100 * sqrt(furnace / ROWS), 100 * furnace_max);
    printf("#ifndef LOBE_%s_SHAPE_H\n#define LOBE_%s_SHAPE_H\n#include \"diffuse_sh.h\"\n\n", upper, upper);
    printf("LOBE_FN lobe_diffuse_shape lobe_%s_shape(lobe_real roughness, lobe_real n_dot_v)\n{\n", name);
    printf("    LOBE_LET r = lobe_saturate(roughness);\n    LOBE_LET x = LOBE_R(1.0) - lobe_saturate(n_dot_v);\n");
    for (int k = 0; k < 6; k++) {
        int t = terms;
        for (int p = degree; p >= 0; p--) { /* rows of r^p: Horner in x inside, in r outside */
            t -= degree - p + 1;
            printf("    LOBE_LET %s_%d = ", label[k], p);
            if (p < degree)
                printf("r * %s_%d + ", label[k], p + 1);
            for (int q = 1; q < degree - p; q++)
                printf("(");
            for (int q = degree - p; q > 0; q--)
                printf(q == degree - p ? "LOBE_R(%.9g) * x" : " + LOBE_R(%.9g)) * x", coefficient[k][t + q]);
            printf("%sLOBE_R(%.9g);\n", p < degree ? " + " : "", coefficient[k][t]);
        }
    }
    printf("    return lobe_diffuse_shape_of(c00_0, c1n_0, c1t_0, c2n_0, c2t_0, c2tt_0);\n}\n\n#endif\n");
    return 0;
}

/* A number in [lo, hi], the whole of text; else 0 after a line on stderr. */
static int number(const char *text, const char *what, double lo, double hi, double *x)
{
    char *end;
    *x = strtod(text, &end);
    if (end != text && !*end && *x >= lo && *x <= hi)
        return 1;
    fprintf(stderr, "project_brdf: %s '%s' is not a number in [%g, %g]\n", what, text, lo, hi);
    return 0;
}

int main(int argc, char **argv)
{
    double r, v, degree;
    if (argc == 4 && !strcmp(argv[1], "truth")) {
        double c[9], difference;
        int i;
        if (!number(argv[2], "roughness", 0, 1, &r) || !number(argv[3], "NdotV", 0, 1, &v))
            return 2;
        difference = project(r, v, c, 1);
        for (i = 0; i < 9; i++)
            printf("%.17g%c", c[i], i < 8 ? ' ' : '\n');
        printf("# integrators differ by %.1e\n", difference);
    } else if (argc == 2 && !strcmp(argv[1], "table")) {
        table();
    } else if (argc == 4 && !strcmp(argv[1], "fit")) {
        if (!number(argv[2], "degree", 0, 7, &degree) || degree != floor(degree)) {
            fprintf(stderr, "project_brdf: the degree is a whole number\n");
            return 2;
        }
        return fit((int)degree, argv[3]);
    } else {
        fprintf(stderr, "usage: project_brdf truth ROUGHNESS NDOTV | table | fit DEGREE NAME\n");
        return 2;
    }
    if (fflush(stdout) != 0 || ferror(stdout)) {
        fprintf(stderr, "project_brdf: cannot write: %s\n", strerror(errno));
        return 2;
    }
    return 0;
}
