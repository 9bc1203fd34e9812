/* Fits the tiers of diffuse_sh.
 *
 * Objective: the radiance over random order-3 lighting. With independent lighting coefficients of unit variance its
 * mean square error at a point is |c - c_exact|^2, so this is least squares on the nine coefficients, relative to
 * |c_exact|, over 65 x 65 points with the edges. Band 0 counts twice: it alone is what a white furnace shows. Every fit
 * starts from Lambert's constants with all else zero or of an arbitrary size: there is one minimum that it falls into.
 */
#define LOBE_DOUBLE 1
#define LOBE_FIT 1
#include "fit.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../../models/diffuse_sh.h"
#include "../../models/diffuse_zonal.h"
#include "../fit/coefficients.h"
#include "../fit/least_squares.h"
#include "../fit/progress.h"

enum { MOST = 24, SIDE = 65, PARTS = 6, ROWS = SIDE * SIDE * PARTS };

typedef lobe_sh9 (*kernel_fn)(const double *p, double roughness, double n_dot_v);

typedef struct tier {
    const char *name, *kernel, *source;
    kernel_fn call;
    size_t count;
    double start[MOST];
} tier;

typedef struct problem {
    const tier *t;
    double *truth; /* rows of the PARTS, weighted like the residuals */
    double *weight;
    lobe_progress_line line;
} problem;

/* What is not zero of the nine. */
static void parts(lobe_sh9 c, double out[PARTS])
{
    out[0] = c.c0;
    out[1] = c.c2;
    out[2] = c.c3;
    out[3] = c.c6;
    out[4] = c.c7;
    out[5] = c.c8;
}

static double at(int i) { return i / (SIDE - 1.0); }

static void residuals(void *ctx, const double *params, size_t count, double *values)
{
    const problem *p = ctx;
    size_t n;
    int i, k;
    for (n = 0; n < count; n++)
        for (i = 0; i < SIDE * SIDE; i++) {
            double *out = values + n * ROWS + (size_t)(i * PARTS), c[PARTS];
            parts(p->t->call(params + n * p->t->count, at(i / SIDE), at(i % SIDE)), c);
            for (k = 0; k < PARTS; k++)
                out[k] = (c[k] - p->truth[i * PARTS + k]) * p->weight[i];
        }
}

static bool prepare(problem *p, double *row_weight)
{
    int i, k;
    p->truth = malloc(ROWS * sizeof *p->truth);
    p->weight = malloc(SIDE * SIDE * sizeof *p->weight);
    if (!p->truth || !p->weight) {
        fputs("lobefit: fit: not enough memory\n", stderr);
        return false;
    }
    for (i = 0; i < SIDE * SIDE; i++) {
        const lobe_sh9 exact = lobe_diffuse_sh_exact(at(i / SIDE), at(i % SIDE));
        parts(exact, p->truth + i * PARTS);
        p->weight[i] = 1 / sqrt(lobe_sh9_dot(exact, exact));
        for (k = 0; k < PARTS; k++)
            row_weight[i * PARTS + k] = k ? 1 : sqrt(2);
    }
    return true;
}

/* The radiance's relative error on the grid. */
static void judge(const problem *p, const double *c, double *row, lobe_coefficients *out)
{
    double sum = 0;
    int i, k;
    residuals((void *)p, c, 1, row);
    for (i = 0; i < SIDE * SIDE; i++) {
        double square = 0;
        for (k = 0; k < PARTS; k++)
            square += row[i * PARTS + k] * row[i * PARTS + k];
        sum += square;
        if (square > out->max) {
            out->max = square;
            out->at[0] = at(i / SIDE);
            out->at[1] = at(i % SIDE);
        }
    }
    out->max = sqrt(out->max);
    out->rms = sqrt(sum / (SIDE * SIDE));
}

static bool solve(problem *p, const double *row_weight, double *c)
{
    lobe_residuals r = {0};
    lobe_ls_options o = lobe_ls_default();
    lobe_fit_result result;
    size_t i;
    r.f = residuals;
    r.ctx = p;
    r.dim = p->t->count;
    r.rows = ROWS;
    r.weights = row_weight;
    o.progress = lobe_progress_print;
    o.progress_ctx = &p->line;
    result = lobe_least_squares(&r, &o, c);
    lobe_progress_finish(&p->line);
    if (result.status != LOBE_FIT_CONVERGED && result.status != LOBE_FIT_STALLED) {
        fprintf(stderr, "lobefit: fit diffuse_sh %s: %s: %s; the old coefficients stand\n", p->t->name,
                lobe_fit_status_name(result.status), result.reason);
        return false;
    }
    for (i = 0; i < p->t->count; i++)
        c[i] = lobe_coefficient_rounded(c[i]);
    return true;
}

static bool fit_tier(const lobe_case *self, const lobe_fit_request *request, const tier *t)
{
    lobe_coefficients out = {0};
    problem p = {0};
    double c[MOST], *row = malloc(2 * ROWS * sizeof *row);
    bool good;
    p.t = t;
    p.line = lobe_progress_line_default();
    p.line.out = request->sweep.progress ? stderr : NULL;
    memcpy(c, t->start, sizeof c);
    good = row && prepare(&p, row) && solve(&p, row, c);
    if (good) {
        out.model = "diffuse_sh";
        out.tier = t->name;
        out.brdf = self->brdf;
        out.domain = "roughness, n_dot_v in [0, 1]";
        out.grid = "65 x 65, uniform, edges included; band 0 counts twice";
        out.metric = "relative rms of the radiance at a point over random order-3 lighting";
        out.kernel = t->kernel;
        out.source = t->source;
        out.values = c;
        out.count = t->count;
        judge(&p, c, row + ROWS, &out);
        good = lobe_coefficients_write(&out, request->coeffs);
    }
    free(row);
    free(p.truth);
    free(p.weight);
    return good;
}

#define L0 0.2820948
#define K1 1.1547005 /* of band 1 to band 0 */
#define K2 0.5590170
#define SHAPES "models/diffuse_sh.h"
#define ZONAL "models/diffuse_zonal.h"
static const tier tiers[] = {
    {"low", "lobe_diffuse_shape_low", SHAPES, lobe_diffuse_sh_low, 10, {L0, 0, 0, 0, K1, K2, 0, 0, .1, 1}},
    {"medium",
     "lobe_diffuse_shape_medium",
     SHAPES,
     lobe_diffuse_sh_medium,
     18,
     {L0, 0, 0, 0, 0, 0, K1, 0, K2 *L0, 0, 0, 0, 0, 0, 0, 0, 0, 0}},
    {"zonal",
     "lobe_diffuse_zonal_shape",
     ZONAL,
     lobe_diffuse_sh_zonal,
     14,
     {L0, 0, 0, 0, 0, K1, 0, 0, K2, 0, 0, 0, .1, 0}},
    {"zonal_low", "lobe_diffuse_zonal_shape_low", ZONAL, lobe_diffuse_sh_zonal_low, 8, {L0, 0, 0, 0, K1, K2, 0, .1}},
};

static bool fit_low(const lobe_case *self, const lobe_fit_request *request)
{
    return fit_tier(self, request, &tiers[0]);
}
static bool fit_medium(const lobe_case *self, const lobe_fit_request *request)
{
    return fit_tier(self, request, &tiers[1]);
}
static bool fit_zonal(const lobe_case *self, const lobe_fit_request *request)
{
    return fit_tier(self, request, &tiers[2]);
}
static bool fit_zonal_low(const lobe_case *self, const lobe_fit_request *request)
{
    return fit_tier(self, request, &tiers[3]);
}

int lobe_diffuse_fit(const lobe_case *self, int argc, char **argv)
{
    static const lobe_fit_tier all[] = {{"exact", lobe_diffuse_constants},
                                        {"low", fit_low},
                                        {"medium", fit_medium},
                                        {"zonal", fit_zonal},
                                        {"zonal_low", fit_zonal_low}};
    return lobe_fit_command(self, all, (int)(sizeof all / sizeof all[0]), argc, argv);
}
