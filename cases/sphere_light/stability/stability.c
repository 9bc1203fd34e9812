#include "stability.h"
#include <math.h>
#include <stdlib.h>
#include "../../fit/random.h"
#include "../truth_sphere.h"

static const double pi = 3.14159265358979323846;
static const double alphas[LOBE_STABILITY_ALPHAS] = {.0025, .01, .05, .1, .2, .4, .7, 1};
static const double sigmas[LOBE_STABILITY_SIGMAS] = {.1, .5, 1, 2.5, 6, 15, 45, 70, 90};
static const double views[LOBE_STABILITY_VIEWS] = {0, 30, 60, 75, 85, 89};

const char *const lobe_stability_region_name[LOBE_STABILITY_REGIONS] = {"view >= 75, alpha <= .1", "sigma / alpha < .5",
                                                                        "sigma / alpha > 2",       "alpha >= .7",
                                                                        "through the horizon",     "sigma 70 to 90"};

static double alpha_of(int cell) { return alphas[cell / LOBE_STABILITY_VIEWS / LOBE_STABILITY_SIGMAS]; }
static double sigma_of(int cell) { return sigmas[cell / LOBE_STABILITY_VIEWS % LOBE_STABILITY_SIGMAS]; }
static double view_of(int cell) { return views[cell % LOBE_STABILITY_VIEWS]; }

/* n_dot_l and azimuth into row. Near the mirror direction first, and where a light there would be set, anywhere. */
static void place(double *row, double alpha, bool near, lobe_random *random)
{
    const double sigma = row[4], v = row[1], s = sqrt(1 - v * v), spread = fmin(pi / 2, sigma + 3 * alpha);
    const double t = spread * lobe_random_unit(random), turn = 2 * pi * lobe_random_unit(random);
    const double z = v * cos(t) + s * sin(t) * cos(turn);
    if (near && z > -.98 * sin(sigma)) {
        row[2] = fmin(z, 1);
        row[3] = fabs(atan2(sin(t) * sin(turn), -s * cos(t) + v * sin(t) * cos(turn)));
    } else {
        row[2] = (1 + .98 * sin(sigma)) * lobe_random_unit(random) - .98 * sin(sigma);
        row[3] = pi * lobe_random_unit(random);
    }
}

static void truth_rows(const double *in, double *out, size_t n)
{
    size_t i;
    for (i = 0; i < n; i++, in += 5) {
        const lobe_sphere_scene s = {in[0] * in[0], in[1], in[2], in[3], in[4], 1};
        out[i] = lobe_truth_sphere_stretched(&s, 1e-6);
    }
}

bool lobe_stability_make(lobe_stability *s, int positions, const lobe_sweep_options *options)
{
    const size_t count = (size_t)LOBE_STABILITY_CELLS * (size_t)positions;
    lobe_random random;
    size_t i;
    s->positions = positions;
    s->in = malloc(5 * count * sizeof *s->in);
    s->truth = malloc(count * sizeof *s->truth);
    if (!s->in || !s->truth) {
        lobe_stability_free(s);
        return false;
    }
    lobe_random_seed(&random, 4, 0);
    for (i = 0; i < count; i++) {
        const int cell = (int)(i / (size_t)positions);
        double *row = s->in + 5 * i;
        row[0] = sqrt(alpha_of(cell));
        row[1] = cos(view_of(cell) * pi / 180);
        row[4] = sigma_of(cell) * pi / 180;
        place(row, alpha_of(cell), i % (size_t)positions % 2 == 0, &random);
    }
    lobe_sweep(truth_rows, s->in, 5, s->truth, 1, count, options);
    return true;
}

void lobe_stability_free(lobe_stability *s)
{
    free(s->in);
    free(s->truth);
    s->in = s->truth = NULL;
}

lobe_stability_cell lobe_stability_judge(const lobe_stability *s, const lobe_sphere_candidate *form, int cell)
{
    lobe_stability_cell r = {.alpha = alpha_of(cell), .sigma = sigma_of(cell), .view = view_of(cell)};
    double error = 0, truth = 0, sum = 0, whole = 0, set_error = 0, set_truth = 0;
    int i, through = 0;
    for (i = cell * s->positions; i < (cell + 1) * s->positions; i++) {
        const double *row = s->in + 5 * i, t = s->truth[i], y = form->call(row), square = (y - t) * (y - t);
        error += square;
        truth += t * t;
        sum += y;
        whole += t;
        if (fabs(row[2]) < sin(row[4])) {
            set_error += square;
            set_truth += t * t;
            through++;
        }
    }
    r.error = sqrt(error / truth);
    r.energy = sum / whole - 1;
    r.horizon = through >= 8 ? sqrt(set_error / set_truth) : -1;
    return r;
}

static bool is_in(const lobe_stability_cell *c, lobe_stability_region region)
{
    const double ratio = sin(c->sigma * pi / 180) / c->alpha;
    if (c->alpha < .05 || c->view > 85 || (c->sigma > 45) != (region == LOBE_STABILITY_WIDE))
        return false;
    switch (region) {
    case LOBE_STABILITY_GRAZING:
        return c->view >= 75 && c->alpha <= .1;
    case LOBE_STABILITY_SMALL:
        return ratio < .5;
    case LOBE_STABILITY_LARGE:
        return ratio > 2;
    case LOBE_STABILITY_ROUGH:
        return c->alpha >= .7;
    case LOBE_STABILITY_HORIZON:
        return c->horizon >= 0;
    default:
        return true;
    }
}

lobe_stability_sum lobe_stability_over(const lobe_stability *s, const lobe_sphere_candidate *form,
                                       lobe_stability_region region)
{
    lobe_stability_sum sum = {0};
    int cell;
    for (cell = 0; cell < LOBE_STABILITY_CELLS; cell++) {
        const lobe_stability_cell c = lobe_stability_judge(s, form, cell);
        const double error = region == LOBE_STABILITY_HORIZON ? c.horizon : c.error;
        if (!is_in(&c, region))
            continue;
        sum.cells++;
        sum.rms += error * error;
        if (error > sum.worst) {
            sum.worst = error;
            sum.at = c;
        }
    }
    sum.rms = sqrt(sum.rms / (sum.cells ? sum.cells : 1));
    return sum;
}
