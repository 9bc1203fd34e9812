#include "shape.h"
#include <math.h>
#include <stddef.h>
#include "../fit/random.h"
#include "cubature.h"
#include "kernels.h"
#include "response.h"
#include "samplers.h"
#include "visible_normals.h"

typedef struct scene {
    double alpha, n_dot_v, albedo;
    const lobe_cell_tap *taps;
    int count;
    lobe_sphere_fn *lobe; /* NULL: the taps */
    void *ctx;
} scene;

static double response(const scene *s, const double d[3]) { return lobe_response(s->alpha, s->n_dot_v, d) / s->albedo; }

static double one(void *ctx, const double d[3])
{
    (void)ctx;
    (void)d;
    return 1;
}

static scene scene_of(double alpha, double n_dot_v, const lobe_cell_tap *taps, int count)
{
    const scene s = {alpha, n_dot_v, lobe_visible_integral(alpha, n_dot_v, 128, one, NULL), taps, count, NULL, NULL};
    return s;
}

static double along(const lobe_cell_tap *tap, const double d[3])
{
    return d[2] * cos(tap->angle) - d[0] * sin(tap->angle);
}

static double difference(const scene *s, const double d[3])
{
    double value = response(s, d) - (s->lobe ? s->lobe(s->ctx, d) : 0);
    for (int i = 0; i < s->count; i++)
        value -= s->taps[i].weight * lobe_prefilter_kernel(exp(s->taps[i].log_t), along(&s->taps[i], d));
    return value;
}

static double square_of_difference(void *ctx, const double d[3])
{
    const double x = difference(ctx, d);
    return x * x;
}

static double square_of_response(void *ctx, const double d[3])
{
    const double x = response(ctx, d);
    return x * x;
}

static double error_of(scene *s)
{
    const double rough = lobe_cubature(square_of_response, s, 1e-2), tolerance = 1e-5 * rough;
    return sqrt(lobe_cubature(square_of_difference, s, tolerance) / lobe_cubature(square_of_response, s, tolerance));
}

double lobe_shape_error(double alpha, double n_dot_v, const lobe_cell_tap *taps, int count)
{
    scene s = scene_of(alpha, n_dot_v, taps, count);
    return error_of(&s);
}

double lobe_shape_error_of(double alpha, double n_dot_v, lobe_sphere_fn *lobe, void *ctx)
{
    scene s = scene_of(alpha, n_dot_v, NULL, 0);
    s.lobe = lobe;
    s.ctx = ctx;
    return error_of(&s);
}

double lobe_shape_error_sampled(double alpha, double n_dot_v, const lobe_cell_tap *taps, int count, int samples)
{
    scene s = scene_of(alpha, n_dot_v, taps, count);
    double error = 0, all = 0;
    lobe_random r;
    lobe_random_seed(&r, 11, 0);
    for (int i = 0; i < samples; i++) {
        const int from = i % (count + 1);
        const double a = lobe_random_unit(&r), b = lobe_random_unit(&r);
        double d[3], density, x;
        if (from == count) {
            lobe_visible_light(alpha, n_dot_v, b, a, d);
        } else {
            const double angle = taps[from].angle;
            double e[3];
            lobe_sample_tap(exp(taps[from].log_t), a, b, e);
            d[0] = e[0] * cos(angle) - e[2] * sin(angle);
            d[1] = e[1];
            d[2] = e[2] * cos(angle) + e[0] * sin(angle);
        }
        density = lobe_visible_light_density(alpha, n_dot_v, d);
        for (int k = 0; k < count; k++)
            density += lobe_sample_tap_density(exp(taps[k].log_t), along(&taps[k], d));
        density /= count + 1;
        x = difference(&s, d);
        error += x * x / density;
        x = response(&s, d);
        all += x * x / density;
    }
    return sqrt(error / all);
}
