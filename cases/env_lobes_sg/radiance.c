#include "radiance.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../env_lobes/response.h"

/* Tables over x = sin(angle / 2), even, and over the logarithm of the sharpness; four points of either make a cubic. */
enum { ANGLES = 1025, ROWS = 64 };
static const double first_row = -2, row_step = 0.2;

void lobe_sg_bands(double sharpness, int bands, double *factor)
{
    /* ratios of neighbouring modified spherical Bessel functions, downward, where the recurrence is stable */
    const double start = bands + 40;
    double ratio = sharpness / (start + sqrt(start * start + sharpness * sharpness));
    int l;
    for (l = bands + 39; l >= 1; l--) {
        ratio = 1 / ((2 * l + 1) / sharpness + ratio);
        if (l < bands)
            factor[l] = ratio;
    }
    factor[0] = 1;
    for (l = 1; l < bands; l++)
        factor[l] *= factor[l - 1];
}

/* sum over l of band[l] P_l at the table's angles */
static void correlate(const double *band, double *table)
{
    int i, l;
    for (i = 0; i < ANGLES; i++) {
        const double x = (double)i / (ANGLES - 1), c = 1 - 2 * x * x;
        double p0 = 1, p1 = c, sum = 0;
        for (l = 0; l < LOBE_ENV_BANDS; l++) {
            const double p2 = ((2 * l + 3) * c * p1 - (l + 1) * p0) / (l + 2);
            sum += band[l] * p0;
            p0 = p1;
            p1 = p2;
        }
        table[i] = sum;
    }
}

/* Lagrange's cubic through four even nodes, x from the second. */
static void cubic(double x, double w[4])
{
    w[0] = -x * (x - 1) * (x - 2) / 6;
    w[1] = (x + 1) * (x - 1) * (x - 2) / 2;
    w[2] = -(x + 1) * x * (x - 2) / 2;
    w[3] = (x + 1) * x * (x - 1) / 6;
}

static int angle_weights(double c, double w[4])
{
    const double x = sqrt(fmin(1, fmax(0, (1 - c) / 2))) * (ANGLES - 1);
    int first = (int)x;
    first = first < 1 ? 1 : first > ANGLES - 3 ? ANGLES - 3 : first;
    cubic(x - first, w);
    return first - 1;
}

static int row_weights(double sharpness, double w[4])
{
    const double x = fmin(fmax((log(sharpness) - first_row) / row_step, 0), ROWS - 1);
    int first = (int)x;
    first = first < 1 ? 1 : first > ROWS - 3 ? ROWS - 3 : first;
    cubic(x - first, w);
    return first - 1;
}

static double look(const double *table, double c)
{
    double w[4];
    const double *t = table + angle_weights(c, w);
    return w[0] * t[0] + w[1] * t[1] + w[2] * t[2] + w[3] * t[3];
}

static void at_sharpness(const float *rows, double sharpness, double *table)
{
    double w[4];
    const float *row = rows + row_weights(sharpness, w) * ANGLES;
    int k;
    for (k = 0; k < ANGLES; k++)
        table[k] = w[0] * (double)row[k] + w[1] * (double)row[k + ANGLES] + w[2] * (double)row[k + 2 * ANGLES] +
                   w[3] * (double)row[k + 3 * ANGLES];
}

/* Mean square radiance of the target under every light. A sum over pairs of nodes takes the gaps between them for
 * structure of the lobe, and white light would see it: bands that the lobe has nothing in are left out. */
static bool own_squares(const lobe_sg_target *t, const lobe_env_spectrum *spectra, int lights, double *square)
{
    double band[LOBE_ENV_BANDS], table[ANGLES], sum[LOBE_SG_LIGHTS] = {0};
    double(*tables)[LOBE_SG_LIGHTS] = calloc(ANGLES, sizeof *tables);
    const bool good = tables != NULL;
    size_t i, j;
    int e, l;
    for (e = 0; good && e < lights; e++) {
        for (l = 0; l < LOBE_ENV_BANDS; l++)
            band[l] = spectra[e].power[l] * (2 * l + 1) / (4 * LOBE_PI) * exp(-pow(0.06 * t->alpha * l, 4));
        correlate(band, table);
        for (l = 0; l < ANGLES; l++)
            tables[l][e] = table[l];
    }
    for (i = 0; good && i < t->count; i++) {
        const double *a = t->nodes + 4 * i;
        for (j = 0; j <= i; j++) {
            const double *b = t->nodes + 4 * j, plane = a[0] * b[0] + a[2] * b[2], across = a[1] * b[1];
            const double both = (i == j ? 0.5 : 1) * a[3] * b[3];
            double u[4], w[4];
            const double(*x)[LOBE_SG_LIGHTS] = tables + angle_weights(plane + across, u);
            const double(*y)[LOBE_SG_LIGHTS] = tables + angle_weights(plane - across, w);
            for (e = 0; e < lights; e++)
                sum[e] += both * ((u[0] * x[0][e] + u[1] * x[1][e] + u[2] * x[2][e] + u[3] * x[3][e]) +
                                  (w[0] * y[0][e] + w[1] * y[1][e] + w[2] * y[2][e] + w[3] * y[3][e]));
        }
    }
    for (e = 0; e < lights; e++)
        square[e] = sum[e];
    free(tables);
    return good;
}

static double cross(const lobe_sg_target *t, const double *table, double angle)
{
    const double x = -sin(angle), z = cos(angle);
    double sum = 0;
    size_t k;
    for (k = 0; k < t->count; k++) {
        const double *row = t->nodes + 4 * k;
        sum += row[3] * look(table, x * row[0] + z * row[2]);
    }
    return sum;
}

/* Both tables at once: the polynomials are the same for every row. */
static bool fill_tables(lobe_sg_scene *s)
{
    enum { ALL = 2 * ROWS };
    double(*band)[ALL] = malloc(sizeof *band * LOBE_ENV_BANDS), factor[LOBE_ENV_BANDS], sum[ALL];
    int r, l, i;
    s->once = malloc(sizeof *s->once * ANGLES * ROWS);
    s->twice = malloc(sizeof *s->twice * ANGLES * ROWS);
    if (!band || !s->once || !s->twice) {
        free(band);
        return false;
    }
    for (r = 0; r < ROWS; r++) {
        lobe_sg_bands(exp(first_row + row_step * r), LOBE_ENV_BANDS, factor);
        for (l = 0; l < LOBE_ENV_BANDS; l++) {
            band[l][r] = s->power[l] * (2 * l + 1) / (4 * LOBE_PI) * factor[l];
            band[l][r + ROWS] = band[l][r] * factor[l];
        }
    }
    for (i = 0; i < ANGLES; i++) {
        const double x = (double)i / (ANGLES - 1), c = 1 - 2 * x * x;
        double p0 = 1, p1 = c;
        memset(sum, 0, sizeof sum);
        for (l = 0; l < LOBE_ENV_BANDS; l++) {
            const double p2 = ((2 * l + 3) * c * p1 - (l + 1) * p0) / (l + 2);
            for (r = 0; r < ALL; r++)
                sum[r] += band[l][r] * p0;
            p0 = p1;
            p1 = p2;
        }
        for (r = 0; r < ROWS; r++) {
            s->once[r * ANGLES + i] = (float)sum[r];
            s->twice[r * ANGLES + i] = (float)sum[r + ROWS];
        }
    }
    free(band);
    return true;
}

bool lobe_sg_scene_make(lobe_sg_scene *s, double alpha, double n_dot_v, int order, const lobe_env_spectrum *spectra,
                        int lights, double shape)
{
    int e, l;
    memset(s, 0, sizeof *s);
    s->shape = shape;
    if (!lobe_sg_target_make(&s->target, alpha, n_dot_v, order) ||
        !own_squares(&s->target, spectra, lights, s->light_square))
        return false;
    for (l = 0; l < LOBE_ENV_BANDS; l++)
        s->power[l] = shape / s->target.power;
    for (e = 0; e < lights; e++)
        for (l = 0; l < LOBE_ENV_BANDS; l++)
            s->power[l] += spectra[e].power[l] / (s->light_square[e] * lights);
    return fill_tables(s);
}

void lobe_sg_scene_free(lobe_sg_scene *s)
{
    lobe_sg_target_free(&s->target);
    free(s->once);
    free(s->twice);
    s->once = s->twice = NULL;
}

/* One sharpness for two: that with the same product of the factors of band 1. */
static double between(double p, double q)
{
    const double a = sqrt((1 / tanh(p) - 1 / p) * (1 / tanh(q) - 1 / q));
    double x = sqrt(p * q);
    int i;
    if (p == q)
        return p;
    if (fmin(p, q) > 30)
        return 1 / (1 - a);
    for (i = 0; i < 12; i++) {
        const double t = 1 / tanh(x), value = t - 1 / x - a, slope = 1 - t * t + 1 / (x * x);
        const double next = x - value / slope;
        x = next > 0.3 * x ? fmin(next, 3 * x) : 0.3 * x;
    }
    return x;
}

double lobe_sg_scene_error(const lobe_sg_scene *s, const lobe_sg *lobes, int count)
{
    double table[ANGLES], sum = 1 + s->shape;
    int i, j, a, b;
    for (i = 0; i < count; i++) {
        if (i == 0 || lobes[i].sharpness != lobes[i - 1].sharpness)
            at_sharpness(s->once, lobes[i].sharpness, table);
        sum -= 2 * lobes[i].weight * cross(&s->target, table, lobes[i].angle);
    }
    for (i = 0; i < count; i++)
        for (j = 0; j <= i; j++) {
            double across[4], along[4];
            const int row = row_weights(between(lobes[i].sharpness, lobes[j].sharpness), across);
            const int column = angle_weights(cos(lobes[i].angle - lobes[j].angle), along);
            const float *t = s->twice + row * ANGLES + column;
            double value = 0;
            for (a = 0; a < 4; a++)
                for (b = 0; b < 4; b++)
                    value += across[a] * along[b] * (double)t[a * ANGLES + b];
            sum += (i == j ? 1 : 2) * lobes[i].weight * lobes[j].weight * value;
        }
    return fmax(0, sum);
}

/* With bands, not tables: the second opinion of lobe_sg_scene_error. */
bool lobe_sg_scene_errors(const lobe_sg_scene *s, const lobe_env_spectrum *spectra, int lights, const lobe_sg *lobes,
                          int count, const double *factor, double *square)
{
    double band[LOBE_ENV_BANDS], table[ANGLES], own[LOBE_ENV_BANDS];
    double(*damp)[LOBE_ENV_BANDS] = malloc(sizeof *damp * (size_t)(count ? count : 1));
    const lobe_sg mirror = {acos(s->target.n_dot_v), 1, s->target.albedo};
    int i, j, e, l;
    if (!damp)
        return false;
    if (count == 0) {
        memcpy(damp[0], factor, sizeof damp[0]);
        lobes = &mirror;
        count = 1;
    } else {
        for (i = 0; i < count; i++)
            lobe_sg_bands(lobes[i].sharpness, LOBE_ENV_BANDS, damp[i]);
    }
    memset(own, 0, sizeof own);
    for (i = 0; i < count; i++)
        for (j = 0; j < count; j++) {
            const double c = cos(lobes[i].angle - lobes[j].angle);
            double p0 = 1, p1 = c;
            for (l = 0; l < LOBE_ENV_BANDS; l++) {
                const double p2 = ((2 * l + 3) * c * p1 - (l + 1) * p0) / (l + 2);
                own[l] += lobes[i].weight * lobes[j].weight * damp[i][l] * damp[j][l] * p0;
                p0 = p1;
                p1 = p2;
            }
        }
    for (e = 0; e < lights; e++) {
        square[e] = s->light_square[e];
        for (l = 0; l < LOBE_ENV_BANDS; l++)
            square[e] += spectra[e].power[l] * (2 * l + 1) / (4 * LOBE_PI) * own[l];
        for (i = 0; i < count; i++) {
            for (l = 0; l < LOBE_ENV_BANDS; l++)
                band[l] = spectra[e].power[l] * (2 * l + 1) / (4 * LOBE_PI) * damp[i][l];
            correlate(band, table);
            square[e] -= 2 * lobes[i].weight * cross(&s->target, table, lobes[i].angle);
        }
        square[e] = fmax(0, square[e] / s->light_square[e]);
    }
    free(damp);
    return true;
}
