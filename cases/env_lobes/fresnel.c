#define LOBE_DOUBLE 1
#include "fresnel.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../../models/env_fresnel.h"
#include "../fit/parallel.h"
#include "kernels.h"
#include "response.h"
#include "visible_normals.h"

enum { ORDER = 80, SAMPLES = LOBE_JUDGE_ORIENTATIONS, WAYS = LOBE_FRESNEL_WAYS, F0S = LOBE_FRESNEL_F0S };

const double lobe_fresnel_f0[F0S] = {1, .5, .2, .04, .02};
const char *const lobe_fresnel_name[WAYS] = {"factor", "quotient", "per tap"};

typedef struct job {
    const lobe_orientations *orientations;
    const lobe_judge_model *models;
    int count;
} job;

/* Truth over the albedo, all of it and f90's part, in every orientation. */
typedef struct truth {
    double all[SAMPLES], grazing[SAMPLES], share; /* share: bias over albedo */
} truth;

static void make_truth(const job *j, double alpha, double n_dot_v, double *nodes, truth *t)
{
    const int count = lobe_visible_nodes(alpha, n_dot_v, ORDER, nodes);
    const double sine = sqrt((1 - n_dot_v) * (1 + n_dot_v));
    double albedo = 0;
    for (int i = 0; i < count; i++)
        albedo += nodes[5 * i + 3];
    for (int i = 0; i < count; i++) {
        nodes[5 * i + 3] /= albedo;
        nodes[5 * i + 4] = lobe_blurred_cubes_level(nodes[5 * i + 4]);
    }
    lobe_orientations_integrate(j->orientations, nodes, count, t->all);
    t->share = 0;
    for (int i = 0; i < count; i++) {
        double *q = nodes + 5 * i;
        const double x = 1 - sqrt(fmax(0, 0.5 * (1 + sine * q[0] + n_dot_v * q[2])));
        q[3] *= (x * x) * (x * x) * x;
        t->share += q[3];
    }
    lobe_orientations_integrate(j->orientations, nodes, count, t->grazing);
}

/* What every tap is multiplied with. */
static void weigh(lobe_fresnel_way way, double f0, double share, double n_dot_v, const lobe_cell_tap *taps, int count,
                  double *factor)
{
    double grazing[LOBE_CELL_TAPS], mean = 0;
    for (int i = 0; i < count; i++) {
        const double width = sqrt(lobe_prefilter_alpha_of_t(exp(taps[i].log_t)));
        grazing[i] = lobe_env_grazing(cos(acos(n_dot_v) + taps[i].angle), way == LOBE_FRESNEL_QUOTIENT ? 0 : width);
        mean += taps[i].weight * grazing[i];
    }
    for (int i = 0; i < count; i++) {
        factor[i] = f0 + (1 - f0) * share;
        if (way == LOBE_FRESNEL_QUOTIENT)
            factor[i] *= (f0 + (1 - f0) * grazing[i]) / (f0 + (1 - f0) * mean);
        else if (way == LOBE_FRESNEL_SHIPPED)
            factor[i] = f0 + (1 - f0) * lobe_env_bias(1, grazing[i], mean, share);
    }
}

/* Square errors, relative and rms, of one model: out[way][f0][2]. */
static void judge_model(const job *j, const lobe_judge_model *model, double alpha, double n_dot_v, const truth *t,
                        double *out)
{
    lobe_cell_tap taps[LOBE_CELL_TAPS];
    double seen[LOBE_CELL_TAPS][SAMPLES], factor[LOBE_CELL_TAPS];
    const int count = model->taps(model->ctx, alpha, n_dot_v, taps);
    for (int i = 0; i < count; i++)
        lobe_orientations_tap(j->orientations, taps[i].angle, exp(taps[i].log_t), seen[i], NULL, NULL);
    for (int k = 0; k < WAYS * F0S; k++) {
        const double f0 = lobe_fresnel_f0[k % F0S];
        double relative = 0, square = 0, all = 0;
        weigh((lobe_fresnel_way)(k / F0S), f0, t->share, n_dot_v, taps, count, factor);
        for (int s = 0; s < SAMPLES; s++) {
            const double want = f0 * t->all[s] + (1 - f0) * t->grazing[s];
            double off = -want;
            for (int i = 0; i < count; i++)
                off += taps[i].weight * factor[i] * seen[i][s];
            relative += off / want * (off / want) / SAMPLES;
            square += off * off;
            all += want * want;
        }
        out[2 * k] = relative;
        out[2 * k + 1] = square / all;
    }
}

/* A column for every model, way, f0 and error, and one that tells whether there was memory. */
static size_t columns(const job *j) { return 2 * WAYS * F0S * (size_t)j->count + 1; }

static void ask(void *ctx, const double *params, size_t count, double *values)
{
    const job *j = ctx;
    double *nodes = malloc(sizeof *nodes * 5 * ORDER * ORDER);
    for (size_t i = 0; i < count; i++) {
        const int c = (int)params[i];
        const double alpha = lobe_judge_alpha[c / LOBE_JUDGE_VIEWS], v = lobe_judge_view[c % LOBE_JUDGE_VIEWS];
        double *out = values + i * columns(j);
        truth t;
        out[columns(j) - 1] = nodes != NULL;
        if (!nodes)
            continue;
        make_truth(j, alpha, v, nodes, &t);
        for (int m = 0; m < j->count; m++)
            judge_model(j, &j->models[m], alpha, v, &t, out + (size_t)m * 2 * WAYS * F0S);
    }
    free(nodes);
}

bool lobe_fresnel_judge(const lobe_environment *map, const lobe_judge_options *options, const lobe_judge_model *models,
                        int count, lobe_judge_error errors[LOBE_FRESNEL_WAYS][LOBE_FRESNEL_F0S][LOBE_FRESNEL_MODELS])
{
    lobe_orientations *orientations = lobe_orientations_new(map, 1, SAMPLES, options->seed, options->threads);
    job j = {orientations, models, count};
    double number[LOBE_JUDGE_CELLS], *square = malloc(sizeof *square * LOBE_JUDGE_CELLS * columns(&j));
    lobe_parallel parallel = {ask, &j, 1, columns(&j), (size_t)options->threads};
    bool good = orientations && square;
    for (int c = 0; c < LOBE_JUDGE_CELLS; c++)
        number[c] = c;
    if (good)
        lobe_parallel_eval(&parallel, number, LOBE_JUDGE_CELLS, square);
    for (int c = 0; good && c < LOBE_JUDGE_CELLS; c++)
        good = square[(size_t)(c + 1) * columns(&j) - 1] != 0;
    for (int k = 0; good && k < WAYS * F0S * count; k++) {
        const int m = k / (WAYS * F0S), way = k / F0S % WAYS, f = k % F0S;
        double sum[2] = {0, 0};
        for (int c = 0; c < 2 * LOBE_JUDGE_CELLS; c++)
            sum[c % 2] += square[(size_t)(c / 2) * columns(&j) + 2 * (size_t)k + (size_t)(c % 2)] / LOBE_JUDGE_CELLS;
        errors[way][f][m].relative = sqrt(sum[0]);
        errors[way][f][m].rms = sqrt(sum[1]);
    }
    free(square);
    lobe_orientations_free(orientations);
    return good;
}
