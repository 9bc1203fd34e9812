/* The truth is sampled on a lattice of some points a cell in the table's own coordinates. Texels start as samples, then
 * follow least squares whose weights grow where the error is large (Lawson), each texel set in turn to its best while
 * its neighbours stand; the round with the smallest maximum over the domain is kept. Sums run in one order, so the
 * bytes do not depend on threads, which only serve the truth. */
#include "table_fit.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../case.h"
#include "table_write.h"

enum { ROUNDS = 10, SWEEPS = 10, PER_MOST = 8 };

#define DOMAIN_LO 0.02
#define TRUTH_LO 0.001
#define OUTSIDE 0.02 /* weight of what lies below the domain */
/* Scale and bias of a texel add up to less than 1, by more than the rounding of a lookup. */
#define SUM_MOST (1 - 2e-6)

typedef struct fit {
    int side, per, samples; /* texels and lattice points along an axis, lattice points a cell */
    double *truth;          /* rows of scale, bias */
    unsigned char *inside;
    double *weight, *error; /* one a lattice point */
    double hat[2 * PER_MOST + 1];
} fit;

static double roughness_at(double x) { return 2 * x / (1.5 + sqrt(2.25 - 2 * x)); }
static double n_dot_v_at(double y) { return 0.25 * y / (1.25 - y); }

static bool sample(fit *f, const lobe_case *c, const lobe_sweep_options *sweep)
{
    const size_t n = (size_t)f->samples * (size_t)f->samples;
    lobe_sweep_options options = *sweep;
    double *in = malloc(2 * n * sizeof *in);
    int i, k;
    f->truth = malloc(2 * n * sizeof *f->truth);
    f->weight = malloc(n * sizeof *f->weight);
    f->error = malloc(n * sizeof *f->error);
    f->inside = malloc(n);
    if (!in || !f->truth || !f->weight || !f->error || !f->inside) {
        free(in);
        return false;
    }
    for (i = 0; i < f->samples; i++) {
        for (k = 0; k < f->samples; k++) {
            const double r = roughness_at(i / (f->samples - 1.0)), v = n_dot_v_at(k / (f->samples - 1.0));
            const int q = i * f->samples + k;
            in[2 * q] = fmin(1, fmax(r, TRUTH_LO));
            in[2 * q + 1] = fmin(1, fmax(v, TRUTH_LO));
            f->inside[q] = r >= DOMAIN_LO && v >= DOMAIN_LO;
        }
    }
    options.label = "truth";
    lobe_sweep(c->truth, in, 2, f->truth, 2, n, &options);
    free(in);
    for (i = 0; i <= 2 * f->per; i++)
        f->hat[i] = 1 - fabs((double)i / f->per - 1);
    return true;
}

static void errors_of(fit *f, const double *texels, int channel)
{
    int i, k;
    for (i = 0; i < f->samples; i++) {
        for (k = 0; k < f->samples; k++) {
            const int row = i / f->per < f->side - 2 ? i / f->per : f->side - 2;
            const int column = k / f->per < f->side - 2 ? k / f->per : f->side - 2;
            const double down = (double)(i - f->per * row) / f->per, along = (double)(k - f->per * column) / f->per;
            const double *t = texels + 2 * (row * f->side + column) + channel, *below = t + 2 * f->side;
            const double top = t[0] + along * (t[2] - t[0]), bottom = below[0] + along * (below[2] - below[0]);
            f->error[i * f->samples + k] = top + down * (bottom - top) - f->truth[2 * (i * f->samples + k) + channel];
        }
    }
}

/* The largest error inside the domain; the weights follow the errors. */
static double reweigh(fit *f)
{
    const int n = f->samples * f->samples;
    double max = 0, sum = 0;
    int i, count = 0;
    for (i = 0; i < n; i++)
        if (f->inside[i])
            max = fmax(max, fabs(f->error[i]));
    for (i = 0; i < n; i++) {
        if (f->inside[i]) {
            f->weight[i] *= fabs(f->error[i]) / max + 0.05;
            sum += f->weight[i];
            count++;
        }
    }
    for (i = 0; i < n; i++)
        if (f->inside[i])
            f->weight[i] = f->weight[i] * count / sum + 1e-3;
    return max;
}

static void settle_texel(fit *f, double *texels, int channel, int row, int column)
{
    const int per = f->per, last = f->samples - 1;
    const int i0 = row ? per * (row - 1) : 0, i1 = row < f->side - 1 ? per * (row + 1) : last;
    const int k0 = column ? per * (column - 1) : 0, k1 = column < f->side - 1 ? per * (column + 1) : last;
    const double *down = f->hat + per - per * row, *along = f->hat + per - per * column;
    double *texel = texels + 2 * (row * f->side + column), num = 0, den = 1e-9, to, step;
    int i, k;
    for (i = i0; i <= i1; i++) {
        double by_error = 0, by_hat = 0;
        for (k = k0; k <= k1; k++) {
            const double q = f->weight[i * f->samples + k] * along[k];
            by_error += q * f->error[i * f->samples + k];
            by_hat += q * along[k];
        }
        num += down[i] * by_error;
        den += down[i] * down[i] * by_hat;
    }
    to = fmin(SUM_MOST - texel[1 - channel], fmax(0, texel[channel] - num / den));
    step = texel[channel] - to;
    texel[channel] = to;
    for (i = i0; i <= i1; i++)
        for (k = k0; k <= k1; k++)
            f->error[i * f->samples + k] -= step * down[i] * along[k];
}

static void fit_channel(fit *f, double *texels, double *best, int channel)
{
    const int n = f->side * f->side;
    double least = HUGE_VAL;
    int i, k, round;
    for (i = 0; i < f->samples * f->samples; i++)
        f->weight[i] = f->inside[i] ? 1 : OUTSIDE;
    for (round = 0; round <= ROUNDS; round++) {
        errors_of(f, texels, channel);
        if (round) {
            const double max = reweigh(f);
            if (max < least) {
                least = max;
                for (i = 0; i < n; i++)
                    best[i] = texels[2 * i + channel];
            }
        }
        for (k = 0; round < ROUNDS && k < SWEEPS; k++)
            for (i = 0; i < n; i++)
                settle_texel(f, texels, channel, i / f->side, i % f->side);
    }
    for (i = 0; i < n; i++)
        texels[2 * i + channel] = best[i];
}

/* Samples, with a sum below 1 where the lookup could round above it. */
static void start(const fit *f, double *texels)
{
    int i, k;
    for (i = 0; i < f->side; i++) {
        for (k = 0; k < f->side; k++) {
            const double *t = f->truth + 2 * (i * f->per * f->samples + k * f->per);
            double *texel = texels + 2 * (i * f->side + k);
            texel[1] = fmin(1, fmax(0, t[1]));
            texel[0] = fmin(SUM_MOST - texel[1], fmax(0, t[0]));
            if (texel[0] < 0) {
                texel[0] = 0;
                texel[1] = SUM_MOST;
            }
        }
    }
}

static void judge(fit *f, const double *texels, lobe_table_text *text)
{
    int channel, i;
    for (channel = 0; channel < 2; channel++) {
        double sum = 0, max = 0;
        int count = 0;
        errors_of(f, texels, channel);
        for (i = 0; i < f->samples * f->samples; i++) {
            if (f->inside[i]) {
                sum += f->error[i] * f->error[i];
                max = fmax(max, fabs(f->error[i]));
                count++;
            }
        }
        text->max[channel] = max;
        text->rms[channel] = sqrt(sum / count);
    }
}

static bool write_both(fit *f, const lobe_case *self, double *texels, const lobe_fit_request *request)
{
    lobe_table_text text = {.model = self->name, .brdf = self->brdf, .side = f->side, .per = f->per, .texels = texels};
    const int n = f->side * f->side;
    double *fine = malloc(2 * (size_t)n * sizeof *fine);
    bool good = fine != NULL;
    if (good) {
        memcpy(fine, texels, 2 * (size_t)n * sizeof *fine);
        lobe_table_round_f32(texels, n);
        judge(f, texels, &text);
        good = lobe_table_write(&text, LOBE_TABLE_F32, request->tables);
        memcpy(texels, fine, 2 * (size_t)n * sizeof *fine);
        lobe_table_round_u16(texels, n);
        judge(f, texels, &text);
        good = good && lobe_table_write(&text, LOBE_TABLE_U16, request->tables);
    }
    free(fine);
    return good;
}

static bool fit_table(const lobe_case *self, const lobe_fit_request *request, int side, int per)
{
    fit f = {.side = side, .per = per, .samples = per * (side - 1) + 1};
    double *texels = malloc(2 * (size_t)(side * side) * sizeof *texels);
    double *best = malloc((size_t)(side * side) * sizeof *best);
    bool good = texels && best && sample(&f, self, &request->sweep);
    if (good) {
        start(&f, texels);
        fit_channel(&f, texels, best, 0);
        fit_channel(&f, texels, best, 1);
        good = write_both(&f, self, texels, request);
    } else {
        fputs("lobefit: fit: not enough memory\n", stderr);
    }
    free(texels);
    free(best);
    free(f.truth);
    free(f.weight);
    free(f.error);
    free(f.inside);
    return good;
}

bool lobe_table_fit_32(const lobe_case *self, const lobe_fit_request *request)
{
    return fit_table(self, request, 32, 8);
}

bool lobe_table_fit_64(const lobe_case *self, const lobe_fit_request *request)
{
    return fit_table(self, request, 64, 6);
}

/* 4 points a cell: the truth at 8 would take longer than all other fits. */
bool lobe_table_fit_128(const lobe_case *self, const lobe_fit_request *request)
{
    return fit_table(self, request, 128, 4);
}
