/* Over the normals. After h = S h' / |S h'|, S = diag(alpha, alpha, 1), the lobe is (u.h') / pi with u = S v, and the
 * light is a quadratic cone h' Q' h' >= 0 (README.md, 1 and 2). Polar coordinates about the cone's axis; t is the
 * eccentric angle of its section. The horizon is a quadratic along each great circle. */
#include <math.h>
#include "quadrature.h"
#include "truth_sphere.h"

static const double pi = 3.14159265358979323846;

typedef struct stretched {
    double alpha, v_z, root_v, f0, u[3], e1[3], e2[3], e3[3], tan2, tan3, direction[3], relative, most;
    int outside; /* the light is what the cone leaves out */
} stretched;

typedef struct eigen {
    long double value[3], vector[3][3]; /* vector[component][index] */
} eigen;

static void rotate(long double *x, long double *y, long double c, long double s)
{
    const long double p = *x, q = *y;
    *x = c * p - s * q;
    *y = s * p + c * q;
}

/* Jacobi. Long double: at sigma 1e-4 the eigenvalue that counts is 5e-9 of the others. */
static eigen eigen_of(long double m[3][3])
{
    eigen e = {.vector = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    int sweep, p, q, k;
    for (sweep = 0; sweep < 40; sweep++) {
        const long double off = fabsl(m[0][1]) + fabsl(m[0][2]) + fabsl(m[1][2]);
        if (off < 1e-19L * (fabsl(m[0][0]) + fabsl(m[1][1]) + fabsl(m[2][2])))
            break;
        for (p = 0; p < 2; p++) {
            for (q = p + 1; q < 3; q++) {
                long double tangent, t, c;
                if (m[p][q] == 0)
                    continue;
                tangent = (m[q][q] - m[p][p]) / (2 * m[p][q]);
                t = (tangent >= 0 ? 1 : -1) / (fabsl(tangent) + sqrtl(tangent * tangent + 1));
                c = 1 / sqrtl(t * t + 1);
                for (k = 0; k < 3; k++)
                    rotate(&m[k][p], &m[k][q], c, t * c);
                for (k = 0; k < 3; k++)
                    rotate(&m[p][k], &m[q][k], c, t * c);
                for (k = 0; k < 3; k++)
                    rotate(&e.vector[k][p], &e.vector[k][q], c, t * c);
            }
        }
    }
    for (k = 0; k < 3; k++)
        e.value[k] = m[k][k];
    return e;
}

static double at_theta(double theta, void *context)
{
    const stretched *s = context;
    const double sine = sin(theta), cosine = cos(theta), a2 = s->alpha * s->alpha;
    double x[3], ux, n2, z, f, root_z;
    int i;
    for (i = 0; i < 3; i++)
        x[i] = cosine * s->e1[i] + sine * s->direction[i];
    ux = s->u[0] * x[0] + s->u[2] * x[2];
    n2 = a2 * (x[0] * x[0] + x[1] * x[1]) + x[2] * x[2];
    z = 2 * ux * x[2] / n2 - s->v_z; /* the light direction's height */
    if (z <= 0 || ux <= 0)
        return 0;
    f = s->f0 + (1 - s->f0) * pow(fmax(0, 1 - ux / sqrt(n2)), 5);
    root_z = sqrt(a2 + (1 - a2) * z * z);
    return sine * ux * f * 2 * z / (z * s->root_v + s->v_z * root_z) / pi;
}

/* An angle in [0, pi) with this tangent. */
static double half_turn(double y, double x)
{
    const double t = atan2(y, x);
    return t < 0 ? t + pi : t;
}

static double at_t(double t, void *context)
{
    stretched *s = context;
    const double c2 = s->tan2 * cos(t), c3 = s->tan3 * sin(t), r = sqrt(c2 * c2 + c3 * c3), a2 = s->alpha * s->alpha;
    const double *p = s->e1, *q = s->direction, edge = atan(r), jacobian = s->tan2 * s->tan3 / (r * r);
    double up, uq, w0, w1, w2, discriminant, inner, breaks[3];
    int i, n = 0;
    for (i = 0; i < 3; i++)
        s->direction[i] = (c2 * s->e2[i] + c3 * s->e3[i]) / r;
    /* the horizon: 2 (u.x) x.z - v_z |S x|^2 = 0 along the great circle */
    up = s->u[0] * p[0] + s->u[2] * p[2];
    uq = s->u[0] * q[0] + s->u[2] * q[2];
    w0 = 2 * up * p[2] - s->v_z * (a2 * (p[0] * p[0] + p[1] * p[1]) + p[2] * p[2]);
    w1 = up * q[2] + uq * p[2] - s->v_z * (a2 * (p[0] * q[0] + p[1] * q[1]) + p[2] * q[2]);
    w2 = 2 * uq * q[2] - s->v_z * (a2 * (q[0] * q[0] + q[1] * q[1]) + q[2] * q[2]);
    discriminant = w1 * w1 - w0 * w2;
    if (discriminant > 0) {
        const double y = -(w1 + (w1 >= 0 ? 1 : -1) * sqrt(discriminant));
        breaks[n++] = half_turn(y, w2);
        breaks[n++] = half_turn(w0, y);
    }
    breaks[n++] = half_turn(-up, uq); /* where the view no longer sees the normal */
    /* Where the light is all but set along this circle, the height is rounding: what is far below the largest part so
     * far need not be relative to itself. */
    inner = lobe_quadrature(at_theta, s, s->outside ? edge : 0, s->outside ? pi : edge, breaks, n, .1 * s->relative,
                            1e-4 * s->relative * s->most / jacobian);
    s->most = fmax(s->most, fabs(jacobian * inner));
    return jacobian * inner;
}

double lobe_truth_sphere_stretched(const lobe_sphere_scene *scene, double tolerance)
{
    const long double vz = scene->v_z, lz = scene->l_z, a = scene->alpha, sine = sqrtl(1 - lz * lz);
    const long double v[3] = {sqrtl(1 - vz * vz), 0, vz}, scale[3] = {a, a, 1};
    const long double l[3] = {sine * cosl(scene->azimuth), sine * sinl(scene->azimuth), lz};
    const long double k = v[0] * l[0] + v[2] * l[2] + cosl(scene->sigma);
    /* k < 0: the light holds -v; -Q' has the one positive eigenvalue, and its cone is what the light leaves out */
    const long double side = k < 0 ? -1 : 1;
    double ratio, root, breaks[15];
    long double m[3][3];
    stretched s = {.alpha = scene->alpha, .v_z = scene->v_z, .f0 = scene->f0, .relative = tolerance};
    eigen e;
    int i, j, top = 0, second, third;
    if (asin(scene->l_z) <= -scene->sigma)
        return 0;
    for (i = 0; i < 3; i++)
        for (j = 0; j < 3; j++)
            m[i][j] = side * scale[i] * scale[j] * (v[i] * l[j] + l[i] * v[j] - (i == j ? k : 0));
    e = eigen_of(m);
    for (i = 1; i < 3; i++)
        top = e.value[i] > e.value[top] ? i : top;
    second = (top + 1) % 3;
    third = (top + 2) % 3;
    if (e.value[second] > e.value[third]) { /* the short axis of the section is the second */
        second = third;
        third = (top + 1) % 3;
    }
    for (i = 0; i < 3; i++) {
        s.u[i] = (double)(scale[i] * v[i]);
        s.e1[i] = (double)e.vector[i][top];
        s.e2[i] = (double)e.vector[i][second];
        s.e3[i] = (double)e.vector[i][third];
    }
    s.outside = k < 0;
    s.root_v = sqrt(scene->alpha * scene->alpha + (1 - scene->alpha * scene->alpha) * scene->v_z * scene->v_z);
    if (s.u[0] * s.e1[0] + s.u[2] * s.e1[2] < 0) {
        for (i = 0; i < 3; i++)
            s.e1[i] = -s.e1[i];
    }
    /* at k = 0 an eigenvalue is 0 and the cone a wedge: a tangent of 1e9 is that within 1e-9 */
    s.tan2 = (double)sqrtl(e.value[top] / fmaxl(-e.value[second], 1e-18L * e.value[top]));
    s.tan3 = (double)sqrtl(e.value[top] / fmaxl(-e.value[third], 1e-18L * e.value[top]));
    /* A long section sweeps through its short axis within the ratio of the two: breaks, or the nodes step over it. */
    ratio = atan(s.tan2 / s.tan3);
    root = atan(sqrt(s.tan2 / s.tan3));
    for (i = 0; i < 2; i++) {
        const double turn = i * pi;
        breaks[7 * i] = turn + ratio;
        breaks[7 * i + 1] = turn + root;
        breaks[7 * i + 2] = turn + .25 * pi;
        breaks[7 * i + 3] = turn + .5 * pi;
        breaks[7 * i + 4] = turn + .75 * pi;
        breaks[7 * i + 5] = turn + pi - root;
        breaks[7 * i + 6] = turn + pi - ratio;
    }
    breaks[14] = pi;
    return lobe_quadrature(at_t, &s, 0, 2 * pi, breaks, 15, tolerance, 0);
}

void lobe_truth_sphere_rows(const double *in, double *out, size_t n)
{
    size_t i;
    for (i = 0; i < n; i++, in += 5) {
        const lobe_sphere_scene s = {in[0] * in[0], in[1], in[2], in[3], in[4], 1};
        out[i] = lobe_truth_sphere_stretched(&s, 1e-8);
    }
}
