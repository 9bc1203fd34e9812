/* Uniform sampling that misses narrow lobes, and what noise in the objective does, against samples where the lobes are:
 * visible normals, and a mixture of those with the model's own lobes under the balance heuristic. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../../env_lobes/response.h"
#include "../../env_lobes/visible_normals.h"
#include "experiment.h"

enum { MOST_SAMPLES = 65536, SEEDS = 40, FITS = 8 };
static const double pi = 3.14159265358979323846;

typedef enum strategy { UNIFORM, VISIBLE, MIXED, STRATEGIES } strategy;
static const char *const strategy_name[STRATEGIES] = {"uniform", "visible normals", "mixture"};

typedef struct sampler {
    const lobe_sg_target *target;
    strategy how;
    int samples;
    bool fresh; /* new ones for every evaluation */
    lobe_random random;
    double *l;               /* directions that stay, unless fresh, */
    const lobe_sg *proposal; /* and the lobes that they were drawn from */
} sampler;

/* A direction about a lobe's axis with its density, by inverting the integral over the cosine. */
static void sample_sg(const lobe_sg *lobe, lobe_random *random, double l[3])
{
    const double c = 1 + log1p(lobe_random_unit(random) * expm1(-2 * lobe->sharpness)) / lobe->sharpness;
    const double turn = 2 * pi * lobe_random_unit(random), s = sqrt(fmax(0, (1 - c) * (1 + c)));
    const double x = s * cos(turn), co = cos(lobe->angle), si = -sin(lobe->angle);
    l[0] = co * x + si * c;
    l[1] = s * sin(turn);
    l[2] = co * c - si * x;
}

static void draw(const sampler *s, const lobe_sg *lobes, int count, lobe_random *random, double l[3])
{
    const double pick = lobe_random_unit(random), a = lobe_random_unit(random), b = lobe_random_unit(random);
    if (s->how == UNIFORM) {
        const double sine = sqrt((1 - a) * (1 + a));
        l[0] = sine * cos(2 * pi * b);
        l[1] = sine * sin(2 * pi * b);
        l[2] = a;
    } else if (s->how == VISIBLE || pick < 0.5) {
        lobe_visible_light(s->target->alpha, s->target->n_dot_v, a, b, l);
    } else {
        double rest = (2 * pick - 1) * s->target->albedo;
        int i = 0;
        while (i < count - 1 && rest > lobes[i].weight)
            rest -= lobes[i++].weight;
        sample_sg(&lobes[i], random, l);
    }
}

static double density(const sampler *s, const lobe_sg *lobes, int count, const double l[3])
{
    double visible, own = 0;
    int i;
    if (s->how == UNIFORM)
        return 1 / (2 * pi);
    visible = lobe_visible_light_density(s->target->alpha, s->target->n_dot_v, l);
    if (s->how == VISIBLE)
        return visible;
    for (i = 0; i < count; i++)
        own += lobe_sg_at(&lobes[i], l);
    return 0.5 * visible + 0.5 * own / s->target->albedo;
}

/* The relative L2 error by samples; the norm of the response is known, so that only the difference is noisy. */
static double estimate(void *ctx, const lobe_sg *lobes, int count)
{
    sampler *s = ctx;
    double sum = 0;
    int i, k;
    for (i = 0; i < s->samples; i++) {
        double l[3], p, difference;
        if (s->fresh)
            draw(s, lobes, count, &s->random, l);
        else
            memcpy(l, s->l + 3 * i, sizeof l);
        p = density(s, s->fresh ? lobes : s->proposal, count, l);
        difference = lobe_response(s->target->alpha, s->target->n_dot_v, l);
        for (k = 0; k < count; k++)
            difference -= lobe_sg_at(&lobes[k], l);
        if (p > 0)
            sum += difference * difference / p;
    }
    return sqrt(sum / s->samples / s->target->power);
}

/* Whether none of uniform samples comes near the lobe: where the response is above a tenth of its largest. */
static bool misses(const sampler *s, double peak)
{
    int i;
    for (i = 0; i < s->samples; i++)
        if (lobe_response(s->target->alpha, s->target->n_dot_v, s->l + 3 * i) > 0.1 * peak)
            return false;
    return true;
}

static double peak_of(const lobe_sg_target *t)
{
    double peak = 0;
    size_t i;
    for (i = 0; i < t->count; i++)
        peak = fmax(peak, lobe_response(t->alpha, t->n_dot_v, t->nodes + 4 * i));
    return peak;
}

static int by_value(const void *a, const void *b)
{
    return (*(const double *)a > *(const double *)b) - (*(const double *)a < *(const double *)b);
}

/* Fits a fan on samples that stay (or are fresh) and returns its median true error over seeds. */
static double fitted(const lobe_shape_fit *fit, sampler *s, int seeds)
{
    lobe_shape_fit sampled = *fit;
    double errors[FITS], x[LOBE_EXPERIMENT_MOST], true_error;
    int seed, i;
    sampled.estimate = estimate;
    sampled.estimate_ctx = s;
    for (seed = 0; seed < seeds; seed++) {
        lobe_sg start[LOBE_SG_MOST];
        lobe_shape_start(fit, x);
        lobe_shape_lobes(fit, x, start);
        s->proposal = start;
        lobe_random_seed(&s->random, 21, (uint64_t)seed);
        for (i = 0; !s->fresh && i < s->samples; i++)
            draw(s, start, fit->count, &s->random, s->l + 3 * i);
        lobe_shape_nelder_mead(&sampled, 250, x);
        lobe_shape_errors((void *)fit, x, 1, &true_error);
        errors[seed] = true_error;
    }
    qsort(errors, (size_t)seeds, sizeof *errors, by_value);
    return 0.5 * (errors[(seeds - 1) / 2] + errors[seeds / 2]);
}

bool lobe_experiment_sampling(FILE *out)
{
    static const double alphas[] = {0.04, 0.1, 0.3, 1};
    static const int samples[] = {64, 256, 1024, 4096};
    double *l = malloc(sizeof *l * 3 * MOST_SAMPLES);
    size_t a, n;
    fputs("alpha,n_dot_v,strategy,samples,missed,objective_rms,fitted_error,best_error\n", out);
    for (a = 0; l && a < sizeof alphas / sizeof alphas[0]; a++) {
        lobe_sg_target target;
        lobe_shape_fit fit = {.target = &target, .count = 4};
        double x[LOBE_EXPERIMENT_MOST], best;
        lobe_sg lobes[LOBE_SG_MOST];
        int how, seed, i;
        if (!lobe_sg_target_make(&target, alphas[a], 0.5, 32)) {
            free(l);
            return false;
        }
        lobe_shape_start(&fit, x);
        best = lobe_shape_nelder_mead(&fit, 600, x).value;
        lobe_shape_lobes(&fit, x, lobes);
        for (how = 0; how < STRATEGIES; how++)
            for (n = 0; n < sizeof samples / sizeof samples[0]; n++) {
                sampler s = {.target = &target, .how = (strategy)how, .samples = samples[n], .l = l, .proposal = lobes};
                const double peak = peak_of(&target);
                double square = 0;
                int missed = 0;
                for (seed = 0; seed < SEEDS; seed++) {
                    double e;
                    lobe_random_seed(&s.random, 20, (uint64_t)seed);
                    for (i = 0; i < s.samples; i++)
                        draw(&s, lobes, fit.count, &s.random, l + 3 * i);
                    missed += misses(&s, peak);
                    e = estimate(&s, lobes, fit.count) / best - 1;
                    square += e * e;
                }
                fprintf(out, "%g,%g,%s,%d,%.3f,%.4f,%.4f,%.4f\n", alphas[a], 0.5, strategy_name[how], samples[n],
                        (double)missed / SEEDS, sqrt(square / SEEDS), fitted(&fit, &s, samples[n] < 4096 ? FITS : 2),
                        best);
            }
        lobe_sg_target_free(&target);
    }
    free(l);
    return l != NULL;
}

bool lobe_experiment_noise(FILE *out)
{
    static const int samples[] = {16, 64, 256, 1024, 4096};
    double *l = malloc(sizeof *l * 3 * MOST_SAMPLES), x[LOBE_EXPERIMENT_MOST], best;
    lobe_sg lobes[LOBE_SG_MOST];
    lobe_sg_target target;
    lobe_shape_fit fit = {.target = &target, .count = 4};
    size_t n;
    int seed;
    if (!l || !lobe_sg_target_make(&target, 0.2, 0.3, 32)) {
        free(l);
        return false;
    }
    lobe_shape_start(&fit, x);
    best = lobe_shape_nelder_mead(&fit, 600, x).value;
    lobe_shape_lobes(&fit, x, lobes);
    fputs("samples,objective_rms,fitted_fresh,fitted_frozen,fitted_quadrature\n", out);
    for (n = 0; n < sizeof samples / sizeof samples[0]; n++) {
        const int seeds = samples[n] > 1000 ? 4 : FITS;
        sampler s = {.target = &target, .how = MIXED, .samples = samples[n], .fresh = true, .l = l};
        double square = 0, fresh, frozen;
        for (seed = 0; seed < SEEDS; seed++) {
            double e;
            lobe_random_seed(&s.random, 22, (uint64_t)seed);
            e = estimate(&s, lobes, fit.count) / best - 1;
            square += e * e;
        }
        fresh = fitted(&fit, &s, seeds);
        s.fresh = false;
        frozen = fitted(&fit, &s, seeds);
        fprintf(out, "%d,%.4f,%.4f,%.4f,%.4f\n", samples[n], sqrt(square / SEEDS), fresh, frozen, best);
    }
    lobe_sg_target_free(&target);
    free(l);
    return true;
}
