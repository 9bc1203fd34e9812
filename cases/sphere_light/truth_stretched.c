/* Over the normals. After h = S h' / |S h'|, S = diag(alpha, alpha, 1), the lobe is (u.h') / pi with u = S v, and the
 * light is a quadratic cone h' Q' h' >= 0 (README.md, 1 and 2). Polar coordinates about the cone's axis; t is the
 * eccentric angle of its section. The horizon is a quadratic along each great circle. Here the cone is found;
 * truth_stretched.h integrates, in C and in OpenCL C. */
#define LOBE_DOUBLE
#include "truth_stretched.h"
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../fit/opencl.h"
#include "truth_sphere.h"

extern const char lobe_truth_sphere_source[];

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

/* false: the light is wholly set. */
static bool stretch(const lobe_sphere_scene *scene, double tolerance, lobe_stretched *s)
{
    const long double vz = scene->v_z, lz = scene->l_z, a = scene->alpha, sine = sqrtl(1 - lz * lz);
    const long double v[3] = {sqrtl(1 - vz * vz), 0, vz}, scale[3] = {a, a, 1};
    const long double l[3] = {sine * cosl(scene->azimuth), sine * sinl(scene->azimuth), lz};
    const long double k = v[0] * l[0] + v[2] * l[2] + cosl(scene->sigma);
    /* k < 0: the light holds -v; -Q' has the one positive eigenvalue, and its cone is what the light leaves out */
    const long double side = k < 0 ? -1 : 1;
    long double m[3][3], behind;
    eigen e;
    int i, j, top = 0, second, third;
    if (asin(scene->l_z) <= -scene->sigma)
        return false;
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
    s->alpha = scene->alpha;
    s->v_z = scene->v_z;
    s->root_v = sqrt(scene->alpha * scene->alpha + (1 - scene->alpha * scene->alpha) * scene->v_z * scene->v_z);
    s->f0 = scene->f0;
    s->relative = tolerance;
    s->outside = k < 0 ? 1 : 0;
    s->u_x = (double)(scale[0] * v[0]);
    s->u_z = (double)vz;
    behind = scale[0] * v[0] * e.vector[0][top] + vz * e.vector[2][top] < 0 ? -1 : 1;
    for (i = 0; i < 3; i++) {
        s->e1[i] = (double)(behind * e.vector[i][top]);
        s->e2[i] = (double)e.vector[i][second];
        s->e3[i] = (double)e.vector[i][third];
    }
    /* at k = 0 an eigenvalue is 0 and the cone a wedge: a tangent of 1e9 is that within 1e-9 */
    s->tan2 = (double)sqrtl(e.value[top] / fmaxl(-e.value[second], 1e-18L * e.value[top]));
    s->tan3 = (double)sqrtl(e.value[top] / fmaxl(-e.value[third], 1e-18L * e.value[top]));
    return true;
}

double lobe_truth_sphere_stretched(const lobe_sphere_scene *scene, double tolerance)
{
    lobe_stretched s;
    return stretch(scene, tolerance, &s) ? lobe_stretched_integral(&s) : 0;
}

static lobe_sphere_scene scene_of(const double *in)
{
    const lobe_sphere_scene s = {in[0] * in[0], in[1], in[2], in[3], in[4], 1};
    return s;
}

void lobe_truth_sphere_rows(const double *in, double *out, size_t n)
{
    size_t i;
    for (i = 0; i < n; i++) {
        const lobe_sphere_scene s = scene_of(in + 5 * i);
        out[i] = lobe_truth_sphere_stretched(&s, 1e-8);
    }
}

/* The cone is found here, in long double, which a device need not have; alpha = 0 stands for a light that is set. */
int lobe_truth_sphere_opencl(const double *in, double *out, size_t n, char *error, size_t error_size)
{
    static const double table[1] = {0};
    lobe_opencl_job job = {.source = lobe_truth_sphere_source, .entry = "lobe_truth_rows"};
    double *rows = calloc(n ? n : 1, sizeof(lobe_stretched));
    size_t i;
    int status;
    if (!rows) {
        snprintf(error, error_size, "OpenCL: no memory for %zu rows", n);
        return 2;
    }
    for (i = 0; i < n; i++) {
        const lobe_sphere_scene scene = scene_of(in + 5 * i);
        lobe_stretched s;
        if (stretch(&scene, 1e-8, &s))
            memcpy(rows + LOBE_STRETCHED_ROW * i, &s, sizeof s);
    }
    job.in = rows;
    job.in_count = LOBE_STRETCHED_ROW * n;
    job.out = out;
    job.out_count = n;
    job.table = table;
    job.table_count = 1;
    job.rows = n;
    status = lobe_opencl_run(&job, error, error_size);
    free(rows);
    return status;
}
