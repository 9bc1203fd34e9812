/* Fits low and medium of sphere_diffuse.
 *
 * Objective: the largest error as a part of sine^2, the light's irradiance over pi where it stands overhead, so that a
 * small light counts as much as a wide one. 64 half angles, uniform up to 90 degrees, by 81 heights n_dot_l / sine, the
 * cosines of equal steps: outside of [-1, 1] nothing is left to fit. Both fits start from round numbers. */
#define LOBE_DOUBLE 1
#define LOBE_FIT 1
#include "fit.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../../models/sphere_diffuse.h"
#include "../fit/coefficients.h"
#include "../fit/fit_command.h"
#include "../fit/minimax.h"
#include "../fit/progress.h"
#include "truth_sphere_diffuse.h"

enum { MOST = 8, ANGLES = 64, HEIGHTS = 81, ROWS = ANGLES * HEIGHTS };

typedef lobe_real (*kernel_fn)(const double *p, double n_dot_l, double sine);

typedef struct tier {
    const char *name, *kernel;
    kernel_fn call;
    size_t count;
    double start[MOST];
} tier;

typedef struct problem {
    const tier *t;
    double n_dot_l[ROWS], sine[ROWS], truth[ROWS];
    lobe_progress_line line;
} problem;

static void residuals(void *ctx, const double *params, size_t count, double *values)
{
    const problem *p = ctx;
    size_t n;
    int i;
    for (n = 0; n < count; n++)
        for (i = 0; i < ROWS; i++) {
            const double s = p->sine[i], y = p->t->call(params + n * p->t->count, p->n_dot_l[i], s);
            values[n * ROWS + (size_t)i] = (y - p->truth[i]) / (s * s);
        }
}

static void prepare(problem *p)
{
    const double pi = 3.14159265358979323846;
    int i, k;
    for (i = 0; i < ANGLES; i++)
        for (k = 0; k < HEIGHTS; k++) {
            const int row = i * HEIGHTS + k;
            p->sine[row] = i == ANGLES - 1 ? 1 : sin(pi / 2 * (i + 1) / ANGLES);
            p->n_dot_l[row] = p->sine[row] * sin(pi * (k / (HEIGHTS - 1.0) - 0.5));
            p->truth[row] = lobe_truth_sphere_diffuse(p->n_dot_l[row], p->sine[row]);
        }
}

static void judge(const problem *p, const double *c, double *row, lobe_coefficients *out)
{
    double sum = 0;
    int i;
    residuals((void *)p, c, 1, row);
    for (i = 0; i < ROWS; i++) {
        sum += row[i] * row[i];
        if (fabs(row[i]) > out->max) {
            out->max = fabs(row[i]);
            out->at[0] = p->n_dot_l[i];
            out->at[1] = p->sine[i];
        }
    }
    out->rms = sqrt(sum / ROWS);
}

static bool solve(problem *p, double *c)
{
    lobe_residuals r = {0};
    lobe_minimax_options o = lobe_minimax_default();
    lobe_minimax_result result;
    size_t i;
    r.f = residuals;
    r.ctx = p;
    r.dim = p->t->count;
    r.rows = ROWS;
    o.progress = lobe_progress_print;
    o.progress_ctx = &p->line;
    result = lobe_minimax(&r, &o, c);
    lobe_progress_finish(&p->line);
    if (result.fit.status != LOBE_FIT_CONVERGED && result.fit.status != LOBE_FIT_STALLED) {
        fprintf(stderr, "lobefit: fit sphere_diffuse %s: %s: %s; the old coefficients stand\n", p->t->name,
                lobe_fit_status_name(result.fit.status), result.fit.reason);
        return false;
    }
    for (i = 0; i < p->t->count; i++)
        c[i] = lobe_coefficient_rounded(c[i]);
    return true;
}

static bool fit_tier(const lobe_case *self, const lobe_fit_request *request, const tier *t)
{
    lobe_coefficients out = {0};
    problem *p = malloc(sizeof *p);
    double c[MOST], *row = malloc(ROWS * sizeof *row);
    bool good = p && row;
    if (!good)
        fputs("lobefit: fit: not enough memory\n", stderr);
    memcpy(c, t->start, sizeof c);
    if (good) {
        p->t = t;
        p->line = lobe_progress_line_default();
        p->line.out = request->sweep.progress ? stderr : NULL;
        prepare(p);
        good = solve(p, c);
    }
    if (good) {
        out.model = "sphere_diffuse";
        out.tier = t->name;
        out.brdf = self->brdf;
        out.domain = "n_dot_l in [-sine, sine], sine in (0, 1]";
        out.grid = "64 half angles up to 90 degrees by 81 heights; witness n_dot_l, sine";
        out.metric = "largest error as a part of sine^2";
        out.kernel = t->kernel;
        out.source = "models/sphere_diffuse.h";
        out.values = c;
        out.count = t->count;
        judge(p, c, row, &out);
        good = lobe_coefficients_write(&out, request->coeffs);
    }
    free(row);
    free(p);
    return good;
}

static const tier tiers[] = {
    {"low", "lobe_sphere_diffuse_low", lobe_sphere_diffuse_low, 3, {.4, 0, 0}},
    {"medium", "lobe_sphere_diffuse_medium", lobe_sphere_diffuse_medium, 5, {.25, 0, .1, .4, 0}},
};

static bool fit_low(const lobe_case *self, const lobe_fit_request *request)
{
    return fit_tier(self, request, &tiers[0]);
}

static bool fit_medium(const lobe_case *self, const lobe_fit_request *request)
{
    return fit_tier(self, request, &tiers[1]);
}

int lobe_sphere_diffuse_fit(const lobe_case *self, int argc, char **argv)
{
    static const lobe_fit_tier all[] = {{"low", fit_low}, {"medium", fit_medium}};
    return lobe_fit_command(self, all, (int)(sizeof all / sizeof all[0]), argc, argv);
}
