#include "newton.h"
#include <math.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

enum { Q = LOBE_NEWTON_QUANTITIES, THREADS = 16 };

/* What one point contributes: value, gradient and Hessian by its quantities. */
typedef struct part {
    double value, slope[Q], bend[Q][Q];
} part;

typedef struct job {
    const lobe_newton *n;
    const double *c;
    part *parts;
    bool bends; /* false: values alone */
    size_t first, stride;
} job;

static void quantities_at(const lobe_newton *n, size_t point, const double *c, double *q)
{
    const double *feature = n->feature + point * (size_t)n->features;
    int k, i;
    for (k = 0; k < n->quantities; k++) {
        q[k] = 0;
        for (i = 0; i < n->features; i++)
            q[k] += c[k * n->features + i] * feature[i];
    }
}

static double moved(const lobe_newton *n, size_t point, const double *q, int i, double x, int j, double y)
{
    double at[Q];
    memcpy(at, q, sizeof *q * (size_t)n->quantities);
    at[i] += x;
    at[j] += y;
    return n->value(n->ctx, point, at);
}

/* Central differences. */
static void differentiate(const lobe_newton *n, size_t point, const double *q, part *p)
{
    const double h = n->step;
    int i, j;
    for (i = 0; i < n->quantities; i++) {
        const double up = moved(n, point, q, i, h, i, 0), down = moved(n, point, q, i, -h, i, 0);
        p->slope[i] = (up - down) / (2 * h);
        p->bend[i][i] = (up - 2 * p->value + down) / (h * h);
        for (j = 0; j < i; j++)
            p->bend[i][j] = p->bend[j][i] = (moved(n, point, q, i, h, j, h) - moved(n, point, q, i, h, j, -h) -
                                             moved(n, point, q, i, -h, j, h) + moved(n, point, q, i, -h, j, -h)) /
                                            (4 * h * h);
    }
}

/* Turns a symmetric matrix into the one with the absolute values of its eigenvalues, by Jacobi's rotations: a step on
 * it goes down even where the function bends the wrong way. */
static void make_positive(double m[Q][Q], int n)
{
    double v[Q][Q] = {{0}}, out[Q][Q] = {{0}};
    int i, j, k, sweep;
    for (i = 0; i < n; i++)
        v[i][i] = 1;
    for (sweep = 0; sweep < 12; sweep++)
        for (i = 0; i < n; i++)
            for (j = 0; j < i; j++) {
                const double half = (m[j][j] - m[i][i]) / 2, r = sqrt(half * half + m[i][j] * m[i][j]);
                const double t = r > 0 ? m[i][j] / (half + (half >= 0 ? r : -r)) : 0;
                const double c = 1 / sqrt(1 + t * t), s = t * c;
                if (m[i][j] == 0)
                    continue;
                for (k = 0; k < n; k++) {
                    const double a = m[k][i], b = m[k][j];
                    m[k][i] = c * a - s * b;
                    m[k][j] = s * a + c * b;
                }
                for (k = 0; k < n; k++) {
                    const double a = m[i][k], b = m[j][k];
                    m[i][k] = c * a - s * b;
                    m[j][k] = s * a + c * b;
                }
                for (k = 0; k < n; k++) {
                    const double a = v[k][i], b = v[k][j];
                    v[k][i] = c * a - s * b;
                    v[k][j] = s * a + c * b;
                }
            }
    for (i = 0; i < n; i++)
        for (j = 0; j < n; j++)
            for (k = 0; k < n; k++)
                out[i][j] += v[i][k] * fabs(m[k][k]) * v[j][k];
    memcpy(m, out, sizeof out);
}

static void *work(void *ctx)
{
    const job *j = ctx;
    size_t point;
    for (point = j->first; point < j->n->points; point += j->stride) {
        part *p = j->parts + point;
        double q[Q];
        quantities_at(j->n, point, j->c, q);
        p->value = j->n->value(j->n->ctx, point, q);
        if (j->bends) {
            differentiate(j->n, point, q, p);
            make_positive(p->bend, j->n->quantities);
        }
    }
    return NULL;
}

/* The sum with its ridge; the parts are filled. */
static double evaluate(const lobe_newton *n, const double *c, part *parts, bool bends)
{
    const int threads = n->threads < 1 ? 1 : n->threads > THREADS ? THREADS : n->threads;
    job jobs[THREADS];
    pthread_t ids[THREADS];
    bool started[THREADS] = {false};
    double sum = 0;
    size_t point;
    int i;
    for (i = 0; i < threads; i++)
        jobs[i] = (job){n, c, parts, bends, (size_t)i, (size_t)threads};
    for (i = 1; i < threads; i++)
        started[i] = pthread_create(&ids[i], NULL, work, &jobs[i]) == 0;
    work(&jobs[0]);
    for (i = 1; i < threads; i++) {
        if (started[i])
            pthread_join(ids[i], NULL);
        else
            work(&jobs[i]);
    }
    for (point = 0; point < n->points; point++)
        sum += parts[point].value;
    for (i = 0; i < n->quantities * n->features; i++)
        sum += n->ridge * c[i] * c[i];
    return sum;
}

static void assemble(const lobe_newton *n, const double *c, const part *parts, double *matrix, double *right)
{
    const int f = n->features, dim = n->quantities * f;
    size_t point;
    int i, j, k, l;
    memset(matrix, 0, sizeof *matrix * (size_t)(dim * dim));
    for (i = 0; i < dim; i++) {
        right[i] = -2 * n->ridge * c[i];
        matrix[i * dim + i] = 2 * n->ridge;
    }
    for (point = 0; point < n->points; point++) {
        const double *x = n->feature + point * (size_t)f;
        const part *p = parts + point;
        for (i = 0; i < n->quantities; i++)
            for (k = 0; k < f; k++) {
                right[i * f + k] -= p->slope[i] * x[k];
                for (j = 0; j < n->quantities; j++)
                    for (l = 0; l < f; l++)
                        matrix[(i * f + k) * dim + j * f + l] += p->bend[i][j] * x[k] * x[l];
            }
    }
}

/* Solves (matrix + damping diag) step = right by Cholesky's factor. false: not positive. */
static bool solve(const double *matrix, const double *right, int dim, double damping, double *factor, double *step)
{
    int i, j, k;
    for (i = 0; i < dim; i++) {
        for (j = 0; j <= i; j++) {
            double sum = matrix[i * dim + j];
            if (i == j)
                sum += damping * matrix[i * dim + i] + 1e-12;
            for (k = 0; k < j; k++)
                sum -= factor[i * dim + k] * factor[j * dim + k];
            if (i == j && !(sum > 0))
                return false;
            factor[i * dim + j] = i == j ? sqrt(sum) : sum / factor[j * dim + j];
        }
    }
    for (i = 0; i < dim; i++) {
        step[i] = right[i];
        for (k = 0; k < i; k++)
            step[i] -= factor[i * dim + k] * step[k];
        step[i] /= factor[i * dim + i];
    }
    for (i = dim - 1; i >= 0; i--) {
        for (k = i + 1; k < dim; k++)
            step[i] -= factor[k * dim + i] * step[k];
        step[i] /= factor[i * dim + i];
    }
    return true;
}

bool lobe_newton_run(const lobe_newton *n, double *c, double *value)
{
    const int dim = n->quantities * n->features;
    part *parts = malloc(sizeof *parts * n->points);
    double *matrix = malloc(sizeof *matrix * (size_t)(2 * dim * dim + 3 * dim)), *factor, *right, *step, *tried;
    double damping = 0.1;
    int round, turn, i;
    bool better = true;
    if (!parts || !matrix) {
        free(parts);
        free(matrix);
        return false;
    }
    factor = matrix + dim * dim;
    right = factor + dim * dim;
    step = right + dim;
    tried = step + dim;
    *value = evaluate(n, c, parts, false);
    for (round = 0; round < n->rounds && better; round++) {
        const double before = *value;
        if (n->progress && !n->progress(n->progress_ctx, round, *value))
            break;
        evaluate(n, c, parts, true);
        assemble(n, c, parts, matrix, right);
        better = false;
        for (turn = 0; turn < 12 && !better; turn++) {
            if (solve(matrix, right, dim, damping, factor, step)) {
                double next;
                for (i = 0; i < dim; i++)
                    tried[i] = c[i] + step[i];
                next = evaluate(n, tried, parts, false);
                better = next < *value;
                if (better) {
                    *value = next;
                    memcpy(c, tried, sizeof *c * (size_t)dim);
                }
            }
            damping = better ? fmax(damping / 4, 1e-9) : fmin(damping * 5, 1e9);
        }
        better = better && before - *value > 1e-6 * *value;
    }
    free(parts);
    free(matrix);
    return true;
}
