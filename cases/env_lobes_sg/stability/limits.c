/* What the model itself does wrong: wobble where the lobe is longer than its lobes can fill, a spread beyond the angle
 * of the centre, and an amplitude that is left to least squares. */
#include <math.h>
#include <string.h>
#include "experiment.h"

/* How much longer than wide the response is: the ratio of its standard deviations in and across the plane. */
static double stretch_of(const lobe_sg_target *t)
{
    double mean = 0, along = 0, across = 0;
    size_t i;
    for (i = 0; i < t->count; i++)
        mean += t->nodes[4 * i + 3] * atan2(-t->nodes[4 * i], t->nodes[4 * i + 2]) / t->albedo;
    for (i = 0; i < t->count; i++) {
        const double *row = t->nodes + 4 * i, angle = atan2(-row[0], row[2]) - mean;
        /* the tail of GGX has no second moment to speak of: weighed down beyond a few widths */
        const double off = angle * angle + row[1] * row[1], weight = row[3] / (1 + off / (t->alpha * t->alpha));
        along += weight * angle * angle;
        across += weight * row[1] * row[1];
    }
    return sqrt(along / across);
}

/* The deepest dent along the fan, as a part of the lower of the maxima on either side. */
static double dent_of(const lobe_sg *lobes, int count)
{
    enum { STEPS = 600 };
    double value[STEPS], deepest = 0, left = 0;
    int i, j;
    for (i = 0; i < STEPS; i++) {
        const double angle = lobes[0].angle + (lobes[count - 1].angle - lobes[0].angle) * i / (STEPS - 1);
        const double l[3] = {-sin(angle), 0, cos(angle)};
        value[i] = 0;
        for (j = 0; j < count; j++)
            value[i] += lobe_sg_at(&lobes[j], l);
    }
    for (i = 0; i < STEPS; i++) {
        double right = 0;
        left = fmax(left, value[i]);
        for (j = i; j < STEPS; j++)
            right = fmax(right, value[j]);
        deepest = fmax(deepest, 1 - value[i] / fmin(left, right));
    }
    return deepest;
}

/* Sharpness held at the width across the plane, as a fit that must not blur does; the rest is fitted. */
typedef struct held {
    const lobe_shape_fit *fit;
    double sharpness;
} held;

static double with_sharpness(void *ctx, const lobe_sg *lobes, int count)
{
    const held *h = ctx;
    lobe_sg copy[LOBE_SG_MOST];
    int i;
    for (i = 0; i < count; i++) {
        copy[i] = lobes[i];
        copy[i].sharpness = h->sharpness;
    }
    return lobe_sg_target_error(h->fit->target, copy, count);
}

bool lobe_experiment_wobble(FILE *out)
{
    static const double points[][2] = {{0.1, 1},   {0.1, 0.5},  {0.1, 0.3},  {0.1, 0.2},
                                       {0.1, 0.1}, {0.1, 0.05}, {0.04, 0.1}, {0.04, 0.05}};
    static const int counts[] = {2, 4, 8};
    size_t p, c;
    fputs("alpha,n_dot_v,stretch,lobes,dent_held,error_held,dent_fitted,error_fitted\n", out);
    for (p = 0; p < sizeof points / sizeof points[0]; p++) {
        lobe_sg_target target;
        if (!lobe_sg_target_make(&target, points[p][0], points[p][1], 40))
            return false;
        for (c = 0; c < sizeof counts / sizeof counts[0]; c++) {
            lobe_shape_fit fit = {.target = &target, .count = counts[c]}, fixed = fit;
            /* the lobe of half vectors is alpha wide; across, a reflection doubles that times the cosine */
            const double across = 2 * target.alpha * fmax(target.n_dot_v, target.alpha);
            held h = {&fit, fmin(2 / (across * across), 30000)};
            double x[LOBE_EXPERIMENT_MOST], error[2], dent[2];
            lobe_sg lobes[LOBE_SG_MOST];
            int i;
            fixed.estimate = with_sharpness;
            fixed.estimate_ctx = &h;
            lobe_shape_start(&fit, x);
            error[0] = lobe_shape_nelder_mead(&fixed, 800, x).value;
            lobe_shape_lobes(&fit, x, lobes);
            for (i = 0; i < fit.count; i++)
                lobes[i].sharpness = h.sharpness;
            dent[0] = dent_of(lobes, fit.count);
            lobe_shape_start(&fit, x);
            error[1] = lobe_shape_nelder_mead(&fit, 800, x).value;
            lobe_shape_lobes(&fit, x, lobes);
            dent[1] = dent_of(lobes, fit.count);
            fprintf(out, "%g,%g,%.2f,%d,%.3f,%.4f,%.3f,%.4f\n", points[p][0], points[p][1], stretch_of(&target),
                    fit.count, dent[0], error[0], dent[1], error[1]);
        }
        lobe_sg_target_free(&target);
    }
    return true;
}

bool lobe_experiment_spread(FILE *out)
{
    static const double alphas[] = {0.1, 0.2, 0.4, 0.7, 1}, views[] = {0.1, 0.3, 0.5, 0.7, 0.9, 0.97, 1};
    size_t a, v;
    fputs("alpha,n_dot_v,theta,spread_free,centre_free,error_free,spread_within,error_within,behind\n", out);
    for (a = 0; a < sizeof alphas / sizeof alphas[0]; a++)
        for (v = 0; v < sizeof views / sizeof views[0]; v++) {
            lobe_sg_target target;
            lobe_shape_fit fit = {.target = &target, .count = 8};
            double x[LOBE_EXPERIMENT_MOST], y[LOBE_EXPERIMENT_MOST], error[2], behind = 0;
            lobe_sg lobes[LOBE_SG_MOST];
            int i;
            if (!lobe_sg_target_make(&target, alphas[a], views[v], 28))
                return false;
            lobe_shape_start(&fit, x);
            error[0] = lobe_shape_nelder_mead(&fit, 1500, x).value;
            lobe_shape_lobes(&fit, x, lobes);
            for (i = 0; i < 8; i++) /* weight on the view's side of the normal */
                behind += lobes[i].angle < 0 ? lobes[i].weight / target.albedo : 0;
            fit.within = true;
            lobe_shape_start(&fit, y);
            error[1] = lobe_shape_nelder_mead(&fit, 1500, y).value;
            fprintf(out, "%g,%g,%.3f,%.3f,%.3f,%.4f,%.3f,%.4f,%.3f\n", alphas[a], views[v], acos(views[v]), exp(x[2]),
                    x[0], error[0], fmin(exp(y[2]), fmax(0, y[0])), error[1], behind);
            lobe_sg_target_free(&target);
        }
    return true;
}

bool lobe_experiment_amplitude(FILE *out)
{
    static const double alphas[] = {0.04, 0.1, 0.2, 0.4, 0.7, 1}, views[] = {0.05, 0.1, 0.2, 0.4, 0.7, 1};
    static const int counts[] = {1, 8};
    size_t a, v, c;
    fputs("lobes,alpha,n_dot_v,energy_free,error_free,error_fixed\n", out);
    for (c = 0; c < 2; c++)
        for (a = 0; a < sizeof alphas / sizeof alphas[0]; a++)
            for (v = 0; v < sizeof views / sizeof views[0]; v++) {
                lobe_sg_target target;
                lobe_shape_fit fit = {.target = &target, .count = counts[c]};
                double x[LOBE_EXPERIMENT_MOST], error[2], ignored, energy;
                lobe_sg lobes[LOBE_SG_MOST];
                if (!lobe_sg_target_make(&target, alphas[a], views[v], 28))
                    return false;
                lobe_shape_start(&fit, x);
                error[1] = lobe_shape_nelder_mead(&fit, 1000, x).value;
                fit.any_amplitude = true;
                error[0] = lobe_shape_nelder_mead(&fit, 1000, x).value;
                lobe_shape_lobes(&fit, x, lobes);
                energy = lobe_sg_target_amplitude(&target, lobes, fit.count, &ignored) - 1;
                fprintf(out, "%d,%g,%g,%.4f,%.4f,%.4f\n", counts[c], alphas[a], views[v], energy, error[0], error[1]);
                lobe_sg_target_free(&target);
            }
    return true;
}
