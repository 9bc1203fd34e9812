/* Fits of the shape alone, with the fit's own points, starts and method: what env_lobes would be without radiance in
 * its objective, with the energy fixed and with it free. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../fit/parallel.h"
#include "contenders.h"
#include "fan_fit.h"
#include "front.h"
#include "shape.h"

enum {
    TIERS = 4,
    SHIPPED = 2,
    MODELS = 1 + 3 * TIERS,
    AT = 81,
    BETWEEN = 81,
    COEFFICIENTS = LOBE_FAN_MOST + LOBE_FAN_TERMS
};

typedef struct fitted {
    int taps;
    bool free_energy;
    double p[COEFFICIENTS];
} fitted;

typedef struct front {
    int threads;
    char name[2 * TIERS][40];
    fitted fit[2 * TIERS];
    lobe_judge_model models[MODELS];
    lobe_judge_error sum[MODELS]; /* squares */
    double alpha[AT + BETWEEN], n_dot_v[AT + BETWEEN];
} front;

static int taps_of(const void *ctx, double alpha, double n_dot_v, lobe_cell_tap *taps)
{
    const fitted *f = ctx;
    const lobe_fan_point point = lobe_fan_point_of(alpha, n_dot_v);
    (f->free_energy ? lobe_fan_free_taps : lobe_fan_taps)(&point, f->p, f->taps, taps, NULL);
    return f->taps;
}

/* From the fit with fixed energy, whose last part is what the others leave. */
static void free_last_part(const double *from, int taps, double *p)
{
    double *last = p + lobe_fan_first(taps - 1, 2);
    memcpy(p, from, sizeof *p * (size_t)lobe_fan_count(taps));
    for (int i = 0; i < LOBE_FAN_TERMS; i++) {
        last[i] = i == 0;
        for (int k = 0; k < taps - 1; k++)
            last[i] -= from[lobe_fan_first(k, 2) + i];
    }
}

static bool fit_all(front *f)
{
    lobe_training *training = lobe_training_of_shape(f->threads);
    lobe_fan_fit fan = {training, f->threads, lobe_progress_line_default(), false};
    bool good = training != NULL;
    for (int i = 0; good && i < TIERS; i++) {
        fitted *fixed = &f->fit[i], *loose = &f->fit[TIERS + i];
        lobe_fit_result result;
        fixed->taps = loose->taps = 1 << i;
        loose->free_energy = true;
        fan.free_energy = false;
        result = lobe_fan_search(&fan, fixed->taps, i ? f->fit[i - 1].p : NULL, fixed->p);
        good = result.status != LOBE_FIT_INTERRUPTED && isfinite(result.value);
        free_last_part(fixed->p, fixed->taps, loose->p);
        fan.free_energy = true;
        if (good)
            result = lobe_fan_improve(&fan, loose->taps, 100, loose->p);
        good = good && result.status != LOBE_FIT_INTERRUPTED && isfinite(result.value);
    }
    if (good) { /* points of the fit from alpha .04 on, all but n_dot_v .9, and the middles between them */
        const int n = LOBE_TRAINING_VIEWS;
        for (int i = 0; i < AT; i++) {
            const int a = i / (n - 1), v = i % (n - 1);
            f->alpha[i] = training->alpha[(a + 1) * n];
            f->n_dot_v[i] = training->n_dot_v[v + (v == n - 2)];
            f->alpha[AT + i] = 0.5 * (training->alpha[a * n] + training->alpha[(a + 1) * n]);
            f->n_dot_v[AT + i] = 0.5 * (training->n_dot_v[v] + training->n_dot_v[v + 1]);
        }
    }
    lobe_training_free(training);
    if (!good)
        fputs("lobefit: search: not enough memory, or interrupted\n", stderr);
    return good;
}

static bool judge_one(void *ctx, const char *name, const lobe_environment *map, double dark)
{
    front *f = ctx;
    const lobe_judge_options options = {f->threads, 7, dark};
    lobe_judge_error e[MODELS];
    (void)name;
    if (!lobe_judge_environment(map, &options, f->models, MODELS, e)) {
        fputs("lobefit: search: not enough memory\n", stderr);
        return false;
    }
    for (int m = 0; m < MODELS; m++) {
        f->sum[m].relative += e[m].relative * e[m].relative;
    }
    return true;
}

/* Square error of shape and energy, by number: model * (AT + BETWEEN) + point. */
static void ask(void *ctx, const double *params, size_t count, double *values)
{
    const front *f = ctx;
    for (size_t i = 0; i < count; i++) {
        const int k = (int)params[i], point = k % (AT + BETWEEN);
        const lobe_judge_model *m = &f->models[k / (AT + BETWEEN)];
        const double alpha = f->alpha[point], v = f->n_dot_v[point];
        lobe_cell_tap taps[LOBE_CELL_TAPS];
        const int n = m->taps(m->ctx, alpha, v, taps);
        const double error = lobe_shape_error(alpha, v, taps, n);
        values[2 * i] = error * error;
        values[2 * i + 1] = 0;
        for (int t = 0; t < n; t++)
            values[2 * i + 1] += taps[t].weight;
    }
}

static void write_rows(front *f, const lobe_held *held, const double *value, FILE *out)
{
    const double n = lobe_held_count(held);
    fputs("model,shape_at,shape_between,energy_mean,energy_worst,relative,of_split_sum\n", out);
    for (int m = 0; m < MODELS; m++) {
        double shape[2] = {0, 0}, mean = 0, worst = 1;
        for (int i = 0; i < AT + BETWEEN; i++) {
            const double *row = value + 2 * (m * (AT + BETWEEN) + i);
            shape[i >= AT] += row[0] / (i < AT ? AT : BETWEEN);
            mean += row[1] / (AT + BETWEEN);
            worst = fabs(row[1] - 1) > fabs(worst - 1) ? row[1] : worst;
        }
        fprintf(out, "%s,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f\n", f->models[m].name, sqrt(shape[0]), sqrt(shape[1]), mean,
                worst, sqrt(f->sum[m].relative / n), sqrt(f->sum[m].relative / f->sum[0].relative));
    }
}

bool lobe_shape_front_write(const lobe_held *held, int threads, FILE *out)
{
    enum { ROWS = MODELS * (AT + BETWEEN) };
    front *f = calloc(1, sizeof *f);
    double *room = malloc(sizeof *room * 3 * ROWS), *value = room ? room + ROWS : NULL;
    bool good = f && room;
    if (good) {
        lobe_parallel parallel = {ask, f, 1, 2, (size_t)threads};
        f->threads = threads;
        f->models[0] = lobe_contender[0];
        for (int i = 0; i < TIERS; i++)
            f->models[1 + i] = lobe_contender[SHIPPED + i];
        for (int i = 0; i < 2 * TIERS; i++) {
            snprintf(f->name[i], sizeof f->name[i], "shape alone %d%s", 1 << i % TIERS,
                     i < TIERS ? "" : " energy free");
            f->models[1 + TIERS + i] = (lobe_judge_model){f->name[i], taps_of, NULL, &f->fit[i]};
        }
        good = fit_all(f) && lobe_held_each(held, judge_one, f);
        for (int i = 0; i < ROWS; i++)
            room[i] = i;
        if (good) {
            lobe_parallel_eval(&parallel, room, ROWS, value);
            write_rows(f, held, value, out);
        }
    } else
        fputs("lobefit: search: not enough memory\n", stderr);
    free(room);
    free(f);
    return good;
}
