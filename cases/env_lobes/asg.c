#include "asg.h"
#include <math.h>
#include <stddef.h>
#include "../fit/nelder_mead.h"
#include "gauss.h"
#include "judge.h"
#include "response.h"
#include "samplers.h"
#include "visible_normals.h"

static const double pi = 3.14159265358979323846;

enum { TARGET_ORDER = 96, ORDER = 40 };

typedef struct problem {
    double alpha, n_dot_v, power; /* integral of the square of the response over its albedo */
    int energy, count;
    double nodes[5 * TARGET_ORDER * TARGET_ORDER]; /* of the response over its albedo */
} problem;

static double peak(const lobe_asg *asg)
{
    /* the integral where the peak is 1: a Gaussian over the unit disc, cut at its edge */
    double cut = 0;
    enum { TURNS = 64 };
    for (int i = 0; i < TURNS; i++) {
        const double turn = 0.5 * pi * (i + 0.5) / TURNS, x = cos(turn), y = sin(turn);
        cut -= expm1(-1 / (x * x / asg->x_sharpness + y * y / asg->y_sharpness)) / TURNS;
    }
    return asg->weight * sqrt(asg->x_sharpness * asg->y_sharpness) / (pi * cut);
}

static double shape_at(const lobe_asg *asg, const double d[3])
{
    const double s = sin(asg->angle), c = cos(asg->angle), z = d[2] * c - d[0] * s, x = d[0] * c + d[2] * s;
    return z > 0 ? z * exp(-asg->x_sharpness * x * x - asg->y_sharpness * d[1] * d[1]) : 0;
}

double lobe_asg_at(const lobe_asg *asg, const double d[3]) { return peak(asg) * shape_at(asg, d); }

/* Gauss-Legendre along the radius, even turns of the stretched circle, by the sampler. */
int lobe_asg_nodes(const lobe_asg *asg, int order, double *rows)
{
    double height[LOBE_GAUSS_MOST], weight[LOBE_GAUSS_MOST], s = sin(asg->angle), c = cos(asg->angle);
    const double top = peak(asg);
    lobe_gauss(order, height, weight);
    for (int i = 0; i < order; i++)
        for (int j = 0; j < order; j++) {
            const double x = height[i], part = 3 * x * x * weight[i] / order; /* cubed: many nodes for the tail */
            double e[3], density, *row = rows + 5 * (i * order + j);
            lobe_sample_asg(asg->x_sharpness, asg->y_sharpness, 1 - x * x * x, 0.5 * (j + 0.5) / order, e);
            density = lobe_sample_asg_density(asg->x_sharpness, asg->y_sharpness, e);
            row[0] = e[0] * c - e[2] * s;
            row[1] = e[1];
            row[2] = e[2] * c + e[0] * s;
            row[3] = part * top * shape_at(asg, row) / density;
            row[4] = 0.5 * part / density;
        }
    return order * order;
}

static lobe_asg asg_of(const double *x, double weight)
{
    const lobe_asg asg = {x[0], exp(x[1]), exp(x[2]), weight};
    return asg;
}

/* Weight 1: products with the response and with itself. */
static void products(const problem *p, const lobe_asg *asg, double *cross, double *own)
{
    double rows[5 * ORDER * ORDER];
    const double top = peak(asg);
    const int count = lobe_asg_nodes(asg, ORDER, rows);
    *cross = *own = 0;
    for (int i = 0; i < p->count; i++)
        *cross += p->nodes[5 * i + 3] * top * shape_at(asg, p->nodes + 5 * i);
    for (int i = 0; i < count; i++)
        *own += rows[5 * i + 3] * top * shape_at(asg, rows + 5 * i);
}

static double square_error(const problem *p, const double *x, double *weight)
{
    const lobe_asg asg = asg_of(x, 1);
    double cross, own;
    products(p, &asg, &cross, &own);
    *weight = p->energy ? 1 : cross / own;
    return 1 + (*weight * *weight * own - 2 * *weight * cross) / p->power;
}

static void objective(void *ctx, const double *params, size_t count, double *values)
{
    for (size_t i = 0; i < count; i++) {
        const double *x = params + 3 * i;
        const double out = fmax(0, fabs(x[0]) - 2) + fmax(0, fabs(x[1] - 4) - 8) + fmax(0, fabs(x[2] - 4) - 8);
        double weight;
        values[i] = out > 0 ? 10 + out : square_error(ctx, x, &weight);
    }
}

lobe_asg lobe_asg_fit(double alpha, double n_dot_v, int energy, double *error)
{
    static _Thread_local problem p;
    double x[3], simplex[12], albedo = 0, weight = 1, square;
    lobe_objective f = {.f = objective, .ctx = &p, .dim = 3};
    lobe_nm_options o = lobe_nm_default();
    p.alpha = alpha;
    p.n_dot_v = n_dot_v;
    p.energy = energy;
    p.power = 0;
    p.count = lobe_visible_nodes(alpha, n_dot_v, TARGET_ORDER, p.nodes);
    for (int i = 0; i < p.count; i++)
        albedo += p.nodes[5 * i + 3];
    for (int i = 0; i < p.count; i++) {
        p.nodes[5 * i + 3] /= albedo;
        p.power += p.nodes[5 * i + 3] * lobe_response(alpha, n_dot_v, p.nodes + 5 * i) / albedo;
    }
    x[0] = acos(n_dot_v);
    x[2] = log(1 / (4 * alpha * alpha));
    x[1] = x[2] - 2 * log(fmax(n_dot_v, 0.2));
    for (int i = 0; i < 12; i++)
        simplex[i] = x[i % 3] + (i / 3 == i % 3 + 1 ? (i % 3 ? 0.3 : 0.1 * alpha) : 0);
    o.simplex = simplex;
    o.starts = 1;
    o.restarts = 2;
    o.budget = 400;
    o.value_tolerance = 1e-7;
    o.size_tolerance = 1e-5;
    lobe_nelder_mead(&f, &o, x);
    square = square_error(&p, x, &weight);
    if (error)
        *error = sqrt(fmax(0, square));
    return asg_of(x, weight);
}

void lobe_asg_star_fit(lobe_asg_star *star)
{
    for (int i = 0; i < LOBE_ASG_POINTS; i++) {
        star->alpha[i] = lobe_judge_alpha[i / LOBE_JUDGE_VIEWS];
        star->n_dot_v[i] = lobe_judge_view[i % LOBE_JUDGE_VIEWS];
        star->asg[i] = lobe_asg_fit(star->alpha[i], star->n_dot_v[i], 1, NULL);
    }
}

int lobe_asg_star_nodes(const void *star, double alpha, double n_dot_v, double *rows)
{
    const lobe_asg_star *s = star;
    int i = 0;
    while (i < LOBE_ASG_POINTS - 1 && !(s->alpha[i] == alpha && s->n_dot_v[i] == n_dot_v))
        i++;
    return lobe_asg_nodes(&s->asg[i], ORDER, rows);
}
