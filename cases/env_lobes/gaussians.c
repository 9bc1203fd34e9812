#define LOBE_DOUBLE 1
#include "gaussians.h"
#include <math.h>
#include "../../models/env_lobes_sg.h"
#include "gauss.h"
#include "samplers.h"

enum { ORDER = 20, MOST = 8 };

/* Gauss-Legendre in what the sampler takes, even turns. */
int lobe_gaussian_nodes(double angle, double sharpness, int order, double *rows)
{
    double height[LOBE_GAUSS_MOST], weight[LOBE_GAUSS_MOST];
    const double s = sin(angle), c = cos(angle);
    lobe_gauss(order, height, weight);
    for (int i = 0; i < order; i++)
        for (int j = 0; j < order; j++) {
            const double x = height[i], part = 3 * x * x * weight[i] / order; /* cubed: many nodes for the tail */
            double e[3], *row = rows + 5 * (i * order + j);
            lobe_sample_sg(sharpness, 1 - x * x * x, 0.5 * (j + 0.5) / order, e);
            row[0] = e[0] * c - e[2] * s;
            row[1] = e[1];
            row[2] = e[2] * c + e[0] * s;
            row[3] = part;
            row[4] = 0.5 * part / lobe_sample_sg_density(sharpness, e[2]);
        }
    return order * order;
}

static int nodes(const void *ctx, double alpha, double n_dot_v, double *rows)
{
    const int *count = ctx;
    const double r = sqrt(alpha), v = n_dot_v;
    lobe_env_tap tap[MOST];
    int n = 0;
    if (*count == 1) {
        tap[0] = lobe_env_lobes_sg_lobes1(r, v, 1);
    } else if (*count == 2) {
        const lobe_env_sg2 f = lobe_env_lobes_sg_lobes2(r, v, 1);
        tap[0] = f.t0, tap[1] = f.t1;
    } else if (*count == 4) {
        const lobe_env_sg4 f = lobe_env_lobes_sg_lobes4(r, v, 1);
        tap[0] = f.t0, tap[1] = f.t1, tap[2] = f.t2, tap[3] = f.t3;
    } else {
        const lobe_env_sg8 f = lobe_env_lobes_sg_lobes8(r, v, 1);
        tap[0] = f.t0, tap[1] = f.t1, tap[2] = f.t2, tap[3] = f.t3;
        tap[4] = f.t4, tap[5] = f.t5, tap[6] = f.t6, tap[7] = f.t7;
    }
    for (int i = 0; i < *count; i++) {
        const int more = lobe_gaussian_nodes(tap[i].angle, tap[i].width, ORDER, rows + 5 * n);
        for (int k = n; k < n + more; k++)
            rows[5 * k + 3] *= tap[i].weight;
        n += more;
    }
    return n;
}

static const int counts[LOBE_GAUSSIANS] = {1, 2, 4, 8};
const lobe_judge_model lobe_gaussian[LOBE_GAUSSIANS] = {
    {"sg lobes1", NULL, nodes, &counts[0]},
    {"sg lobes2", NULL, nodes, &counts[1]},
    {"sg lobes4", NULL, nodes, &counts[2]},
    {"sg lobes8", NULL, nodes, &counts[3]},
};
