#include "scenes.h"
#include <math.h>
#include <pthread.h>
#include <stdlib.h>
#include "../env_lobes/kernels.h"

enum { FIT_ORDER = 36, FLOOR_ORDER = 64, THREADS = 16 };
static const double fit_alpha[] = {.04, .07, .12, .2, .3, .45, .6, .8, 1};
static const double fit_view[] = {.05, .09, .16, .27, .4, .55, .72, .87, 1};
static const double floor_alpha[] = {.04, .15, .3, .6, 1};
static const double floor_view[] = {.05, .15, .3, .5, .75, 1};

typedef struct job {
    lobe_sg_scenes *s;
    bool floors, good;
    const lobe_env_spectrum *spectra;
    int lights;
    double shape;
    size_t first, stride;
} job;

static void *make_some(void *ctx)
{
    job *j = ctx;
    size_t i;
    for (i = j->first; i < j->s->count; i += j->stride) {
        const double alpha = j->floors ? floor_alpha[i / 6] : fit_alpha[i / 9];
        const double view = j->floors ? floor_view[i % 6] : fit_view[i % 9];
        if (!lobe_sg_scene_make(&j->s->scene[i], alpha, view, j->floors ? FLOOR_ORDER : FIT_ORDER, j->spectra,
                                j->lights, j->shape))
            j->good = false;
    }
    return NULL;
}

bool lobe_sg_scenes_make(lobe_sg_scenes *s, bool floors, const lobe_env_spectrum *spectra, int lights, double shape,
                         int threads)
{
    job jobs[THREADS];
    pthread_t ids[THREADS];
    bool started[THREADS] = {false}, good = true;
    int i;
    threads = threads < 1 ? 1 : threads > THREADS ? THREADS : threads;
    s->count = floors ? LOBE_SG_FLOOR_POINTS : LOBE_SG_FIT_POINTS;
    s->scene = calloc(s->count, sizeof *s->scene);
    if (!s->scene)
        return false;
    for (i = 0; i < threads; i++)
        jobs[i] = (job){s, floors, true, spectra, lights, shape, (size_t)i, (size_t)threads};
    for (i = 1; i < threads; i++)
        started[i] = pthread_create(&ids[i], NULL, make_some, &jobs[i]) == 0;
    make_some(&jobs[0]);
    for (i = 1; i < threads; i++) {
        if (started[i])
            pthread_join(ids[i], NULL);
        else
            make_some(&jobs[i]);
    }
    for (i = 0; i < threads; i++)
        good = good && jobs[i].good;
    return good;
}

void lobe_sg_scenes_free(lobe_sg_scenes *s)
{
    size_t i;
    for (i = 0; s->scene && i < s->count; i++)
        lobe_sg_scene_free(&s->scene[i]);
    free(s->scene);
    s->scene = NULL;
}

int lobe_sg_split_sum(const void *ctx, double alpha, double n_dot_v, double energy, lobe_sg *lobes)
{
    (void)ctx;
    (void)alpha;
    (void)n_dot_v;
    (void)energy;
    (void)lobes;
    return 0;
}

double lobe_sg_scenes_error(const lobe_sg_scenes *s, const lobe_env_spectrum *spectra, int lights, lobe_sg_model model,
                            const void *ctx, double *by_light, double *shape)
{
    double sums[LOBE_SG_LIGHTS] = {0}, square[LOBE_SG_LIGHTS], factor[LOBE_ENV_BANDS], all = 0, shapes = 0;
    size_t i;
    int e;
    for (i = 0; i < s->count; i++) {
        const lobe_sg_scene *scene = &s->scene[i];
        lobe_sg lobes[LOBE_SG_MOST];
        const int count = model(ctx, scene->target.alpha, scene->target.n_dot_v, scene->target.albedo, lobes);
        if (count) {
            const double error = lobe_sg_target_error(&scene->target, lobes, count);
            shapes += error * error / (double)s->count;
        } else
            lobe_prefilter_bands(lobe_prefilter_t_of_alpha(scene->target.alpha), LOBE_ENV_BANDS, factor);
        if (!lobe_sg_scene_errors(scene, spectra, lights, lobes, count, factor, square))
            return -1;
        for (e = 0; e < lights; e++)
            sums[e] += square[e] / (double)s->count;
    }
    for (e = 0; e < lights; e++) {
        all += sums[e] / lights;
        if (by_light)
            by_light[e] = sqrt(sums[e]);
    }
    if (shape)
        *shape = sqrt(shapes);
    return sqrt(all);
}
