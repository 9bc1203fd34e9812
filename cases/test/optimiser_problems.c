#include "optimiser_problems.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

static double rosenbrock(const double *x, size_t dim)
{
    double sum = 0.0;
    for (size_t i = 0; i + 1 < dim; i++) {
        const double a = x[i + 1] - x[i] * x[i], b = 1.0 - x[i];
        sum += 100.0 * a * a + b * b;
    }
    return sum;
}

static double rastrigin(const double *x, size_t dim)
{
    double sum = 10.0 * (double)dim;
    for (size_t i = 0; i < dim; i++)
        sum += x[i] * x[i] - 10.0 * cos(2.0 * pi * x[i]);
    return sum;
}

static double ackley(const double *x, size_t dim)
{
    double squares = 0.0, waves = 0.0;
    for (size_t i = 0; i < dim; i++) {
        squares += x[i] * x[i];
        waves += cos(2.0 * pi * x[i]);
    }
    const double n = (double)dim;
    return 20.0 + exp(1.0) - 20.0 * exp(-0.2 * sqrt(squares / n)) - exp(waves / n);
}

static double griewank(const double *x, size_t dim)
{
    double sum = 1.0, product = 1.0;
    for (size_t i = 0; i < dim; i++) {
        sum += x[i] * x[i] / 4000.0;
        product *= cos(x[i] / sqrt((double)(i + 1)));
    }
    return sum - product;
}

/* Boxes are not centred on the minimum, so that an engine that likes the middle gains nothing. */
const lobe_value_problem lobe_value_problems[] = {
    {"rosenbrock 2", 2, -5.0, 10.0, rosenbrock},   {"rosenbrock 5", 5, -5.0, 10.0, rosenbrock},
    {"rosenbrock 10", 10, -5.0, 10.0, rosenbrock}, {"rastrigin 2", 2, -4.12, 6.12, rastrigin},
    {"rastrigin 5", 5, -4.12, 6.12, rastrigin},    {"ackley 5", 5, -20.0, 45.0, ackley},
    {"griewank 5", 5, -400.0, 800.0, griewank},
};
const size_t lobe_value_problem_count = sizeof lobe_value_problems / sizeof *lobe_value_problems;

static void rosenbrock_rows(const double *x, double *r)
{
    r[0] = 10.0 * (x[1] - x[0] * x[0]);
    r[1] = 1.0 - x[0];
}

static void powell_singular(const double *x, double *r)
{
    r[0] = x[0] + 10.0 * x[1];
    r[1] = sqrt(5.0) * (x[2] - x[3]);
    r[2] = (x[1] - 2.0 * x[2]) * (x[1] - 2.0 * x[2]);
    r[3] = sqrt(10.0) * (x[0] - x[3]) * (x[0] - x[3]);
}

static void bard(const double *x, double *r)
{
    static const double y[15] = {0.14, 0.18, 0.22, 0.25, 0.29, 0.32, 0.35, 0.39,
                                 0.37, 0.58, 0.73, 0.96, 1.34, 2.10, 4.39};
    for (int i = 0; i < 15; i++) {
        const double u = i + 1, v = 15 - i, w = u < v ? u : v;
        r[i] = y[i] - (x[0] + u / (v * x[1] + w * x[2]));
    }
}

static void kowalik_osborne(const double *x, double *r)
{
    static const double y[11] = {0.1957, 0.1947, 0.1735, 0.1600, 0.0844, 0.0627,
                                 0.0456, 0.0342, 0.0323, 0.0235, 0.0246};
    static const double u[11] = {4.0, 2.0, 1.0, 0.5, 0.25, 0.167, 0.125, 0.1, 0.0833, 0.0714, 0.0625};
    for (int i = 0; i < 11; i++)
        r[i] = y[i] - x[0] * (u[i] * u[i] + u[i] * x[1]) / (u[i] * u[i] + u[i] * x[2] + x[3]);
}

static void osborne_1(const double *x, double *r)
{
    static const double y[33] = {0.844, 0.908, 0.932, 0.936, 0.925, 0.908, 0.881, 0.850, 0.818, 0.784, 0.751,
                                 0.718, 0.685, 0.658, 0.628, 0.603, 0.580, 0.558, 0.538, 0.522, 0.506, 0.490,
                                 0.478, 0.467, 0.457, 0.448, 0.438, 0.431, 0.424, 0.420, 0.414, 0.411, 0.406};
    for (int i = 0; i < 33; i++)
        r[i] = y[i] - (x[0] + x[1] * exp(-10.0 * i * x[3]) + x[2] * exp(-10.0 * i * x[4]));
}

/* Data taken from (1 + 2x + 3x^2) / (1 + x/2 + x^2/4), so the smallest sum is 0. */
static void rational(const double *x, double *r)
{
    for (int i = 0; i < 21; i++) {
        const double t = (i - 10) / 10.0;
        const double y = (1.0 + t * (2.0 + 3.0 * t)) / (1.0 + t * (0.5 + 0.25 * t));
        r[i] = y - (x[0] + t * (x[1] + t * x[2])) / (1.0 + t * (x[3] + t * x[4]));
    }
}

const lobe_square_problem lobe_square_problems[] = {
    {"rosenbrock", 2, 2, {-1.2, 1.0}, 0.0, rosenbrock_rows},
    {"powell singular", 4, 4, {3.0, -1.0, 0.0, 1.0}, 0.0, powell_singular},
    {"bard", 3, 15, {1.0, 1.0, 1.0}, 8.21487e-3, bard},
    {"kowalik osborne", 4, 11, {0.25, 0.39, 0.415, 0.39}, 3.0750560385e-4, kowalik_osborne},
    {"osborne 1", 5, 33, {0.5, 1.5, -1.0, 0.01, 0.02}, 5.46489e-5, osborne_1},
    {"rational", 5, 21, {1.0, 1.0, 1.0, 0.0, 0.0}, 0.0, rational},
};
const size_t lobe_square_problem_count = sizeof lobe_square_problems / sizeof *lobe_square_problems;

void lobe_value_problem_eval(void *ctx, const double *params, size_t count, double *values)
{
    const lobe_value_problem *p = ctx;
    for (size_t i = 0; i < count; i++)
        values[i] = p->value(params + i * p->dim, p->dim);
}

void lobe_square_problem_eval(void *ctx, const double *params, size_t count, double *values)
{
    const lobe_square_problem *p = ctx;
    for (size_t i = 0; i < count; i++)
        p->residual(params + i * p->dim, values + i * p->rows);
}
