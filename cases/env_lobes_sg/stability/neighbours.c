/* Fits along n_dot_v whose lobes do not match their neighbours': what a table between its nodes then is, and what
 * ordering, warm starts and the two layers do. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../layers.h"
#include "experiment.h"

enum { NODES = 14, LOBES = 4, COLUMNS = 3 * LOBES };

typedef enum method { INDEPENDENT, ORDERED, WARM, FAN, METHODS } method;
static const char *const method_name[METHODS] = {"random starts", "random starts then ordered", "warm starts",
                                                 "two layers"};

static double v_of(double node) { return fmin(1, 0.1 + 0.9 * node / (NODES - 1)); }

static int by_angle(const void *a, const void *b)
{
    const lobe_sg *p = a, *q = b;
    return (p->angle > q->angle) - (p->angle < q->angle);
}

/* Lobes as what a table would hold, and as what a shader makes of it between two nodes. */
static void pack(const lobe_sg *lobes, double albedo, double *row)
{
    int i;
    for (i = 0; i < LOBES; i++) {
        row[3 * i] = lobes[i].angle;
        row[3 * i + 1] = log(lobes[i].sharpness);
        row[3 * i + 2] = lobes[i].weight / albedo;
    }
}

static void unpack(const double *row, double albedo, lobe_sg *lobes)
{
    int i;
    for (i = 0; i < LOBES; i++) {
        lobes[i].angle = row[3 * i];
        lobes[i].sharpness = exp(row[3 * i + 1]);
        lobes[i].weight = row[3 * i + 2] * albedo;
    }
}

/* The best of some starts. */
static double solve(method how, const lobe_sg_target *target, const lobe_sg_target *before, uint64_t seed, double *x)
{
    const lobe_shape_fit fit = {.target = target, .count = LOBES, .free = how != FAN};
    double tried[LOBE_EXPERIMENT_MOST], best = 20;
    lobe_random random;
    int i;
    lobe_random_seed(&random, 41, seed);
    for (i = 0; i < (how == INDEPENDENT || how == ORDERED ? 6 : 1); i++) {
        double value;
        if (how == FAN)
            lobe_shape_start(&fit, tried);
        else if (how == WARM && before) {
            int k;
            memcpy(tried, x, sizeof tried);
            for (k = 0; k < LOBES; k++) /* the neighbour's lobes, turned with the mirror direction */
                tried[3 * k] += acos(target->n_dot_v) - acos(before->n_dot_v);
        } else if (how == WARM)
            lobe_shape_start(&fit, tried);
        else
            lobe_shape_random(&fit, &random, tried);
        value = lobe_shape_nelder_mead(&fit, how == FAN ? 1500 : 6000, tried).value;
        if (value < best) {
            best = value;
            memcpy(x, tried, sizeof tried);
        }
    }
    return best;
}

static bool targets(double alpha, lobe_sg_target *node, lobe_sg_target *middle)
{
    int i;
    for (i = 0; i < NODES; i++)
        if (!lobe_sg_target_make(&node[i], alpha, v_of(i), 28) ||
            (i + 1 < NODES && !lobe_sg_target_make(&middle[i], alpha, v_of(i + 0.5), 28)))
            return false;
    return true;
}

/* Root mean squares of the errors at the nodes and between them, and of the second differences of the angles. */
static void judge(FILE *out, double alpha, const char *name, double rows[NODES][COLUMNS], const lobe_sg_target *node,
                  const lobe_sg_target *middle)
{
    double at = 0, between = 0, worst = 0, bend = 0;
    lobe_sg lobes[LOBES];
    int i, k;
    for (i = 0; i < NODES; i++) {
        double error;
        unpack(rows[i], node[i].albedo, lobes);
        error = lobe_sg_target_error(&node[i], lobes, LOBES);
        at += error * error / NODES;
        if (i + 1 < NODES) {
            double mean[COLUMNS];
            for (k = 0; k < COLUMNS; k++)
                mean[k] = 0.5 * (rows[i][k] + rows[i + 1][k]);
            unpack(mean, middle[i].albedo, lobes);
            error = lobe_sg_target_error(&middle[i], lobes, LOBES);
            between += error * error / (NODES - 1);
            worst = fmax(worst, error);
        }
        for (k = 0; i > 0 && i + 1 < NODES && k < LOBES; k++) {
            const double second = rows[i - 1][3 * k] - 2 * rows[i][3 * k] + rows[i + 1][3 * k];
            bend += second * second / ((NODES - 2) * LOBES);
        }
    }
    fprintf(out, "%g,%s,%.4f,%.4f,%.4f,%.4f", alpha, name, sqrt(at), sqrt(between), worst, sqrt(bend));
    for (i = 0; i < NODES; i++)
        for (k = 0; k < LOBES; k++)
            fprintf(out, ",%.3f", rows[i][3 * k]);
    fputc('\n', out);
}

bool lobe_experiment_neighbours(FILE *out)
{
    static const double alphas[] = {0.1, 0.3};
    size_t a;
    fputs("# the columns after bend: the angles of the 4 lobes at each of 14 n_dot_v from .1 to 1\n", out);
    fputs("alpha,method,rms_at_nodes,rms_between,worst_between,bend,angles\n", out);
    for (a = 0; a < sizeof alphas / sizeof alphas[0]; a++) {
        lobe_sg_target node[NODES], middle[NODES];
        double rows[NODES][COLUMNS];
        int how, i;
        if (!targets(alphas[a], node, middle))
            return false;
        for (how = 0; how < METHODS; how++) {
            double x[LOBE_EXPERIMENT_MOST];
            for (i = 0; i < NODES; i++) {
                const lobe_shape_fit fit = {.target = &node[i], .count = LOBES, .free = how != FAN};
                lobe_sg lobes[LOBE_SG_MOST];
                solve((method)how, &node[i], i ? &node[i - 1] : NULL, (uint64_t)i, x);
                lobe_shape_lobes(&fit, x, lobes);
                if (how == ORDERED)
                    qsort(lobes, LOBES, sizeof *lobes, by_angle);
                pack(lobes, node[i].albedo, rows[i]);
            }
            judge(out, alphas[a], method_name[how], rows, node, middle);
        }
        for (i = 0; i < NODES; i++) {
            lobe_sg_target_free(&node[i]);
            if (i + 1 < NODES)
                lobe_sg_target_free(&middle[i]);
        }
    }
    return true;
}
