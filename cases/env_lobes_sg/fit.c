/* Surfaces by Newton's method, straight from the analytic start: the constant of every quantity is set, and the rest of
 * its coefficients grow from 0. */
#include "fit.h"
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "../fit/coefficients.h"
#include "../fit/fit_command.h"
#include "../fit/interrupt.h"
#include "layers.h"
#include "lights.h"
#include "newton.h"
#include "scenes.h"

enum { ROUNDS = 60 };
#define SHAPE 0.02
#define DEEPEST 2.0 /* radians from the normal, on the view's side */
#define DEPTH_PRICE 0.003

typedef struct problem {
    const lobe_sg_scenes *scenes;
    int count;
    unsigned held;
} problem;

/* Four lobes fall into a poor minimum, one of them wide and straight under the surface; with this they are better in
 * radiance and shape. Eight find their way, and other counts never go there. */
static double depth_price(const problem *p, const lobe_sg *lobes)
{
    double sum = 0;
    int i;
    if (p->count != 4 || p->held)
        return 0;
    for (i = 0; i < p->count; i++) {
        const double under = fmax(0, -DEEPEST - lobes[i].angle);
        sum += DEPTH_PRICE * under * under;
    }
    return sum;
}

static double value(const void *ctx, size_t point, const double *quantity)
{
    const problem *p = ctx;
    const lobe_sg_scene *s = &p->scenes->scene[point];
    double q[LOBE_SG_QUANTITIES];
    lobe_sg lobes[LOBE_SG_MOST];
    int i;
    for (i = 0; i < lobe_sg_quantities(p->count); i++)
        q[i] = p->held >> i & 1 ? 0 : quantity[i];
    lobe_sg_lobes_of(s->target.alpha, s->target.n_dot_v, q, p->count, s->target.albedo, lobes);
    if (p->held & LOBE_SG_PRINTED)
        lobe_sg_weigh_printed(lobes, p->count, s->target.albedo);
    return lobe_sg_scene_error(s, lobes, p->count) + depth_price(p, lobes);
}

typedef struct tried {
    const double *c;
    int count;
    unsigned held;
} tried;

static int lobes_of(const void *ctx, double alpha, double n_dot_v, double energy, lobe_sg *lobes)
{
    const tried *t = ctx;
    lobe_sg_lobes_at(alpha, n_dot_v, t->c, t->count, energy, lobes);
    if (t->held & LOBE_SG_PRINTED)
        lobe_sg_weigh_printed(lobes, t->count, energy);
    return t->count;
}

static bool progress(void *ctx, int round, double sum)
{
    const lobe_sweep_options *sweep = ctx;
    if (sweep->progress)
        fprintf(stderr, "  round %d of at most %d: %.5f\n", round, (int)ROUNDS, sqrt(sum / LOBE_SG_FIT_POINTS));
    return !lobe_interrupt_requested();
}

static void start(int count, double *c)
{
    memset(c, 0, sizeof *c * LOBE_SG_COEFFICIENTS);
    c[LOBE_SG_LEVEL * LOBE_SG_FEATURES] = count > 2 ? 2.5 : count == 2 ? 0 : -0.8;
    c[LOBE_SG_LEVEL * LOBE_SG_FEATURES + 1] = 1;
    c[LOBE_SG_SPREAD * LOBE_SG_FEATURES] = count > 2 ? 2.5 : 0.8;
    c[LOBE_SG_TILT * LOBE_SG_FEATURES] = -0.3;
    c[LOBE_SG_RIM * LOBE_SG_FEATURES] = 0.02;
    c[LOBE_SG_TAPER * LOBE_SG_FEATURES] = 1;
    c[LOBE_SG_FLARE * LOBE_SG_FEATURES] = 4;
}

static bool solve(const lobe_sweep_options *sweep, const problem *p, double *c)
{
    double features[LOBE_SG_FIT_POINTS * LOBE_SG_FEATURES], sum;
    const lobe_newton newton = {.value = value,
                                .ctx = p,
                                .points = p->scenes->count,
                                .quantities = lobe_sg_quantities(p->count),
                                .features = LOBE_SG_FEATURES,
                                .feature = features,
                                .step = 0.03,
                                .ridge = 1e-6,
                                .rounds = ROUNDS,
                                .threads = sweep->threads,
                                .progress = progress,
                                .progress_ctx = (void *)sweep};
    size_t i;
    for (i = 0; i < p->scenes->count; i++)
        lobe_sg_features(p->scenes->scene[i].target.alpha, p->scenes->scene[i].target.n_dot_v,
                         features + i * LOBE_SG_FEATURES);
    start(p->count, c);
    return lobe_newton_run(&newton, c, &sum);
}

int lobe_env_sg_solve(int count, unsigned held, const lobe_sweep_options *sweep, double *c, double *radiance,
                      double *shape)
{
    lobe_env_spectrum spectra[LOBE_SG_TRAINING];
    lobe_sg_scenes scenes = {0};
    const problem p = {&scenes, count, held};
    int i;
    bool good = lobe_sg_lights_train(spectra) &&
                lobe_sg_scenes_make(&scenes, false, spectra, LOBE_SG_TRAINING, SHAPE, sweep->threads) &&
                solve(sweep, &p, c);
    for (i = 0; good && i < lobe_sg_quantities(count) * LOBE_SG_FEATURES; i++)
        c[i] = held >> (i / LOBE_SG_FEATURES) & 1 ? 0 : lobe_coefficient_rounded(c[i]);
    *radiance =
        good ? lobe_sg_scenes_error(&scenes, spectra, LOBE_SG_TRAINING, lobes_of, &(tried){c, count, held}, NULL, shape)
             : -1;
    lobe_sg_scenes_free(&scenes);
    return *radiance < 0 ? 2 : lobe_interrupt_requested();
}

static bool fit_tier(const lobe_case *self, const lobe_fit_request *request, int count)
{
    lobe_coefficients out = {0};
    char tier[16], kernel[64], error[200];
    double c[LOBE_SG_COEFFICIENTS], radiance, shape = 0;
    const int status = lobe_env_sg_solve(count, 0, &request->sweep, c, &radiance, &shape);
    if (status) {
        fprintf(stderr, "lobefit: fit env_lobes_sg lobes%d: %s; the old coefficients stand\n", count,
                status == 1 ? "interrupted" : "not enough memory");
        return false;
    }
    snprintf(tier, sizeof tier, "lobes%d", count);
    snprintf(kernel, sizeof kernel, "lobe_env_lobes_sg_lobes%d", count);
    snprintf(error, sizeof error,
             "on that grid and those environments: radiance %.4f, shape %.4f, root mean squares, relative,\n"
             " *          in double",
             radiance, shape);
    out.model = "env_lobes_sg";
    out.tier = tier;
    out.brdf = self->brdf;
    out.domain = "alpha .04 to 1, n_dot_v .05 to 1";
    out.grid = "9 x 9, 6 environments in all orientations: cases/env_lobes_sg/scenes.c, lights.c";
    out.metric = "relative mean square error of radiance, and .02 of that of the shape; cases/env_lobes_sg/radiance.h";
    out.error = error;
    out.seed = 11;
    out.kernel = kernel;
    out.source = "models/env_lobes_sg.h";
    out.values = c;
    out.count = (size_t)lobe_sg_quantities(count) * LOBE_SG_FEATURES;
    return lobe_coefficients_write(&out, request->coeffs);
}

static bool fit1(const lobe_case *self, const lobe_fit_request *request) { return fit_tier(self, request, 1); }
static bool fit2(const lobe_case *self, const lobe_fit_request *request) { return fit_tier(self, request, 2); }
static bool fit4(const lobe_case *self, const lobe_fit_request *request) { return fit_tier(self, request, 4); }
static bool fit8(const lobe_case *self, const lobe_fit_request *request) { return fit_tier(self, request, 8); }

int lobe_env_sg_fit(const lobe_case *self, int argc, char **argv)
{
    static const lobe_fit_tier all[] = {{"lobes1", fit1}, {"lobes2", fit2}, {"lobes4", fit4}, {"lobes8", fit8}};
    return lobe_fit_command(self, all, (int)(sizeof all / sizeof all[0]), argc, argv);
}
