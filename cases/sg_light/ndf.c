#include "ndf.h"
#include <math.h>
#include <string.h>
#include "../fit/least_squares.h"

enum { NODES = 160 };

static const double pi = 3.14159265358979323846;

typedef struct target {
    int count;
    double alpha, below[NODES], value[NODES], weight[NODES]; /* below: 1 - cosine; value and weight of the residual */
} target;

double lobe_ndf_alpha(int i)
{
    static const double alphas[LOBE_NDF_ALPHAS] = {.05, .075, .1, .15, .2, .3, .4, .5, .6, .7, .85, 1};
    return alphas[i];
}

double lobe_ndf_value(lobe_ndf kind, double alpha, double cosine)
{
    const double a2 = alpha * alpha, c2 = cosine * cosine, t2 = (1 - c2) / c2;
    const double k = c2 * (a2 + t2);
    return kind == LOBE_NDF_GGX ? a2 / (pi * k * k) : exp(-t2 / a2) / (pi * a2 * c2 * c2);
}

/* The midpoint rule in the root of 1 - tan^2 / (tan^2 + a^2): smooth at the horizon, and even enough over GGX. */
static void target_make(target *t, lobe_ndf kind, int count, double alpha)
{
    double square = 0;
    int i;
    t->count = count;
    t->alpha = alpha;
    for (i = 0; i < NODES; i++) {
        const double y = 1 - (i + .5) / NODES, rest = y * y, a2 = alpha * alpha, t2 = a2 * (1 - rest) / rest;
        const double c = 1 / sqrt(1 + t2);
        const double slope = a2 / (rest * rest) * .5 * c * c * c * c * 2 * y; /* c dc = c^4 / 2 d(tan^2) */
        t->below[i] = t2 * c * c / (1 + c);
        t->value[i] = lobe_ndf_value(kind, alpha, c);
        t->weight[i] = 2 * pi * slope / NODES;
        square += t->weight[i] * t->value[i] * t->value[i];
    }
    for (i = 0; i < NODES; i++)
        t->weight[i] /= square;
}

static double model(const target *t, const double *p, double below)
{
    const double a2 = t->alpha * t->alpha;
    double y = 0;
    int i;
    for (i = 0; i < t->count; i++)
        y += p[t->count + i] / (pi * a2) * exp(-exp(p[i]) / a2 * below);
    return y;
}

static void residuals(void *ctx, const double *params, size_t count, double *values)
{
    const target *t = ctx;
    size_t n;
    int i;
    for (n = 0; n < count; n++, params += 2 * t->count)
        for (i = 0; i < NODES; i++)
            *values++ = (model(t, params, t->below[i]) - t->value[i]) * sqrt(t->weight[i]);
}

void lobe_ndf_judge(lobe_ndf kind, int count, double alpha, lobe_ndf_fit *fit)
{
    double p[2 * LOBE_NDF_MOST], off[NODES], square = 0;
    target t;
    int i;
    target_make(&t, kind, count, alpha);
    for (i = 0; i < count; i++) {
        p[i] = log(fit->sharpness[i]);
        p[count + i] = fit->amplitude[i];
    }
    residuals(&t, p, 1, off);
    for (i = 0; i < NODES; i++)
        square += off[i] * off[i];
    fit->error = sqrt(square);
    fit->sum = 0;
    for (i = 0; i < count; i++) { /* int_0^1 2 pi c exp(-s (1 - c)) dc */
        const double s = fit->sharpness[i] / (alpha * alpha);
        fit->sum += 2 * fit->amplitude[i] / (alpha * alpha) * (1 / s + expm1(-s) / (s * s));
    }
}

/* GGX from the smoothest up, each from the one before; the first from sharpnesses three apart, which a power law's tail
 * asks for. Beckmann from the roughest down: there its slope at the pole is upward, and amplitudes take both signs. */
static void start(lobe_ndf kind, int count, double *p)
{
    int i;
    for (i = 0; i < count; i++) {
        p[i] = kind == LOBE_NDF_GGX ? log(count > 1 ? 4 : 2) - 1.1 * i : log(1.4) + .7 * i;
        p[count + i] = kind == LOBE_NDF_GGX ? .8 * exp(-1.6 * i) : i == 0 ? 1.5 : i & 1 ? -.5 : .2;
    }
}

bool lobe_ndf_fit_all(lobe_ndf kind, int count, lobe_ndf_fit fits[LOBE_NDF_ALPHAS])
{
    double p[2 * LOBE_NDF_MOST];
    int i, at;
    start(kind, count, p);
    for (at = 0; at < LOBE_NDF_ALPHAS; at++) {
        const int k = kind == LOBE_NDF_GGX ? at : LOBE_NDF_ALPHAS - 1 - at;
        target t;
        lobe_residuals problem = {.f = residuals, .ctx = &t, .dim = 2 * (size_t)count, .rows = NODES};
        lobe_ls_options options = lobe_ls_default();
        lobe_fit_result result;
        options.budget = 20000;
        options.ridge = 1e-9;
        target_make(&t, kind, count, lobe_ndf_alpha(k));
        result = lobe_least_squares(&problem, &options, p);
        if (result.status != LOBE_FIT_CONVERGED && result.status != LOBE_FIT_STALLED &&
            result.status != LOBE_FIT_BUDGET)
            return false;
        for (i = 0; i < count; i++) {
            fits[k].sharpness[i] = exp(p[i]);
            fits[k].amplitude[i] = p[count + i];
        }
        lobe_ndf_judge(kind, count, lobe_ndf_alpha(k), &fits[k]);
    }
    return true;
}

bool lobe_ndf_write(FILE *out)
{
    static const char *const names[] = {"GGX", "Beckmann"};
    lobe_ndf_fit fits[LOBE_NDF_ALPHAS];
    int kind, count, k, i;
    fputs("distribution,gaussians,alpha,relative_l2,sum", out);
    for (i = 1; i <= LOBE_NDF_MOST; i++)
        fprintf(out, ",sharpness%d,amplitude%d", i, i);
    fputs("\n# D(h) = sum of amplitude_i / (pi alpha^2) exp(sharpness_i / alpha^2 (n.h - 1))\n", out);
    for (kind = 0; kind < 2; kind++)
        for (count = 1; count <= LOBE_NDF_MOST; count++) {
            if (!lobe_ndf_fit_all((lobe_ndf)kind, count, fits)) {
                fputs("lobefit: search sg_light: a fit of normals failed\n", stderr);
                return false;
            }
            for (k = 0; k < LOBE_NDF_ALPHAS; k++) {
                fprintf(out, "%s,%d,%g,%.5f,%.5f", names[kind], count, lobe_ndf_alpha(k), fits[k].error, fits[k].sum);
                for (i = 0; i < LOBE_NDF_MOST; i++)
                    if (i < count)
                        fprintf(out, ",%.6g,%.6g", fits[k].sharpness[i], fits[k].amplitude[i]);
                    else
                        fputs(",,", out);
                fputc('\n', out);
            }
        }
    return true;
}
