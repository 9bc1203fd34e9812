#include "judge_points.h"
#include <math.h>
#include <stdlib.h>
#include "random.h"

enum { SIDE = 1024, RANDOM = 1 << 17, LOG_SIDE = 320, VECTORS = 512, SEED = 3 };

double lobe_judge_exact(double x) { return floor(x * 16777216 + 0.5) / 16777216; }

static void add(lobe_judge_points *p, double roughness, double n_dot_v)
{
    p->at[2 * p->count] = roughness;
    p->at[2 * p->count + 1] = n_dot_v;
    p->count++;
}

/* The domain's own end rounds into it. */
static double inside(double x) { return fmax(lobe_judge_exact(x), ceil(LOBE_JUDGE_LO * 16777216) / 16777216); }

static void add_vectors(lobe_judge_points *p, const lobe_case *c, int below)
{
    if (c->vectors)
        p->count += c->vectors->points(LOBE_JUDGE_LO, below, c->vectors->seed, p->at + 2 * p->count, VECTORS);
}

lobe_judge_points lobe_judge_inside(const lobe_case *c)
{
    lobe_judge_points p = {malloc(sizeof(double) * 2 * (SIDE * SIDE + RANDOM + VECTORS)), 0, 0};
    const double span = 1 - LOBE_JUDGE_LO;
    lobe_random random;
    int i, k;
    if (!p.at)
        return p;
    for (i = 0; i < SIDE; i++)
        for (k = 0; k < SIDE; k++)
            add(&p, inside(LOBE_JUDGE_LO + span * i / (SIDE - 1)), inside(LOBE_JUDGE_LO + span * k / (SIDE - 1)));
    p.uniform = p.count;
    lobe_random_seed(&random, SEED, 0);
    for (i = 0; i < RANDOM; i++) {
        const double r = lobe_random_unit(&random), v = lobe_random_unit(&random);
        add(&p, inside(LOBE_JUDGE_LO + span * r * r), inside(LOBE_JUDGE_LO + span * v * v));
    }
    add_vectors(&p, c, 0);
    return p;
}

lobe_judge_points lobe_judge_below(const lobe_case *c)
{
    lobe_judge_points p = {malloc(sizeof(double) * 2 * (LOG_SIDE * LOG_SIDE + VECTORS)), 0, 0};
    double step[LOG_SIDE];
    int i, k;
    if (!p.at)
        return p;
    for (i = 0; i < LOG_SIDE; i++) {
        const double x = lobe_judge_exact(LOBE_JUDGE_LEAST * pow(1 / LOBE_JUDGE_LEAST, i / (LOG_SIDE - 1.0)));
        step[i] = fmin(1, fmax(x, ceil(LOBE_JUDGE_LEAST * 16777216) / 16777216));
    }
    for (i = 0; i < LOG_SIDE; i++)
        for (k = 0; k < LOG_SIDE; k++)
            if (step[i] < LOBE_JUDGE_LO || step[k] < LOBE_JUDGE_LO)
                add(&p, step[i], step[k]);
    add_vectors(&p, c, 1);
    return p;
}
