#include "sphere_norm.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "gauss.h"
#include "kernels.h"
#include "response.h"
#include "spline.h"
#include "visible_normals.h"

enum { CHORDS = 160, WIDTHS = 56, FINE = 600, ORDER = 44, POINTS = LOBE_SPHERE_POINTS, MOST = LOBE_SPECTRA_MOST };

/* Tables over q = asinh(chord / CHORD), chord = 2 sin(angle / 2), and over ln t. */
#define CHORD 0.02
#define T_LO 0.003
#define T_HI 60.0

struct lobe_sphere_kernels {
    double factor[WIDTHS][LOBE_ENV_BANDS];
};

struct lobe_sphere_norm {
    double alpha, n_dot_v;
    double shape;                                /* amplitude of the shape at the points */
    double at[POINTS][3], root_weight[POINTS];   /* quadrature over the sphere, y > 0 */
    double blurred[(CHORDS + 2) * (WIDTHS + 2)]; /* kernels, a spline over both */
    double band[LOBE_ENV_BANDS];                 /* the blur */
    double target[LOBE_SPHERE_VALUES];
};

static double t_of(int i) { return T_LO * pow(T_HI / T_LO, i / (WIDTHS - 1.0)); }

static double chord_of(int i, int count) { return CHORD * sinh(asinh(2 / CHORD) * i / (count - 1)); }

static double place(double chord, int count) { return asinh(chord / CHORD) * ((count - 1) / asinh(2 / CHORD)); }

lobe_sphere_kernels *lobe_sphere_kernels_new(void)
{
    lobe_sphere_kernels *k = malloc(sizeof *k);
    for (int i = 0; k && i < WIDTHS; i++)
        lobe_prefilter_bands(t_of(i), LOBE_ENV_BANDS, k->factor[i]);
    return k;
}

void lobe_sphere_kernels_free(lobe_sphere_kernels *kernels) { free(kernels); }

/* sum_l factor[l] P_l(c) */
static double legendre_sum(const double *factor, double c)
{
    double p0 = 1, p1 = c, sum = 0;
    for (int l = 0; l < LOBE_ENV_BANDS; l++) {
        const double p2 = ((2 * l + 3) * c * p1 - (l + 1) * p0) / (l + 2);
        sum += factor[l] * p0;
        p0 = p1;
        p1 = p2;
    }
    return sum;
}

/* The blur as a round kernel: amplitude over the bands, damped where neither lobe nor texel reaches. */
static void blur_bands(double alpha, const double *power, double *band)
{
    const double window = fmax(0.01, 0.1 * alpha);
    for (int l = 0; l < LOBE_ENV_BANDS; l++)
        band[l] = (2 * l + 1) / (4 * LOBE_PI) * sqrt(power[l]) * exp(-0.5 * window * window * l * l);
}

/* Elliptical polar points in the plane of a stereographic projection from the lobe's middle: narrow across the plane of
 * incidence where the response is. */
static void place_points(lobe_sphere_norm *s, const double *nodes, int count)
{
    double x_mean = 0, z_mean = 0, node[LOBE_SPHERE_RADII], weight[LOBE_SPHERE_RADII], angle, most, size, squeeze;
    for (int i = 0; i < count; i++) {
        x_mean += nodes[5 * i + 3] * nodes[5 * i];
        z_mean += nodes[5 * i + 3] * nodes[5 * i + 2];
    }
    angle = 0.5 * (atan2(x_mean, z_mean) - acos(s->n_dot_v)); /* half way to the mirror direction */
    size = fmax(0.02, 0.5 * s->alpha);
    squeeze = fmin(1, fmax(0.3, s->n_dot_v));
    most = asinh(12 / size);
    lobe_gauss(LOBE_SPHERE_RADII, node, weight);
    for (int i = 0; i < LOBE_SPHERE_RADII; i++)
        for (int j = 0; j < LOBE_SPHERE_TURNS; j++) {
            const double turn = LOBE_PI * (j + 0.5) / LOBE_SPHERE_TURNS, radius = size * sinh(most * node[i]);
            const double x = radius * cos(turn), y = squeeze * radius * sin(turn), r2 = x * x + y * y;
            const double u = 2 * x / (1 + r2), up = (1 - r2) / (1 + r2), jacobian = 2 / (1 + r2);
            const double area =
                2 * LOBE_PI / LOBE_SPHERE_TURNS * squeeze * radius * size * cosh(most * node[i]) * most * weight[i];
            double *p = s->at[i * LOBE_SPHERE_TURNS + j];
            p[0] = u * cos(angle) + up * sin(angle);
            p[1] = 2 * y / (1 + r2);
            p[2] = up * cos(angle) - u * sin(angle);
            s->root_weight[i * LOBE_SPHERE_TURNS + j] = sqrt(area) * jacobian;
        }
}

/* A lobe, by a quadrature of it, under several blurs: out[blur * stride + point]. */
static void blur_nodes(const lobe_sphere_norm *s, const double *nodes, int count, double band[][LOBE_ENV_BANDS],
                       int blurs, double *out)
{
    double table[(FINE + 2) * MOST];
    for (int i = 0; i < FINE; i++) {
        const double chord = chord_of(i, FINE);
        for (int e = 0; e < blurs; e++)
            table[(1 + i) * blurs + e] = legendre_sum(band[e], 1 - 0.5 * chord * chord);
    }
    for (int e = 0; e < blurs; e++)
        lobe_spline_prepare(table + e, FINE, blurs, 1);
    for (int j = 0; j < POINTS; j++) {
        const double *p = s->at[j];
        double sum[MOST] = {0};
        for (int i = 0; i < 2 * count; i++) {
            const double *n = nodes + 5 * (i / 2), side = i % 2 ? -1 : 1;
            const double c = p[0] * n[0] + side * p[1] * n[1] + p[2] * n[2];
            const lobe_spline_weights w = lobe_spline_at(FINE, place(sqrt(fmax(0, 2 - 2 * c)), FINE));
            const double *t = table + w.first * blurs;
            for (int e = 0; e < blurs; e++)
                sum[e] += 0.5 * n[3] *
                          (t[e] * w.value[0] + t[blurs + e] * w.value[1] + t[2 * blurs + e] * w.value[2] +
                           t[3 * blurs + e] * w.value[3]);
        }
        for (int e = 0; e < blurs; e++)
            out[e * POINTS + j] = s->root_weight[j] * sum[e];
    }
}

/* Kernels of all widths under the blur. */
static void blur_kernels(lobe_sphere_norm *s, const lobe_sphere_kernels *kernels, const double *band)
{
    for (int i = 0; i < CHORDS; i++) {
        const double chord = chord_of(i, CHORDS), c = 1 - 0.5 * chord * chord;
        double *row = s->blurred + (1 + i) * (WIDTHS + 2) + 1, p0 = 1, p1 = c;
        memset(row, 0, sizeof *row * WIDTHS);
        for (int l = 0; l < LOBE_ENV_BANDS; l++) {
            const double p2 = ((2 * l + 3) * c * p1 - (l + 1) * p0) / (l + 2), part = band[l] * p0;
            for (int k = 0; k < WIDTHS; k++)
                row[k] += part * kernels->factor[k][l];
            p0 = p1;
            p1 = p2;
        }
        lobe_spline_prepare(row - 1, WIDTHS, 1, 0);
    }
    for (int k = 0; k < WIDTHS + 2; k++)
        lobe_spline_prepare(s->blurred + k, CHORDS, WIDTHS + 2, 1);
}

/* The mean over environments of power / (energy of the response under it). */
static void mean_power(const lobe_sphere_norm *s, const lobe_env_spectrum *spectra, int spectrum_count,
                       const double *nodes, int count, double *power)
{
    double band[MOST][LOBE_ENV_BANDS], value[MOST * POINTS];
    memset(power, 0, sizeof *power * LOBE_ENV_BANDS);
    for (int e = 0; e < spectrum_count; e++)
        blur_bands(s->alpha, spectra[e].power, band[e]);
    blur_nodes(s, nodes, count, band, spectrum_count, value);
    for (int e = 0; e < spectrum_count; e++) {
        double energy = 0;
        for (int j = 0; j < POINTS; j++)
            energy += value[e * POINTS + j] * value[e * POINTS + j];
        for (int l = 0; l < LOBE_ENV_BANDS; l++)
            power[l] += spectra[e].power[l] / energy / spectrum_count;
    }
}

/* The response itself at the points, and the factor that makes its square integral 1. */
static void add_shape(lobe_sphere_norm *s, double albedo)
{
    double energy = 0, *out = s->target + POINTS;
    for (int j = 0; j < POINTS; j++) {
        out[j] = s->root_weight[j] * lobe_response(s->alpha, s->n_dot_v, s->at[j]) / albedo;
        energy += out[j] * out[j];
    }
    s->shape = sqrt(1 / energy);
    for (int j = 0; j < POINTS; j++)
        out[j] *= s->shape;
}

lobe_sphere_norm *lobe_sphere_norm_new(double alpha, double n_dot_v, const lobe_sphere_kernels *kernels,
                                       const lobe_env_spectrum *spectra, int spectrum_count)
{
    lobe_sphere_norm *s = calloc(1, sizeof *s);
    double *nodes = malloc(sizeof *nodes * 5 * ORDER * ORDER), power[LOBE_ENV_BANDS], albedo = 0;
    int count;
    if (!s || !nodes) {
        free(s);
        free(nodes);
        return NULL;
    }
    s->alpha = alpha;
    s->n_dot_v = n_dot_v;
    count = lobe_visible_nodes(alpha, n_dot_v, ORDER, nodes);
    for (int i = 0; i < count; i++)
        albedo += nodes[5 * i + 3];
    for (int i = 0; i < count; i++)
        nodes[5 * i + 3] /= albedo;
    place_points(s, nodes, count);
    mean_power(s, spectra, spectrum_count, nodes, count, power);
    blur_bands(alpha, power, s->band);
    blur_nodes(s, nodes, count, &s->band, 1, s->target);
    blur_kernels(s, kernels, s->band);
    add_shape(s, albedo);
    free(nodes);
    return s;
}

void lobe_sphere_norm_free(lobe_sphere_norm *norm) { free(norm); }

void lobe_sphere_norm_nodes(const lobe_sphere_norm *norm, const double *nodes, int count, double *out)
{
    double band[1][LOBE_ENV_BANDS];
    memcpy(band[0], norm->band, sizeof band[0]);
    blur_nodes(norm, nodes, count, band, 1, out);
}

const double *lobe_sphere_norm_target(const lobe_sphere_norm *norm) { return norm->target; }

void lobe_sphere_norm_tap(const lobe_sphere_norm *norm, double angle, double t, double *out, double *by_angle,
                          double *by_log_t)
{
    const double scale = (WIDTHS - 1) / log(T_HI / T_LO), stretch = (CHORDS - 1) / asinh(2 / CHORD);
    const lobe_spline_weights across = lobe_spline_at(WIDTHS, log(t / T_LO) * scale);
    const double k = 0.5 / (t * t), factor = norm->shape * lobe_prefilter_factor(t);
    const double growth = log(lobe_prefilter_factor(t * 1.001) / lobe_prefilter_factor(t / 1.001)) / (2 * log(1.001));
    const double x = -sin(angle), z = cos(angle);
    for (int j = 0; j < POINTS; j++) {
        const double *p = norm->at[j], weight = norm->root_weight[j];
        const double c = p[0] * x + p[2] * z, turn = -p[0] * z + p[2] * x; /* turn = dc / d angle */
        const double chord = sqrt(fmax(1e-14, 2 - 2 * c)), root = sqrt(chord * chord + CHORD * CHORD);
        const double bend = 1 + k * (1 - c), shape = c > 0 ? weight * factor / (bend * bend) : 0;
        const lobe_spline_weights along = lobe_spline_at(CHORDS, place(chord, CHORDS));
        double value = 0, slope = 0, wider = 0;
        for (int a = 0; a < 4; a++) {
            const double *row = norm->blurred + (along.first + a) * (WIDTHS + 2) + across.first;
            const double v = row[0] * across.value[0] + row[1] * across.value[1] + row[2] * across.value[2] +
                             row[3] * across.value[3];
            value += along.value[a] * v;
            slope += along.slope[a] * v;
            wider += along.value[a] * (row[0] * across.slope[0] + row[1] * across.slope[1] + row[2] * across.slope[2] +
                                       row[3] * across.slope[3]);
        }
        out[j] = weight * value;
        out[j + POINTS] = shape * c;
        if (by_angle) {
            by_angle[j] = -weight * slope * stretch / (root * chord) * turn;
            by_log_t[j] = weight * wider * scale;
            by_angle[j + POINTS] = shape * (1 + 2 * k * c / bend) * turn;
            by_log_t[j + POINTS] = shape * c * (growth + 4 * k * (1 - c) / bend);
        }
    }
}
