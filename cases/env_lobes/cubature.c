#include "cubature.h"
#include <math.h>
#include <stdlib.h>
#include "gauss.h"
#include "visible_normals.h"

enum { NODES = 6, BOXES = 24 };
static const double pi = 3.14159265358979323846;

typedef struct work {
    lobe_sphere_fn *f;
    void *ctx;
    double node[NODES], weight[NODES], tolerance;
} work;

static double box(const work *w, double z, double dz, double phi, double dphi)
{
    double sum = 0;
    for (int i = 0; i < NODES; i++) {
        const double c = z + dz * w->node[i], s = sqrt(fmax(0, (1 - c) * (1 + c)));
        for (int j = 0; j < NODES; j++) {
            const double turn = phi + dphi * w->node[j], d[3] = {s * cos(turn), s * sin(turn), c};
            sum += w->weight[i] * w->weight[j] * w->f(w->ctx, d);
        }
    }
    return sum * dz * dphi;
}

static double refine(const work *w, double z, double dz, double phi, double dphi, double before, int depth)
{
    double part[4], sum = 0;
    for (int k = 0; k < 4; k++)
        sum += part[k] = box(w, z + (k / 2) * dz / 2, dz / 2, phi + (k % 2) * dphi / 2, dphi / 2);
    if (depth > 14 || fabs(sum - before) <= w->tolerance * sqrt(dz * dphi / (2 * pi)) / BOXES)
        return sum;
    sum = 0;
    for (int k = 0; k < 4; k++)
        sum += refine(w, z + (k / 2) * dz / 2, dz / 2, phi + (k % 2) * dphi / 2, dphi / 2, part[k], depth + 1);
    return sum;
}

double lobe_cubature(lobe_sphere_fn *f, void *ctx, double tolerance)
{
    work w;
    double sum = 0;
    w.f = f;
    w.ctx = ctx;
    w.tolerance = tolerance;
    lobe_gauss(NODES, w.node, w.weight);
    for (int i = 0; i < BOXES; i++)
        for (int j = 0; j < BOXES; j++) {
            const double dz = 2.0 / BOXES, z = -1 + dz * i, dphi = pi / BOXES, phi = dphi * j;
            sum += refine(&w, z, dz, phi, dphi, box(&w, z, dz, phi, dphi), 0);
        }
    return 2 * sum;
}

double lobe_visible_integral(double alpha, double n_dot_v, int order, lobe_sphere_fn *f, void *ctx)
{
    double *nodes = malloc(sizeof *nodes * 5 * (size_t)order * (size_t)order), sum = 0;
    const int count = nodes ? lobe_visible_nodes(alpha, n_dot_v, order, nodes) : 0;
    for (int i = 0; i < count; i++)
        sum += nodes[5 * i + 3] * f(ctx, nodes + 5 * i);
    free(nodes);
    return sum;
}
